//! Precision: `f32` gives what `f64` gives.

use crate::laws::grid::{Place, places_anywhere};
use crate::laws::rounding::{COSINE_F32, range};
use crate::laws::subject::{ONLY_F32, ONLY_F64, Subject};
use crate::laws::verdict::{Finding, Law};

/// How far a value may lie outside of those for coordinates that are rounded as `f32` rounds them, in parts of it: what a
/// power makes of the rounding of its base. Charlie's sheen of α = 0.001, a sine to the power 1000, needs 1.5e-5; 1e-5
/// would do for all others. Of a narrow lobe the rounding of a cosine is a good part of the width; that, and no more,
/// widens the range.
const TOLERANCE: f64 = 2e-5;
/// Values this much fainter than the greatest are not compared: far down the slope of a lobe of width 0.001 the bounds of
/// the range are not found by moving coordinates, and no picture shows such values.
const FAINTEST: f64 = 1e-6;
/// Directions this near to the horizon, as cosines, are not compared: there `f32` rounds the cosine itself by more than
/// a hundredth.
const HORIZON: f64 = 1e-4;

/// Looks for the pair of directions whose value in `f32` is furthest from all that `f64` gives for coordinates rounded
/// as `f32` rounds them.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_values() {
        return Finding::not_applicable(Law::Precision, reason);
    }
    if subject.is_single() {
        return Finding::not_applicable(Law::Precision, ONLY_F32);
    }
    let is_low = |z: f64| z.abs() < HORIZON;
    let mut places = places_anywhere(subject);
    places.retain(|place| !is_low(place.wo.z) && !is_low(place.wi.z));
    let greatest = places.iter().map(|place| subject.value(&place.pair())).fold(0.0, f64::max);
    let mut worst = (0.0, None);
    for place in places {
        let Some(excess) = excess(subject, &place, FAINTEST * greatest) else {
            return Finding::not_applicable(Law::Precision, ONLY_F64);
        };
        if excess > worst.0 || excess.is_nan() {
            worst = (excess, Some(place));
        }
    }
    let detail = match worst.1 {
        Some(place) => format!("f32 is off by up to {:.1e} of the value: {}", worst.0, place.words()),
        None => "f32 gives what f64 gives for cosines rounded as f32 rounds them".to_owned(),
    };
    Finding::judged(Law::Precision, subject.info(), worst.0 <= TOLERANCE, worst.0, detail)
}

/// How far outside of the range, in parts of the value.
fn excess(subject: &dyn Subject, place: &Place, faintest: f64) -> Option<f64> {
    let got = f64::from(subject.value_f32(&place.pair_f32())?);
    let (low, high) = range(subject, &place.pair(), COSINE_F32);
    if high.max(got) <= faintest {
        return Some(0.0);
    }
    let (below, above) = ((low - got) / low.max(faintest), (got - high) / high.max(faintest));
    Some(if got.is_nan() { f64::NAN } else { below.max(above).max(0.0) })
}
