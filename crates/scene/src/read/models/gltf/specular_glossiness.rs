//! `KHR_materials_pbrSpecularGlossiness`, as the model of metalness and roughness has it: a dielectric of that
//! reflectance at normal incidence, c_diff = diffuse · (1 − F), roughness = 1 − glossiness.

use super::extensions::Specular;
use super::json::{Material, Pbr};

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
