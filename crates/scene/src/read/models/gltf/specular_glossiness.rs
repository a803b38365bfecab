//! `KHR_materials_pbrSpecularGlossiness`, as the model of metalness and roughness has it: a dielectric of that
//! reflectance at normal incidence, c_diff = diffuse · (1 − F), roughness = 1 − glossiness.

use super::extensions::Specular;
use super::json::{Material, Pbr};
use super::pbr::PbrMaterial;
use crate::Texture;

/// What a dielectric of the index 1.5 reflects at normal incidence, by which colours of reflectance are factors.
const F0: f64 = 0.04;

/// Gives a material of the older model the numbers of the newer one.
pub(super) fn convert(material: &mut Material) {
    let Some(old) = &mut material.extensions.specular_glossiness else { return };
    material.pbr_metallic_roughness = Pbr {
        base_color_factor: old.diffuse_factor,
        base_color_texture: old.diffuse_texture.take(),
        metallic_factor: 0.0,
        roughness_factor: 1.0 - old.glossiness_factor,
        metallic_roughness_texture: None,
    };
    material.extensions.ior.ior = 1.5;
    material.extensions.specular = Specular {
        specular_color_factor: old.specular_factor.map(|factor| factor / F0),
        ..Specular::default()
    };
}

/// Multiplies reflectance and glossiness by the means of their texture.
pub(super) fn apply_mean(pbr: &mut PbrMaterial, picture: &Texture) {
    let count = (picture.rgba.len() / 4) as f64;
    let mut sums = [0.0; 4];
    for texel in picture.rgba.chunks_exact(4) {
        let [r, g, b, a] = [0, 1, 2, 3].map(|channel| f32::from(texel[channel]) / 255.0);
        let linear = [r, g, b].map(|code| f64::from(glanz_color::srgb_decode(code)));
        (0..3).for_each(|channel| sums[channel] += linear[channel]);
        sums[3] += f64::from(a);
    }
    let [r, g, b, gloss] = sums.map(|sum| sum / count);
    pbr.f0 = [pbr.f0[0] * r, pbr.f0[1] * g, pbr.f0[2] * b];
    pbr.roughness = 1.0 - (1.0 - pbr.roughness) * gloss;
}
