//! Precomputed integrals of each lobe for area and environment lights: albedo, LTC maps, lookups.

use std::cell::LazyCell;
use std::sync::Arc;

use glanz_bsdf::models::ggx::LEAST_ALPHA;
use glanz_bsdf::{DirectionPair, LayerWeight, LightTerm, Shape, Side};
use glanz_math::PI;

use super::albedo::albedo;
use super::chain::chain;
use super::fit::{Views, is_round};
use crate::parallel;
use crate::prepare::data::{
    AreaIntegral, DirectLobe, EnvironmentMap, LightShape, LobeIntegrals, LobeRoughness, LtcTable,
    PreparedLight, PreparedMaterial,
};

/// Gives all materials the integrals of their lobes; those of `before` are taken over where nothing changed that they
/// depend on. Nothing where all lights are punctual.
pub(crate) fn attach(
    materials: &mut [PreparedMaterial],
    lights: &[PreparedLight],
    before: &[PreparedMaterial],
) {
    if lights.iter().all(|light| light.shape.is_punctual()) {
        return;
    }
    let maps: Vec<&EnvironmentMap> = lights.iter().filter_map(|light| map_of(&light.shape)).collect();
    let areas = lights.iter().any(|light| matches!(light.shape, LightShape::Area { .. }));
    let over = Over { areas, maps: !maps.is_empty() };
    let mut known: Vec<Known> = Vec::new();
    for material in before {
        let lobes = material.lobes.iter().map(|lobe| typical(lobe, material));
        known.extend(lobes.zip(material.integrals.iter().cloned()));
    }
    let wanted: Vec<Vec<DirectLobe>> = materials
        .iter()
        .map(|material| material.lobes.iter().map(|lobe| typical(lobe, material)).collect())
        .collect();
    let mut new: Vec<DirectLobe> = Vec::new();
    for lobe in wanted.iter().flatten() {
        if !new
            .iter()
            .chain(done(&known, over))
            .any(|known| is_alike(known, lobe) && known.layers == lobe.layers)
        {
            new.push(lobe.clone());
        }
    }
    let made = new_integrals(&new, over, &known);
    known.retain(|known| is_done(known, over));
    known.extend(made);
    for (material, lobes) in materials.iter_mut().zip(wanted) {
        material.integrals = lobes.iter().map(|lobe| found(&known, lobe, over)).collect();
    }
    if materials.iter().any(|material| material.integrals.iter().any(|own| own.lookups.is_some())) {
        maps.iter().for_each(|map| map.chain_with(|| chain(map)));
    }
}

fn map_of(shape: &LightShape) -> Option<&EnvironmentMap> {
    match shape {
        LightShape::Environment(environment) => environment.map.as_deref(),
        _ => None,
    }
}

/// Whether all is known of a lobe that the lights ask for.
fn is_done((lobe, integrals): &Known, over: Over) -> bool {
    let has_lookups = !over.maps || !looks_up(lobe) || integrals.lookups.is_some();
    has_lookups && (!over.areas || integrals.area != AreaIntegral::Points || has_grain(lobe))
}

fn done(known: &[Known], over: Over) -> impl Iterator<Item = &DirectLobe> {
    known.iter().filter(move |known| is_done(known, over)).map(|known| &known.0)
}

/// What is known of a lobe, as far as the lights ask for it.
fn found(known: &[Known], lobe: &DirectLobe, over: Over) -> LobeIntegrals {
    let same = |known: &&Known| is_alike(&known.0, lobe) && known.0.layers == lobe.layers;
    let mut own = known.iter().find(same).expect("the integrals of each lobe were made").1.clone();
    own.lookups = own.lookups.filter(|_| over.maps);
    if !over.areas && matches!(own.area, AreaIntegral::Ltc(_)) {
        own.area = AreaIntegral::Points;
    }
    own
}

/// The lobe as rough as it is on the whole, where a texture says how rough it is.
fn typical(lobe: &DirectLobe, material: &PreparedMaterial) -> DirectLobe {
    let factor = match lobe.roughness {
        LobeRoughness::Material => material.means.metal_rough[0],
        LobeRoughness::Uniform => 1.0,
        LobeRoughness::Channel(number) => material.means.channels[number],
    };
    // The width of a lobe is the square of its roughness.
    let shape = widened(&lobe.shape, f64::from(factor * factor));
    DirectLobe { shape, ..lobe.clone() }
}

