//! The object's material as programs of courses have it.

use glanz_bsdf::LightTerm;
use glanz_scene::{Lobe, Material};
use glanz_shader::Role;

use crate::prepare::color::in_rgb;
use crate::prepare::{Prepared, PreparedMaterial, PreparedObject};

/// What a role of a material is.
pub(super) fn of(role: Role, name: &str, prepared: &Prepared, object: &PreparedObject) -> Option<Vec<f64>> {
    let material = prepared.source.colors.materials.get(object.material)?;
    let opaque = |[r, g, b]: [f64; 3]| vec![r, g, b, f64::from(material.opacity)];
    Some(match role {
        Role::MaterialAmbient => opaque(sum(material, LightTerm::Ambient)),
        Role::MaterialDiffuse => opaque(sum(material, LightTerm::Diffuse)),
        Role::MaterialSpecular => opaque(sum(material, LightTerm::Specular)),
        Role::MaterialEmission => opaque(sum(material, LightTerm::Emission)),
        Role::MaterialShininess => vec![shininess(material)],
        Role::MaterialParameter => vec![parameter(material, name)?],
        Role::MaterialRoughness => vec![(2.0 / (shininess(material) + 2.0)).sqrt().sqrt()],
        Role::MaterialMetallic => {
            let matte = sum(material, LightTerm::Diffuse).iter().any(|value| *value > 0.0);
            vec![if matte { 0.0 } else { 1.0 }]
        }
        _ => return None,
    })
}

fn of_term(material: &Material, term: LightTerm) -> impl Iterator<Item = &Lobe> {
    material.lobes.iter().filter(move |lobe| lobe.shape.info().term == term)
}

/// The colours of the lobes of a term, added up.
fn sum(material: &Material, term: LightTerm) -> [f64; 3] {
    of_term(material, term).fold([0.0; 3], |sum, lobe| {
        let own = match term {
            LightTerm::Emission => in_rgb::emitted(&lobe.tint),
            _ => in_rgb::tint(&lobe.tint),
        };
        core::array::from_fn(|c| sum[c] + own[c])
    })
}

/// A parameter of the first model that has one of this name, highlights first.
fn parameter(material: &Material, name: &str) -> Option<f64> {
    let name = name.rsplit('.').next().unwrap_or(name);
    let of = |term| of_term(material, term).find_map(|lobe| lobe.shape.get(name));
    of(LightTerm::Specular).or_else(|| of(LightTerm::Diffuse))
}

/// The exponent of the first highlight; that of a lobe of the width alpha is 2/alpha² − 2.
fn shininess(material: &Material) -> f64 {
    let first = of_term(material, LightTerm::Specular).next();
    let Some(shape) = first.map(|lobe| &lobe.shape) else { return 1.0 };
    let of_width = || shape.get("alpha").map(|alpha| (2.0 / (alpha * alpha) - 2.0).max(0.0));
    shape.get("shininess").or_else(of_width).unwrap_or(1.0)
}

/// The material's texture that a sampler's name says.
pub(super) fn map(name: &str, material: &PreparedMaterial) -> Option<usize> {
    let name = name.to_ascii_lowercase();
    let says = |words: &[&str]| words.iter().any(|word| name.contains(word));
    let texture_use = if says(&["normal", "bump"]) {
        &material.normal_map
    } else if says(&["emissi", "emission", "glow"]) {
        &material.emission_map
    } else if says(&["metal", "rough"]) {
        &material.metal_rough_map
    } else if says(&["specular", "shadow", "depth", "noise", "height", "sky", "cube", "environment"]) {
        return None;
    } else {
        &material.base_color
    };
    texture_use.as_ref().map(|own| own.texture)
}
