//! Whether both ways are the same.

use super::grid::{Place, places};
use super::report::{Check, Finding};
use super::subject::Subject;
use crate::Pair;

/// How far both ways may differ, in parts of the greater: the rounding of `f64`, multiplied by the exponents
/// of narrow lobes.
const TOLERANCE: f64 = 1e-9;
/// Light this faint, in 1/sr, has no way.
const FAINTEST: f64 = 1e-20;

/// Looks for the pair of directions whose exchange changes most.
///
/// Light that passes through is looked at from the other side, with the surface turned over. That is the
/// law for sheets that are the same on both sides; where light enters another medium, radiance is
/// squeezed by the square of its index, and the way back is that of another shape.
pub(super) fn check(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.excuse() {
        return Finding::not_applicable(Check::Reciprocity, reason);
    }
    let mut worst = (0.0, None);
    for place in places(subject) {
        let difference = asymmetry(subject, place);
        if difference > worst.0 || difference.is_nan() {
            worst = (difference, Some(place));
        }
    }
    let detail = match worst.1 {
        Some(place) => format!("both ways differ by up to {:.3e} of the greater: {}", worst.0, place.words()),
        None => "both ways are the same".to_owned(),
    };
    Finding::judged(Check::Reciprocity, subject.info(), worst.0 <= TOLERANCE, worst.0, detail)
}

/// |f(wo, wi) − f(wi, wo)| in parts of the greater, both multiplied with both cosines.
fn asymmetry(subject: &dyn Subject, place: Place) -> f64 {
    let (wo, wi) = (place.wo(), place.wi());
    let turned = |w: glanz_math::Vec3<f64>| if subject.transmits() { w * -1.0 } else { w };
    let there = subject.long(&Pair::new(wo, wi)) * wo.z.abs();
    let back = subject.long(&Pair::new(turned(wi), turned(wo))) * wi.z.abs();
    let greater = there.abs().max(back.abs());
    if greater < FAINTEST { 0.0 } else { (there - back).abs() / greater }
}
