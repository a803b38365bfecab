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
    /// The model of the highlight: `phong`, `blinn-phong`, …; or `lambert` for none.
    pub model: String,
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
        }
    }
}

impl ClassicMaterial {
    /// The lobes of the block; those whose tint is black are left out.
    pub fn build(&self, name: impl Into<String>) -> Result<Material, ParamError> {
        let highlight = self.highlight()?;
        let has_highlight = highlight.info().term == LightTerm::Specular;
        let specular = if has_highlight { self.specular.clone() } else { Tint::BLACK };
        let plain = |shape: &str| Shape::named(shape, &[]);
        let terms = [
            (plain("ambient")?, self.ambient.clone(), true),
            (plain("lambert")?, self.diffuse.clone(), true),
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

    /// The shape of the highlight. `lambert` takes no exponent, the others do.
    fn highlight(&self) -> Result<Shape, ParamError> {
        let info = glanz_bsdf::models::info_named(&self.model)?;
        match info.params.iter().any(|param| param.name == "shininess") {
            true => Shape::named(&self.model, &[("shininess", self.shininess)]),
            false => Shape::named(&self.model, &[]),
        }
    }
}
