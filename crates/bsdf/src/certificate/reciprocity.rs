//! Whether both ways are the same.

use glanz_math::Vec3;

use super::grid::{Place, places};
use super::report::{Check, Finding};
use super::subject::Subject;
use crate::DirectionPair;

/// How far both ways may differ, in parts of the greater: the rounding of `f64`, multiplied by the exponents
/// of narrow lobes.
const TOLERANCE: f64 = 1e-9;
/// The same where light is bent: the half vector is then formed from other numbers both ways.
const BENT: f64 = 1e-6;
/// Light this faint, in parts of the greatest, is not compared: there exponents multiply the rounding most.
const FAINTEST: f64 = 1e-9;

/// Looks for the pair of directions whose exchange changes most.
///
/// Light that passes through is looked at from the other side, with the surface turned over; the radiances are
/// divided by the squares of the indices that they are in.
pub(super) fn check(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.excuse() {
        return Finding::not_applicable(Check::Reciprocity, reason);
    }
    let Some(back) = subject.turned_over() else {
        return Finding::not_applicable(Check::Reciprocity, "the surface turned over is out of its range");
    };
    let places = places(subject);
    let value = |place: &Place| both_ways(subject, back.as_ref(), *place);
    let greatest = places.iter().map(|place| value(place).0.abs()).fold(0.0, f64::max);
    let mut worst = (0.0, None);
    for place in places {
        let (there, again) = value(&place);
        let greater = there.abs().max(again.abs());
        let difference = if greater <= FAINTEST * greatest { 0.0 } else { (there - again).abs() / greater };
        if difference > worst.0 || difference.is_nan() {
            worst = (difference, Some(place));
        }
    }
    let detail = match worst.1 {
        Some(place) => {
            let share = match worst.0 {
                much if much > 1e-3 => format!("{:.1} %", 100.0 * much),
                little => format!("{little:.1e}"),
            };
            format!("both ways differ by up to {share} of the greater: {}", place.words())
        }
        None => "both ways are the same".to_owned(),
    };
    let tolerance = if subject.eta() == 1.0 { TOLERANCE } else { BENT };
    Finding::judged(Check::Reciprocity, subject.info(), worst.0 <= tolerance, worst.0, detail)
}

/// f(wo, wi) η_i² and f(wi, wo) η_o², both multiplied with both cosines and divided by the index above.
fn both_ways(subject: &dyn Subject, back: &dyn Subject, place: Place) -> (f64, f64) {
    let (wo, wi) = (place.wo(), place.wi());
    let over = |w: Vec3<f64>| if subject.transmits() { Vec3::new(w.x, w.y, -w.z) } else { w };
    let there = subject.long(&DirectionPair::new(wo, wi)) * wo.z.abs() * subject.eta() * subject.eta();
    (there, back.long(&DirectionPair::new(over(wi), over(wo))) * wi.z.abs())
}