/// The shape with its widths times a factor, if textures can widen it.
fn widened(shape: &Shape, factor: f64) -> Shape {
    let info = shape.info();
    if factor == 1.0 || !info.takes_roughness_map() {
        return shape.clone();
    }
    let scaled = info.params.iter().zip(shape.params()).map(|(param, value)| {
        let is_width = matches!(param.name, "alpha" | "alpha_y") && value > 0.0;
        (param.name, if is_width { (value * factor).clamp(LEAST_ALPHA, param.max) } else { value })
    });
    let scaled: Vec<_> = scaled.collect();
    Shape::named(info.name, &scaled).expect("widths within their range make a shape")
}

/// What lobes are integrated over.
#[derive(Clone, Copy)]
struct Over {
    areas: bool,
    maps: bool,
}

/// A lobe and its integrals.
type Known = (DirectLobe, LobeIntegrals);

/// Whether two lobes are integrated alike, but for their layers.
fn is_alike(a: &DirectLobe, b: &DirectLobe) -> bool {
    a.shape == b.shape && a.term == b.term
}

/// The integrals of lobes that are not known yet.
fn new_integrals(lobes: &[DirectLobe], over: Over, known: &[Known]) -> Vec<Known> {
    let like = |lobe: &DirectLobe| known.iter().find(|known| is_alike(&known.0, lobe)).map(|known| &known.1);
    // Of each shape once.
    let mut shapes: Vec<&DirectLobe> = Vec::new();
    for lobe in lobes {
        if !shapes.iter().any(|shape| is_alike(shape, lobe)) {
            shapes.push(lobe);
        }
    }
    let parts = parallel::collect(shapes.len(), |i| {
        let (lobe, like) = (shapes[i], like(shapes[i]));
        let views = LazyCell::new(|| Views::of(&lobe.shape, lobe.term));
        let lookups = match like.and_then(|like| like.lookups.clone()) {
            None if over.maps && looks_up(lobe) => Some(Arc::new(views.lookups())),
            known => known,
        };
        let area = match like.map(|like| &like.area) {
            Some(AreaIntegral::Ltc(table)) => AreaIntegral::Ltc(Arc::clone(table)),
            _ => area(lobe, over.areas, || views.ltc()),
        };
        (area, lookups)
    });
    let albedos = parallel::collect(lobes.len(), |i| albedo(&lobes[i].shape, &lobes[i].layers));
    let all = lobes.iter().zip(albedos).map(|(lobe, albedo)| {
        let number =
            shapes.iter().position(|shape| is_alike(shape, lobe)).expect("each lobe's shape is there");
        let (area, lookups) = parts[number].clone();
        (lobe.clone(), LobeIntegrals { albedo, area, lookups })
    });
    all.collect()
}

/// Whether a lobe looks up environments that are not uniform.
fn looks_up(lobe: &DirectLobe) -> bool {
    !lobe.shape.info().delta && !is_cosine(&lobe.shape)
}

fn area(lobe: &DirectLobe, has_areas: bool, ltc: impl FnOnce() -> LtcTable) -> AreaIntegral {
    match lobe.shape.info().delta {
        true => AreaIntegral::Mirror,
        false if is_cosine(&lobe.shape) => AreaIntegral::Cosine,
        false if has_areas && !has_grain(lobe) => AreaIntegral::Ltc(Arc::new(ltc())),
        false => AreaIntegral::Points,
    }
}

/// Whether a lobe, or a layer over it, depends on where the tangent is.
fn has_grain(lobe: &DirectLobe) -> bool {
    let layers = lobe.layers.iter().any(LayerWeight::is_anisotropic);
    layers || lobe.shape.is_anisotropic() && !is_round(&lobe.shape)
}

/// Whether a shape is the clamped cosine over π, of either side: tried where rounding gives nothing away.
fn is_cosine(shape: &Shape) -> bool {
    let info = shape.info();
    let side = if info.side == Side::Transmission { -1.0 } else { 1.0 };
    let is_exact = |(cos_o, cos_i, cos_io): (f64, f64, f64)| {
        let pair = DirectionPair::isotropic(cos_o, side * cos_i, side * cos_io);
        (shape.f_cos(&pair) - cos_i / PI).abs() < 1e-14
    };
    let tried = [(0.9, 0.7, 0.5), (0.2, 0.95, 0.3), (0.5, 0.1, -0.4), (0.05, 0.05, 0.9)];
    info.term == LightTerm::Diffuse && info.params.is_empty() && tried.into_iter().all(is_exact)
}
