//! What lobes make of light that comes from more than one direction: areas and surroundings.

use core::cell::OnceCell;
use std::sync::Arc;

use glanz_bsdf::{Part, Series, Shape, Side, Veil};

use super::cosines::{self, Cosines};
use super::glossy::{self, Pyramid};
use super::lights::{LightShape, PreparedLight};
use super::materials::{DirectLobe, PreparedMaterial};
use super::sky::Sky;

/// Terms of the albedo over the cosine.
const TERMS: usize = 16;

/// What a lobe makes of areas and surroundings.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Its albedo over the cosine of the view angle, veils included.
    pub albedo: Series,
    /// Its mean direction, away from the viewer: the sine of its angle from the normal over that of the view angle,
    /// and its cosine, both over the cosine of the view angle.
    pub middle: [Series; 2],
    /// Its form where it is not the cosine itself; none where the scene has no areas.
    pub cosines: Option<Arc<Cosines>>,
    /// The scene's surroundings as the lobe blurs them, in the order of the lights; none of those that are the
    /// same everywhere, and of lobes that take the irradiance.
    pub skies: Vec<Option<Arc<Sky>>>,
}

impl Field {
    /// That of the clamped cosine, in scenes of so many lights.
    pub fn of_cosine(lights: usize) -> Self {
        let constant = || Series::through(1, |_| 1.0);
        let (albedo, middle) = (constant(), [constant(), constant()]);
        Self { albedo, middle, cosines: None, skies: vec![None; lights] }
    }
}

/// Gives all materials the fields of their lobes; those of `before` are taken over where nothing changed that they
/// depend on. Nothing where all lights are lamps.
pub(super) fn attach(
    materials: &mut [PreparedMaterial],
    lights: &[PreparedLight],
    before: &[PreparedMaterial],
) {
    if lights.iter().all(|light| light.shape.is_classic()) {
        return;
    }
    let has_areas = lights.iter().any(|light| matches!(light.shape, LightShape::Area { .. }));
    let skies = skies(lights);
    let pyramids = skies.iter().map(|_| OnceCell::new()).collect();
    let mut maker = Maker { has_areas, skies, pyramids, known: Vec::new() };
    for material in before {
        maker.known.extend(material.lobes.iter().cloned().zip(material.fields.iter().cloned()));
    }
    for material in materials {
        material.fields = material.lobes.iter().map(|lobe| maker.field(lobe)).collect();
    }
}

fn skies(lights: &[PreparedLight]) -> Vec<Option<Arc<Sky>>> {
    let sky = |light: &PreparedLight| match &light.shape {
        LightShape::Environment(surroundings) => Some(surroundings.sky.clone()),
        _ => None,
    };
    lights.iter().filter_map(sky).collect()
}

struct Maker {
    has_areas: bool,
    skies: Vec<Option<Arc<Sky>>>,
    /// Of each of the skies, once a lobe asks for it.
    pyramids: Vec<OnceCell<Pyramid>>,
    known: Vec<(DirectLobe, Field)>,
}

impl Maker {
    fn field(&mut self, lobe: &DirectLobe) -> Field {
        let same_shape = |known: &&(DirectLobe, Field)| known.0.shape == lobe.shape;
        let same = self.known.iter().find(|known| same_shape(known) && known.0.veils == lobe.veils);
        if let Some((_, field)) = same {
            return field.clone();
        }
        let field = match self.known.iter().find(same_shape) {
            Some((_, like)) => Field { albedo: albedo(&lobe.shape, &lobe.veils), ..like.clone() },
            None => self.new_field(lobe),
        };
        self.known.push((lobe.clone(), field.clone()));
        field
    }

    fn new_field(&self, lobe: &DirectLobe) -> Field {
        let shape = &lobe.shape;
        let fitted = self.has_areas && !shape.info().delta && !is_cosine(shape) && !shape.is_anisotropic();
        let blurs = lobe.part == Part::Specular && !shape.info().delta;
        let blurred = |(sky, pyramid): (&Option<Arc<Sky>>, &OnceCell<Pyramid>)| {
            let sky = sky.as_ref().filter(|_| blurs)?;
            Some(glossy::blurred(pyramid.get_or_init(|| Pyramid::of(sky)), shape))
        };
        Field {
            albedo: albedo(shape, &lobe.veils),
            middle: [0, 1].map(|i: usize| match blurs && !self.skies.is_empty() {
                true => Series::through(TERMS, |cosine| cosines::mean_direction(shape, cosine)[i]),
                false => Series::default(),
            }),
            cosines: fitted.then(|| Arc::new(Cosines::fit(shape))),
            skies: self.skies.iter().zip(&self.pyramids).map(blurred).collect(),
        }
    }
}

/// The albedo of a lobe; of a perfect mirror what its veils leave in its one direction is not part of it.
fn albedo(shape: &Shape, veils: &[Veil]) -> Series {
    match shape.info().delta {
        true => Series::through(1, |_| 1.0),
        false => Series::through(TERMS, |cosine| cosines::albedo(shape, veils, cosine)),
    }
}

/// Whether a shape is the clamped cosine.
pub(crate) fn is_cosine(shape: &Shape) -> bool {
    let info = shape.info();
    info.name == "lambert" || info.name == "lambert-transmission" && info.side == Side::Transmission
}
