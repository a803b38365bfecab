//! Materials: their lobes, and their rows of the tint table.

use glanz_bsdf::{LayerWeight, LightTerm, Shape};
use glanz_scene::{AlphaMode, ChannelUse, Metalness, TextureUse};

use super::{LobeIntegrals, TintCoordinate, TintSeries};

/// A lobe that answers to lights with a direction.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectLobe {
    /// Its shape.
    pub shape: Shape,
    /// Diffuse or specular.
    pub term: LightTerm,
    /// Whether base colour texture and vertex colours multiply it.
    pub textured: bool,
    /// On what its tint depends.
    pub coordinate: TintCoordinate,
    /// What lies over it.
    pub layers: Vec<LayerWeight>,
    /// Which part of the surface it belongs to.
    pub metalness: Metalness,
    /// Factors that channels of pictures say.
    pub masks: Vec<PreparedMask>,
    /// What says how rough it is.
    pub roughness: LobeRoughness,
}

/// A factor that a channel of a picture says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedMask {
    /// The channel's number among the material's.
    pub channel: usize,
    /// The factor where the channel is 0.
    pub from: f64,
    /// The factor where it is 1.
    pub to: f64,
}

/// The means of textures, which count where a place of the surface has none of its own: at vertices and facets, and for
/// light from environments and areas.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureMeans {
    /// Of [`PreparedMaterial::metal_rough_map`]: the factor of roughness, and how metallic the surface is.
    pub metal_rough: [f32; 2],
    /// Of [`PreparedMaterial::channels`].
    pub channels: Vec<f32>,
}

impl Default for TextureMeans {
    fn default() -> Self {
        Self { metal_rough: [1.0; 2], channels: Vec::new() }
    }
}

/// What says how rough a lobe is, beside its own width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum LobeRoughness {
    /// [`PreparedMaterial::metal_rough_map`], if there is one.
    #[default]
    Material,
    /// Nothing.
    Uniform,
    /// The channel of this number among the material's.
    Channel(usize),
}

/// A material with its rows of the tint table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PreparedMaterial {
    /// Lobes for lights with a direction.
    pub lobes: Vec<DirectLobe>,
    /// The tint table: entry `light · lobes.len() + lobe`, one value per channel.
    pub tints: Vec<[f32; 3]>,
    /// What the lobes make of areas and environments; empty where the scene has none.
    pub integrals: Vec<LobeIntegrals>,
    /// The entries of curved lobes, with the same numbers; empty if there are none.
    pub series: Vec<TintSeries>,
    /// Ambient light from everywhere times the ambient tints, and light of its own: what textures
    /// multiply, then the ambient light that they do not.
    pub ambient: [[f32; 3]; 2],
    /// Ambient light that a spot sends into its cone, per light, textured and not. Empty where no
    /// spot sends any.
    pub spot_ambient: Vec<[[f32; 3]; 2]>,
    /// Light of its own.
    pub emission: [f32; 3],
    /// How textures and vertex colours mix the table, where they do more than multiply channels.
    pub mix: Option<Box<MixTints>>,
    /// Whether the normal is turned to the viewer.
    pub two_sided: bool,
    /// Whether back faces are not drawn.
    pub cull_back: bool,
    /// Multiplies textured lobes.
    pub base_color: Option<TextureUse>,
    /// Bends the normal.
    pub normal_map: Option<TextureUse>,
    /// Multiplies the emission.
    pub emission_map: Option<TextureUse>,
    /// Green widens lobes, blue says where metal is.
    pub metal_rough_map: Option<TextureUse>,
    /// The channels of pictures that masks and lobes name, at most [`PreparedMaterial::MOST_CHANNELS`].
    pub channels: Vec<ChannelUse>,
    /// What its textures say on the whole.
    pub means: TextureMeans,
    /// How much of ambient light and of environments arrives.
    pub occlusion: Option<PreparedMask>,
    /// Which part of the surface ambient light finds its ambient tints on.
    pub ambient_metalness: Metalness,
    /// Sine and cosine of the angle from the tangent to the x axis of lobes that know one.
    pub aniso: [f64; 2],
    /// Whether any lobe asks where the tangent is.
    pub anisotropic: bool,
    /// Whether any lobe answers to light on the other side.
    pub transmits: bool,
    /// Its transmittance, per channel over the cosine of the line of sight.
    pub transmittance: Option<TintSeries>,
    /// Opacity.
    pub alpha: f32,
    /// What alpha means.
    pub alpha_mode: AlphaMode,
}

/// The table for texels that mix three spectra: for each entry that textures multiply, what its lobe
/// gives through each of them. Their sum is the entry itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MixTints {
    /// As [`PreparedMaterial::tints`].
    pub tints: Vec<[[f32; 3]; 3]>,
    /// As the first of [`PreparedMaterial::ambient`].
    pub ambient: [[f32; 3]; 3],
    /// As the first of each of [`PreparedMaterial::spot_ambient`], and empty where that is.
    pub spot_ambient: Vec<[[f32; 3]; 3]>,
    /// As [`PreparedMaterial::emission`].
    pub emission: [[f32; 3]; 3],
}

impl PreparedMaterial {
    /// The most channels of pictures beside the maps that all of a material has.
    pub const MOST_CHANNELS: usize = ChannelUse::MOST;

    /// All uses of textures.
    pub fn textures(&self) -> impl Iterator<Item = TextureUse> {
        let maps = [self.base_color, self.normal_map, self.emission_map, self.metal_rough_map];
        maps.into_iter().flatten().chain(self.channels.iter().map(|channel| channel.map))
    }
}

impl DirectLobe {
    /// A bare lobe.
    pub fn new(shape: Shape) -> Self {
        let (term, coordinate) = (shape.info().term, TintCoordinate::None);
        Self {
            shape,
            term,
            textured: false,
            coordinate,
            layers: Vec::new(),
            metalness: Metalness::Any,
            masks: Vec::new(),
            roughness: LobeRoughness::Material,
        }
    }

    /// Whether it depends on where the tangent is: by its shape, or by a layer.
    pub fn is_anisotropic(&self) -> bool {
        self.shape.is_anisotropic() || self.layers.iter().any(LayerWeight::is_anisotropic)
    }
}
