//! Precomputed integrals of each lobe for area and environment lights: albedo, mean direction, LTC maps,
//! prefiltered environment maps.

use core::cell::OnceCell;
use std::sync::Arc;

use glanz_bsdf::models::ggx::LEAST_ALPHA;
use glanz_bsdf::{DirectionPair, LayerWeight, LightTerm, Shape, Side};
use glanz_math::{Chebyshev, PI};

use super::ltc;
use super::prefilter::{self, Pyramid};
use crate::prepare::data::{
    AreaIntegral, DirectLobe, EnvironmentMap, LightShape, LobeIntegrals, LobeRoughness, PreparedLight,
    PreparedMaterial,
};

/// Terms of the albedo over the cosine.
const TERMS: usize = 16;

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
    let has_areas = lights.iter().any(|light| matches!(light.shape, LightShape::Area { .. }));
    let maps = maps(lights);
    let pyramids = maps.iter().map(|_| OnceCell::new()).collect();
    let mut maker = Maker { has_areas, maps, pyramids, known: Vec::new() };
    for material in before {
        let lobes = material.lobes.iter().map(|lobe| typical(lobe, material));
        maker.known.extend(lobes.zip(material.integrals.iter().cloned()));
    }
    for material in materials {
        let typical = material.lobes.iter().map(|lobe| typical(lobe, material));
        let integrals = typical.map(|lobe| maker.integrals(&lobe)).collect();
        material.integrals = integrals;
    }
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

fn maps(lights: &[PreparedLight]) -> Vec<Option<Arc<EnvironmentMap>>> {
    let map = |light: &PreparedLight| match &light.shape {
        LightShape::Environment(environment) => Some(environment.map.clone()),
        _ => None,
    };
    lights.iter().filter_map(map).collect()
}

struct Maker {
    has_areas: bool,
    maps: Vec<Option<Arc<EnvironmentMap>>>,
    /// Of each of the maps, once a lobe asks for it.
    pyramids: Vec<OnceCell<Pyramid>>,
    known: Vec<(DirectLobe, LobeIntegrals)>,
}

impl Maker {
    fn integrals(&mut self, lobe: &DirectLobe) -> LobeIntegrals {
        let same_shape = |known: &&(DirectLobe, LobeIntegrals)| known.0.shape == lobe.shape;
        let same = self.known.iter().find(|known| same_shape(known) && known.0.layers == lobe.layers);
        if let Some((_, integrals)) = same {
            return integrals.clone();
        }
        let integrals = match self.known.iter().find(same_shape) {
            Some((_, like)) => LobeIntegrals { albedo: albedo(&lobe.shape, &lobe.layers), ..like.clone() },
            None => self.new_integrals(lobe),
        };
        self.known.push((lobe.clone(), integrals.clone()));
        integrals
    }

    fn new_integrals(&self, lobe: &DirectLobe) -> LobeIntegrals {
        let shape = &lobe.shape;
        let blurs = lobe.term == LightTerm::Specular && !shape.info().delta;
        let blurred = |(map, pyramid): (&Option<Arc<EnvironmentMap>>, &OnceCell<Pyramid>)| {
            let map = map.as_ref().filter(|_| blurs)?;
            Some(prefilter::blurred(pyramid.get_or_init(|| Pyramid::of(map)), shape))
        };
        LobeIntegrals {
            albedo: albedo(shape, &lobe.layers),
            middle: [0, 1].map(|i: usize| match blurs && !self.maps.is_empty() {
                true => Chebyshev::interpolate(TERMS, |cosine| ltc::mean_direction(shape, cosine)[i]),
                false => Chebyshev::default(),
            }),
            area: self.area(lobe),
            prefiltered: self.maps.iter().zip(&self.pyramids).map(blurred).collect(),
        }
    }

    fn area(&self, lobe: &DirectLobe) -> AreaIntegral {
        let shape = &lobe.shape;
        match shape.info().delta {
            true => AreaIntegral::Mirror,
            false if is_cosine(shape) => AreaIntegral::Cosine,
            false if self.has_areas && !lobe.is_anisotropic() => {
                AreaIntegral::Ltc(Arc::new(ltc::fit_table(shape)))
            }
            false => AreaIntegral::Points,
        }
    }
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

/// The albedo of a lobe; of a perfect mirror what the layers above leave in its one direction is not part of it.
fn albedo(shape: &Shape, layers: &[LayerWeight]) -> Chebyshev {
    match shape.info().delta {
        true => Chebyshev::interpolate(1, |_| 1.0),
        false => Chebyshev::interpolate(TERMS, |cosine| ltc::albedo(shape, layers, cosine)),
    }
}
