//! What lobes make of light that comes from more than one direction: areas and surroundings.

use core::cell::OnceCell;
use std::sync::Arc;

use glanz_bsdf::{Chebyshev, LayerWeight, LightTerm, Shape, Side};

use crate::prepare::build::lights::{LightShape, PreparedLight};
use crate::prepare::build::ltc::{self, LtcTable};
use crate::prepare::build::materials::{DirectLobe, PreparedMaterial};
use crate::prepare::build::prefilter::{self, Pyramid};
use crate::prepare::data::environment_map::EnvironmentMap;

/// Terms of the albedo over the cosine.
const TERMS: usize = 16;

/// What a lobe makes of areas and surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeIntegrals {
    /// Its albedo over the cosine of the view angle, veils included.
    pub albedo: Chebyshev,
    /// Its mean direction, away from the viewer: the sine of its angle from the normal over that of the view angle,
    /// and its cosine, both over the cosine of the view angle.
    pub middle: [Chebyshev; 2],
    /// Its form where it is not the cosine itself; none where the scene has no areas.
    pub ltc: Option<Arc<LtcTable>>,
    /// The scene's surroundings as the lobe blurs them, in the order of the lights; none of those that are the
    /// same everywhere, and of lobes that take the irradiance.
    pub prefiltered: Vec<Option<Arc<EnvironmentMap>>>,
}

impl LobeIntegrals {
    /// That of the clamped cosine, in scenes of so many lights.
    pub fn of_cosine(lights: usize) -> Self {
        let constant = || Chebyshev::interpolate(1, |_| 1.0);
        let (albedo, middle) = (constant(), [constant(), constant()]);
        Self { albedo, middle, ltc: None, prefiltered: vec![None; lights] }
    }
}

/// Gives all materials the fields of their lobes; those of `before` are taken over where nothing changed that they
/// depend on. Nothing where all lights are lamps.
pub(crate) fn attach(
    materials: &mut [PreparedMaterial],
    lights: &[PreparedLight],
    before: &[PreparedMaterial],
) {
    if lights.iter().all(|light| light.shape.is_classic()) {
        return;
    }
    let has_areas = lights.iter().any(|light| matches!(light.shape, LightShape::Area { .. }));
    let maps = maps(lights);
    let pyramids = maps.iter().map(|_| OnceCell::new()).collect();
    let mut maker = Maker { has_areas, maps, pyramids, known: Vec::new() };
    for material in before {
        maker.known.extend(material.lobes.iter().cloned().zip(material.integrals.iter().cloned()));
    }
    for material in materials {
        material.integrals = material.lobes.iter().map(|lobe| maker.integrals(lobe)).collect();
    }
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
    /// Of each of the skies, once a lobe asks for it.
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
            None => self.new_field(lobe),
        };
        self.known.push((lobe.clone(), integrals.clone()));
        integrals
    }

    fn new_field(&self, lobe: &DirectLobe) -> LobeIntegrals {
        let shape = &lobe.shape;
        let fitted = self.has_areas && !shape.info().delta && !is_cosine(shape) && !shape.is_anisotropic();
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
            ltc: fitted.then(|| Arc::new(LtcTable::fit(shape))),
            prefiltered: self.maps.iter().zip(&self.pyramids).map(blurred).collect(),
        }
    }
}

/// The albedo of a lobe; of a perfect mirror what its veils leave in its one direction is not part of it.
fn albedo(shape: &Shape, layers: &[LayerWeight]) -> Chebyshev {
    match shape.info().delta {
        true => Chebyshev::interpolate(1, |_| 1.0),
        false => Chebyshev::interpolate(TERMS, |cosine| ltc::albedo(shape, layers, cosine)),
    }
}

/// Whether a shape is the clamped cosine.
pub(crate) fn is_cosine(shape: &Shape) -> bool {
    let info = shape.info();
    info.name == "lambert" || info.name == "lambert-transmission" && info.side == Side::Transmission
}
