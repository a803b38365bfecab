//! What surfaces do with light.

use std::sync::Arc;

use glanz_bsdf::{LayerWeight, LightTerm, ParamError, Shape};
use glanz_color::Rgb;

use crate::{Absorption, Tint, Transmittance};

/// One term of a material: a shape times a tint.
#[derive(Clone, Debug, PartialEq)]
pub struct Lobe {
    /// The directional part.
    pub shape: Shape,
    /// The coloured part. For an emission lobe: the light sent out.
    pub tint: Tint,
    /// Whether the base colour texture and vertex colours multiply the tint.
    pub textured: bool,
    /// What lies over it.
    pub layers: Vec<LayerWeight>,
    /// What a coat over it absorbs.
    pub absorption: Option<Arc<Absorption>>,
    /// Which part of the surface it belongs to.
    pub metalness: Metalness,
}

impl Lobe {
    /// A bare lobe that textures do not touch.
    pub fn new(shape: Shape, tint: impl Into<Tint>) -> Self {
        let (tint, metalness) = (tint.into(), Metalness::Any);
        Self { shape, tint, textured: false, layers: Vec::new(), absorption: None, metalness }
    }

    /// The same, multiplied by textures and vertex colours.
    pub fn textured(self) -> Self {
        Self { textured: true, ..self }
    }

    /// The same under one more veil.
    pub fn under(mut self, layer: LayerWeight) -> Self {
        self.layers.push(layer);
        self
    }
}

/// Which part of a surface a lobe belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Metalness {
    /// All of it.
    #[default]
    Any,
    /// Metal: the lobe counts `factor · texture`.
    Metal {
        /// How metallic the surface is where the texture is 1, or where there is none.
        factor: f64,
    },
    /// The rest: the lobe counts `1 − factor · texture`.
    Dielectric {
        /// How metallic the surface is where the texture is 1, or where there is none.
        factor: f64,
    },
}

/// A texture and how a material applies it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureUse {
    /// Index in `Scene::textures`.
    pub texture: usize,
    /// Affine map of the texture coordinates, rows of a 2×3 matrix.
    pub transform: [[f32; 3]; 2],
    /// Factor; for normal maps the scale of x and y.
    pub scale: f32,
}

impl TextureUse {
    /// The texture as it is.
    pub const fn plain(texture: usize) -> Self {
        Self { texture, transform: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], scale: 1.0 }
    }
}

/// What alpha means.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AlphaMode {
    /// Nothing.
    #[default]
    Opaque,
    /// Below the cutoff there is no surface.
    Mask {
        /// The least alpha that is drawn.
        cutoff: f32,
    },
    /// The surface lets what is behind it through.
    Blend,
}

/// A sum of lobes, with what textures change of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name; may be empty.
    pub name: String,
    /// The terms.
    pub lobes: Vec<Lobe>,
    /// Whether the normal is turned to the viewer. If not, back faces get ambient light only.
    pub two_sided: bool,
    /// Multiplies the tint of the `textured` lobes; its alpha is the surface's.
    pub base_color: Option<TextureUse>,
    /// Tangent-space normals, x to the right of the texture, y up.
    pub normal_map: Option<TextureUse>,
    /// Multiplies the emission lobes.
    pub emission_map: Option<TextureUse>,
    /// Green widens or narrows lobes, blue says where metal is, as glTF has it.
    pub metal_rough_map: Option<TextureUse>,
    /// The angle from the mesh's tangent to the x axis of lobes that know one, in radians.
    pub aniso: f64,
    /// What is seen through the surface, beside what `alpha` leaves open.
    pub transmittance: Option<Transmittance>,
    /// Opacity, times the texture's and the vertex colour's.
    pub alpha: f32,
    /// What alpha means.
    pub alpha_mode: AlphaMode,
    /// Whether back faces are not drawn at all.
    pub cull_back: bool,
}

impl Material {
    /// A material of these lobes, opaque, two-sided, untextured.
    pub fn of_lobes(name: impl Into<String>, lobes: Vec<Lobe>) -> Self {
        Self {
            name: name.into(),
            lobes,
            two_sided: true,
            base_color: None,
            normal_map: None,
            emission_map: None,
            metal_rough_map: None,
            aniso: 0.0,
            transmittance: None,
            alpha: 1.0,
            alpha_mode: AlphaMode::Opaque,
            cull_back: false,
        }
    }

    /// The material of objects that name none: light grey, with a weak highlight.
    pub fn default_gray() -> Self {
        ClassicMaterial {
            ambient: Rgb::gray(0.7).into(),
            diffuse: Rgb::gray(0.7).into(),
            specular: Rgb::gray(0.2).into(),
            ..ClassicMaterial::default()
        }
        .build("default")
        .expect("the default model exists")
    }
}

/// The classic block of coefficients, from which the lobes follow.
#[derive(Clone, Debug, PartialEq)]
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
