//! Whether single precision gives what double precision gives.

use glanz_math::Vec3;

use super::grid::{places, short};
use super::report::{Check, Finding};
use super::subject::Subject;
use crate::{DirectionPair, LightTerm};

/// Rounding of a cosine that is formed in `f32` from three products.
const COSINE: f64 = 3e-7;
/// How far a value may lie outside of those for cosines so rounded, in parts of it.
const TOLERANCE: f64 = 1e-4;
/// Values this much fainter than the greatest are not compared: pictures do not show them.
const FAINTEST: f64 = 1e-6;
/// Directions this near to the horizon, as cosines, are not compared: there `f32` rounds the cosine itself
/// by more than a hundredth.
const HORIZON: f64 = 1e-4;

/// Looks for the pair of directions whose value in `f32` is furthest from all that `f64` gives for cosines
/// rounded as `f32` rounds them.
pub(super) fn check(subject: &dyn Subject) -> Finding {
    if matches!(subject.info().term, LightTerm::Ambient | LightTerm::Emission) {
        return Finding::not_applicable(Check::Precision, super::subject::NO_DIRECTION);
    }
    let places = places(subject);
    let value = |place: &super::grid::Place| subject.long(&DirectionPair::new(place.wo(), place.wi()));
    let greatest = places.iter().map(value).fold(0.0, f64::max);
    let mut worst = (0.0, None);
    for place in places {
        let (wo, wi) = (place.wo(), place.wi());
        if wo.z.abs() < HORIZON || wi.z.abs() < HORIZON {
            continue;
        }
        let excess = excess(subject, wo, wi, FAINTEST * greatest);
        if excess > worst.0 || excess.is_nan() {
            worst = (excess, Some(place));
        }
    }
    let detail = match worst.1 {
        Some(place) => format!("f32 is off by up to {:.1e} of the value: {}", worst.0, place.words()),
        None => "f32 gives what f64 gives for cosines rounded as f32 rounds them".to_owned(),
    };
    Finding::judged(Check::Precision, subject.info(), worst.0 <= TOLERANCE, worst.0, detail)
}

/// How far outside, in parts of the value.
fn excess(subject: &dyn Subject, wo: Vec3<f64>, wi: Vec3<f64>, faintest: f64) -> f64 {
    let pair = DirectionPair::new(wo, wi);
    let got = f64::from(subject.short(&DirectionPair::new(short(wo), short(wi))));
    let (mut low, mut high) = (f64::MAX, f64::MIN);
    const STEPS: [f64; 3] = [-COSINE, 0.0, COSINE];
    for io in STEPS {
        for cosine in STEPS {
            for tangent in STEPS {
                let mut near = pair;
                near.cos_io += io;
                near.cos_i += cosine;
                near.cos_o += cosine;
                near.tangent_i.0 += tangent;
                near.tangent_i.1 -= tangent;
                let value = subject.long(&near);
                (low, high) = (low.min(value), high.max(value));
            }
        }
    }
    let outside = (low - got).max(got - high).max(0.0);
    if high.max(got) <= faintest { 0.0 } else { outside / high.abs().max(faintest) }
}
