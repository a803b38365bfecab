//! The classic block of coefficients: ambient, diffuse, specular, shininess and emission.

use glanz_bsdf::{LightTerm, ParamError, Shape};
use serde::{Deserialize, Serialize};

use crate::{Lobe, Material, Tint};

/// The classic block of coefficients, from which the lobes follow.
///
/// ```
/// use glanz_color::Rgb;
/// use glanz_scene::ClassicMaterial;
///
/// let red = ClassicMaterial {
///     diffuse: Rgb([0.7, 0.1, 0.1]).into(),
///     specular: Rgb::gray(0.4).into(),
///     shininess: 50.0,
///     ..ClassicMaterial::default()
/// };
/// let red = red.build("red")?;
/// assert_eq!(red.lobes.len(), 2, "the black ambient and emission terms are left out");
/// assert_eq!(red.lobes[1].shape.info().name, "phong");
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClassicMaterial {
    /// Tint of the ambient lobe.
    pub ambient: Tint,
    /// Tint of the Lambert lobe.
    pub diffuse: Tint,
    /// Tint of the highlight.
    pub specular: Tint,
    /// Light of its own.
    pub emission: Tint,
    /// Exponent of the highlight.
    pub shininess: f64,
    /// The model of the highlight: `phong`, `blinn-phong`, …; a matte one such as `lambert` is that of the diffuse
    /// term, and there is no highlight.
    pub model: String,
    /// Parameters of the model beside the exponent, such as `alpha`, by name; those that are missing have their defaults.
    pub parameters: Vec<(String, f64)>,
}

impl Default for ClassicMaterial {
    fn default() -> Self {
        Self {
            ambient: Tint::BLACK,
            diffuse: Tint::BLACK,
            specular: Tint::BLACK,
            emission: Tint::BLACK,
            shininess: 32.0,
            model: "phong".to_owned(),
            parameters: Vec::new(),
        }
    }
}

impl ClassicMaterial {
    /// The lobes of the block; those whose tint is black are left out.
    pub fn build(&self, name: impl Into<String>) -> Result<Material, ParamError> {
        let shape = self.shape()?;
        let plain = |shape: &str| Shape::named(shape, &[]);
        let (matte, highlight, specular) = match shape.info().term {
            LightTerm::Specular => (plain("lambert")?, shape, self.specular.clone()),
            _ => (shape.clone(), shape, Tint::BLACK),
        };
        let terms = [
            (plain("ambient")?, self.ambient.clone(), true),
            (matte, self.diffuse.clone(), true),
            (highlight, specular, false),
            (plain("emission")?, self.emission.clone(), false),
        ];
        let lobes = terms
            .into_iter()
            .filter(|(_, tint, _)| !tint.is_black())
            .map(|(shape, tint, textured)| Lobe { textured, ..Lobe::new(shape, tint) })
            .collect();
        Ok(Material::of_lobes(name, lobes))
    }

    /// The shape that the model is. Models without an exponent do not take it.
    fn shape(&self) -> Result<Shape, ParamError> {
        let info = glanz_bsdf::models::info_named(&self.model)?;
        let mut set: Vec<(&str, f64)> =
            self.parameters.iter().map(|(name, value)| (&**name, *value)).collect();
        let exponent = info.params.iter().any(|param| param.name == "shininess");
        set.extend(exponent.then_some(("shininess", self.shininess)));
        Shape::named(&self.model, &set)
    }
}
