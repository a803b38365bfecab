//! What surfaces do with light.

use glanz_color::Rgb;
use serde::{Deserialize, Serialize};

use crate::{ClassicMaterial, Lobe, Mask, Transmittance};

/// A texture and how a material applies it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TextureUse {
    /// Index in `Scene::textures`.
    pub texture: usize,
    /// Affine map of the texture coordinates, rows of a 2×3 matrix.
    pub transform: [[f32; 3]; 2],
    /// Factor; for normal maps the scale of x and y.
    pub scale: f32,
    /// Whether it lies by the mesh's second set of texture coordinates.
    #[serde(default)]
    pub second_uvs: bool,
}

impl TextureUse {
    /// The texture as it is.
    pub const fn plain(texture: usize) -> Self {
        Self { texture, transform: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], scale: 1.0, second_uvs: false }
    }
}

/// What alpha means.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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
///
/// ```
/// use glanz_bsdf::Shape;
/// use glanz_scene::{Lobe, Material};
///
/// let paint = Lobe::new(Shape::named("lambert", &[])?, [0.7, 0.1, 0.1]);
/// let gloss = Lobe::new(Shape::named("ggx", &[("alpha", 0.1)])?, [0.04; 3]);
/// let mut red = Material::of_lobes("red", vec![paint, gloss]);
/// red.set("alpha", 0.2)?;
/// red.opacity = 0.5;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
    /// glTF metallic-roughness map: green scales roughness, blue is metalness.
    pub metal_rough_map: Option<TextureUse>,
    /// How much of ambient light and of surroundings arrives.
    #[serde(default)]
    pub occlusion: Option<Mask>,
    /// The angle from the mesh's tangent to the x axis of lobes that know one, in radians.
    pub aniso: f64,
    /// How much of the light from behind reaches the viewer, beside what `opacity` leaves open.
    pub transmittance: Option<Transmittance>,
    /// Opacity, times the texture's and the vertex colour's.
    pub opacity: f32,
    /// What the opacity, times the texture's alpha, does.
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
            occlusion: None,
            aniso: 0.0,
            transmittance: None,
            opacity: 1.0,
            alpha_mode: AlphaMode::Opaque,
            cull_back: false,
        }
    }

    /// All uses of textures, those of lobes too.
    pub fn textures(&self) -> impl Iterator<Item = TextureUse> {
        let maps = [self.base_color, self.normal_map, self.emission_map, self.metal_rough_map];
        let channels = self.occlusion.iter().map(|mask| mask.of);
        let channels = channels.chain(self.lobes.iter().flat_map(Lobe::channels));
        maps.into_iter().flatten().chain(channels.map(|channel| channel.map))
    }

    /// Changes all uses of textures, those of lobes too.
    pub fn change_textures(&mut self, change: impl FnMut(&mut TextureUse)) {
        let maps =
            [&mut self.base_color, &mut self.normal_map, &mut self.emission_map, &mut self.metal_rough_map];
        let channels = self.occlusion.iter_mut().map(|mask| &mut mask.of.map);
        let channels = channels.chain(self.lobes.iter_mut().flat_map(Lobe::textures_mut));
        maps.into_iter().flatten().chain(channels).for_each(change);
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
