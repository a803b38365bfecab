//! The extensions of materials that are read, as the file has them. One that a material does not have is as if it
//! had it with the values that the extension gives for nothing: without effect.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::json::TextureInfo;

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct MaterialExtensions {
    #[serde(rename = "KHR_materials_unlit")]
    pub unlit: Option<IgnoredAny>,
    #[serde(rename = "KHR_materials_emissive_strength")]
    pub emissive: EmissiveStrength,
    #[serde(rename = "KHR_materials_ior")]
    pub ior: IndexOfRefraction,
    #[serde(rename = "KHR_materials_specular")]
    pub specular: Specular,
    #[serde(rename = "KHR_materials_clearcoat")]
    pub clearcoat: Clearcoat,
    #[serde(rename = "KHR_materials_sheen")]
    pub sheen: Sheen,
    #[serde(rename = "KHR_materials_transmission")]
    pub transmission: Transmission,
    #[serde(rename = "KHR_materials_volume")]
    pub volume: Volume,
    #[serde(rename = "KHR_materials_anisotropy")]
    pub anisotropy: Anisotropy,
    #[serde(rename = "KHR_materials_iridescence")]
    pub iridescence: Iridescence,
    #[serde(rename = "KHR_materials_pbrSpecularGlossiness")]
    pub specular_glossiness: Option<SpecularGlossiness>,
}

/// An older model of materials, in place of metalness and roughness.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct SpecularGlossiness {
    pub diffuse_factor: [f64; 4],
    pub diffuse_texture: Option<TextureInfo>,
    /// Reflectance at normal incidence.
    pub specular_factor: [f64; 3],
    /// 1 less the roughness.
    pub glossiness_factor: f64,
    /// Factors of both, in its colours and in its alpha.
    pub specular_glossiness_texture: Option<TextureInfo>,
}

impl Default for SpecularGlossiness {
    fn default() -> Self {
        Self {
            diffuse_factor: [1.0; 4],
            diffuse_texture: None,
            specular_factor: [1.0; 3],
            glossiness_factor: 1.0,
            specular_glossiness_texture: None,
        }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct EmissiveStrength {
    pub emissive_strength: f64,
}

impl Default for EmissiveStrength {
    fn default() -> Self {
        Self { emissive_strength: 1.0 }
    }
}

#[derive(Deserialize)]
#[serde(default)]
pub(super) struct IndexOfRefraction {
    pub ior: f64,
}

impl Default for IndexOfRefraction {
    fn default() -> Self {
        Self { ior: 1.5 }
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Specular {
    pub specular_factor: f64,
    pub specular_texture: Option<TextureInfo>,
    pub specular_color_factor: [f64; 3],
    pub specular_color_texture: Option<TextureInfo>,
}

impl Default for Specular {
    fn default() -> Self {
        let (specular_factor, specular_color_factor) = (1.0, [1.0; 3]);
        Self { specular_factor, specular_texture: None, specular_color_factor, specular_color_texture: None }
    }
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Clearcoat {
    pub clearcoat_factor: f64,
    pub clearcoat_texture: Option<TextureInfo>,
    pub clearcoat_roughness_factor: f64,
    pub clearcoat_roughness_texture: Option<TextureInfo>,
    pub clearcoat_normal_texture: Option<IgnoredAny>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Sheen {
    pub sheen_color_factor: [f64; 3],
    pub sheen_color_texture: Option<TextureInfo>,
    pub sheen_roughness_factor: f64,
    pub sheen_roughness_texture: Option<TextureInfo>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Transmission {
    pub transmission_factor: f64,
    pub transmission_texture: Option<TextureInfo>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Volume {
    /// In metres.
    pub thickness_factor: f64,
    pub thickness_texture: Option<TextureInfo>,
    /// In metres; without it nothing is absorbed.
    pub attenuation_distance: Option<f64>,
    pub attenuation_color: [f64; 3],
}

impl Default for Volume {
    fn default() -> Self {
        Self {
            thickness_factor: 0.0,
            thickness_texture: None,
            attenuation_distance: None,
            attenuation_color: [1.0; 3],
        }
    }
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Anisotropy {
    pub anisotropy_strength: f64,
    /// In radians.
    pub anisotropy_rotation: f64,
    pub anisotropy_texture: Option<TextureInfo>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Iridescence {
    pub iridescence_factor: f64,
    pub iridescence_texture: Option<TextureInfo>,
    pub iridescence_ior: f64,
    /// In nm, where the texture is 0.
    pub iridescence_thickness_minimum: f64,
    /// In nm, where the texture is 1, and without one.
    pub iridescence_thickness_maximum: f64,
    pub iridescence_thickness_texture: Option<TextureInfo>,
}

impl Default for Iridescence {
    fn default() -> Self {
        Self {
            iridescence_factor: 0.0,
            iridescence_texture: None,
            iridescence_ior: 1.3,
            iridescence_thickness_minimum: 100.0,
            iridescence_thickness_maximum: 400.0,
            iridescence_thickness_texture: None,
        }
    }
}
