//! Materials: their lobes, and their rows of the tint table.

use glanz_bsdf::{LayerWeight, LightTerm, Shape};
use glanz_scene::{AlphaMode, Metalness, TextureUse};

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
    /// As the first of each of [`PreparedMaterial::spot_ambient`].
    pub spot_ambient: Vec<[[f32; 3]; 3]>,
    /// As [`PreparedMaterial::emission`].
    pub emission: [[f32; 3]; 3],
}

impl DirectLobe {
    /// A bare lobe.
    pub fn new(shape: Shape) -> Self {
        let (term, coordinate) = (shape.info().term, TintCoordinate::None);
        Self { shape, term, textured: false, coordinate, layers: Vec::new(), metalness: Metalness::Any }
    }

    /// Whether it depends on where the tangent is: by its shape, or by a layer.
    pub fn is_anisotropic(&self) -> bool {
        self.shape.is_anisotropic() || self.layers.iter().any(LayerWeight::is_anisotropic)
    }
}
