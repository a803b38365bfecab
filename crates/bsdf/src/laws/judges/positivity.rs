//! Positivity and finiteness: every value is a number, and no light is negative.

use crate::laws::grid::{Place, places, places_anywhere};
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};

/// Looks for negative values, of a delta lobe for any value but 0.
///
/// Ambient light and emission must be positive for every direction: they come from everywhere.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    let wrong = |value: f64| match (subject.info().delta, subject.is_directional()) {
        (true, _) => value != 0.0,
        (_, true) => value < 0.0,
        (_, false) => value <= 0.0,
    };
    let mut worst: (f64, Option<Place>) = (0.0, None);
    for place in places_anywhere(subject) {
        let single = subject.value_f32(&place.pair_f32()).map_or(0.0, f64::from);
        for value in [subject.value(&place.pair()), single] {
            if wrong(value) && (worst.1.is_none() || value < worst.0) {
                worst = (value, Some(place));
            }
        }
    }
    let detail = match worst.1 {
        Some(place) if worst.0 < 0.0 => format!("negative, {:.3e} 1/sr: {}", worst.0, place.words()),
        Some(place) => format!("{:.3e} 1/sr: {}", worst.0, place.words()),
        None if subject.info().delta => "0 everywhere, as a delta lobe must be".to_owned(),
        None => "never negative".to_owned(),
    };
    Finding::judged(Law::Positivity, subject.info(), worst.1.is_none(), worst.0, detail).at(worst.1)
}

/// Looks for values that are not finite. The greatest one that is told is that of views up to 89.999°: lobes that grow
/// without bound have no greatest value in the plane itself.
pub(in crate::laws) fn judge_finiteness(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_values() {
        return Finding::not_applicable(Law::Grazing, reason);
    }
    let mut greatest = (0.0_f64, None);
    let mut wrong = None;
    let above = places(subject).len();
    for (index, place) in places_anywhere(subject).into_iter().enumerate() {
        let single = subject.value_f32(&place.pair_f32()).unwrap_or(0.0);
        let value = if subject.is_single() { 0.0 } else { subject.value(&place.pair()) };
        let value = if subject.is_single() && single.is_finite() { single.into() } else { value };
        if !value.is_finite() || !single.is_finite() {
            wrong = wrong.or(Some((place, if value.is_finite() { "f32" } else { "f64" })));
        } else if index < above && value > greatest.0 {
            greatest = (value, Some(place));
        }
    }
    let detail = match (wrong, greatest.1) {
        (Some((place, precision)), _) => format!("not finite in {precision}: {}", place.words()),
        (None, Some(place)) => format!("the greatest f_cos is {:.4} 1/sr: {}", greatest.0, place.words()),
        (None, None) => "0 everywhere".to_owned(),
    };
    let value = if wrong.is_some() { f64::INFINITY } else { greatest.0 };
    let place = wrong.map(|(place, _)| place).or(greatest.1);
    Finding::judged(Law::Grazing, subject.info(), wrong.is_none(), value, detail).at(place)
}
