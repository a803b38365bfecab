//! What a debug view leaves of materials.
//!
//! ```
//! use glanz_render::view::materials::shown_materials;
//! use glanz_render::{DebugView, PrepareOptions, prepare};
//! use glanz_scene::{Material, Mesh, Scene};
//!
//! let scene = Scene::new().with_mesh(Mesh::builtin("cube")?, Material::default_gray());
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! let ambient = shown_materials(&prepared, DebugView::Ambient);
//! assert_eq!(ambient.len(), prepared.materials.len());
//! assert!(ambient[0].tints.iter().all(|tint| *tint == [0.0; 3]), "no lamp adds to it");
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use std::borrow::Cow;

use glanz_bsdf::models::lambert::Lambert;
use glanz_bsdf::{LightTerm, Shape};
use glanz_scene::Metalness;

use super::DebugView;
use crate::prepare::{
    DirectLobe, LobeIntegrals, MixTints, Prepared, PreparedLight, PreparedMaterial, TextureMeans, TintSeries,
};

/// The materials as the chosen view wants them: all terms, or one, or none but a test for light.
pub fn shown_materials(prepared: &Prepared, show: DebugView) -> Cow<'_, [PreparedMaterial]> {
    let term = match show {
        DebugView::Ambient => LightTerm::Ambient,
        DebugView::Diffuse => LightTerm::Diffuse,
        DebugView::Specular => LightTerm::Specular,
        DebugView::Lit => {
            let lights = &prepared.lights;
            return prepared.materials.iter().map(|material| lit_test(material, lights)).collect();
        }
        _ => return Cow::Borrowed(&prepared.materials),
    };
    prepared.materials.iter().map(|material| one_term(material, term)).collect()
}

fn one_term(material: &PreparedMaterial, term: LightTerm) -> PreparedMaterial {
    let mut material = material.clone();
    let lobes = material.lobes.len().max(1);
    let mixes = material.mix.is_some();
    let left_out = |i: usize| material.lobes[i % lobes].term != term;
    let mut mix = material.mix.take().unwrap_or_default();
    for i in (0..material.tints.len()).filter(|i| left_out(*i)) {
        material.tints[i] = [0.0; 3];
        mix.tints.get_mut(i).into_iter().for_each(|tint| *tint = Default::default());
        material.series.get_mut(i).into_iter().for_each(|series| *series = TintSeries::default());
    }
    if term != LightTerm::Ambient {
        material.ambient = Default::default();
        material.spot_ambient.clear();
        material.emission = [0.0; 3];
        *mix = MixTints { tints: mix.tints, ..MixTints::default() };
    }
    material.mix = mixes.then_some(mix);
    material
}

/// A material whose value is above zero exactly where some light reaches the front of the surface.
fn lit_test(material: &PreparedMaterial, lights: &[PreparedLight]) -> PreparedMaterial {
    PreparedMaterial {
        lobes: vec![DirectLobe::new(Shape::Lambert(Lambert))],
        tints: vec![[1.0; 3]; lights.iter().map(|light| light.shape.rows()).sum()],
        integrals: vec![LobeIntegrals::of_cosine()],
        anisotropic: false,
        transmits: false,
        metal_rough_map: None,
        channels: Vec::new(),
        means: TextureMeans::default(),
        occlusion: None,
        ambient_metalness: Metalness::Any,
        transmittance: None,
        series: Vec::new(),
        ambient: Default::default(),
        spot_ambient: Vec::new(),
        emission: [0.0; 3],
        mix: None,
        base_color: None,
        emission_map: None,
        ..material.clone()
    }
}
