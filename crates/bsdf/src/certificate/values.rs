//! Whether all values are possible: not negative, dark from the wrong side, finite.

use super::grid::{Place, places, short};
use super::report::{Check, Finding};
use super::subject::{NO_DIRECTION, Subject};
use crate::{DirectionPair, LightTerm};

/// Looks for negative light, and for light from the wrong side.
pub(super) fn positivity(subject: &dyn Subject) -> Finding {
    let directional = !matches!(subject.info().term, LightTerm::Ambient | LightTerm::Emission);
    let mut worst = (0.0, None);
    for place in places(subject) {
        let (wo, wi) = (place.wo(), place.wi());
        let value = subject.long(&DirectionPair::new(wo, wi));
        if value < worst.0 {
            worst = (value, Some((place, "negative")));
        }
        let wrong = Place { theta_i: 180.0 - place.theta_i, ..place };
        let through = subject.long(&DirectionPair::new(wo, wrong.wi()));
        if directional && through != 0.0 && worst.1.is_none() {
            worst = (through, Some((wrong, "light from the wrong side")));
        }
    }
    let detail = match worst.1 {
        Some((place, what)) => format!("{what}, {:.3e} 1/sr: {}", worst.0, place.words()),
        None if directional => "never negative, and dark from the wrong side".to_owned(),
        None => "never negative".to_owned(),
    };
    Finding::judged(Check::Positivity, subject.info(), worst.1.is_none(), worst.0, detail)
}

/// Looks for values that are no numbers, up to 89.999° from the normal on both sides.
pub(super) fn grazing(subject: &dyn Subject) -> Finding {
    if matches!(subject.info().term, LightTerm::Ambient | LightTerm::Emission) {
        return Finding::not_applicable(Check::Grazing, NO_DIRECTION);
    }
    let mut greatest = (0.0_f64, None);
    let mut wrong = None;
    for place in places(subject) {
        let (wo, wi) = (place.wo(), place.wi());
        let long = subject.long(&DirectionPair::new(wo, wi));
        let single = f64::from(subject.short(&DirectionPair::new(short(wo), short(wi))));
        if !long.is_finite() || !single.is_finite() {
            wrong = wrong.or(Some((place, if long.is_finite() { "f32" } else { "f64" })));
        } else if long > greatest.0 {
            greatest = (long, Some(place));
        }
    }
    let detail = match (wrong, greatest.1) {
        (Some((place, precision)), _) => format!("not finite in {precision}: {}", place.words()),
        (None, Some(place)) => format!("the greatest f_cos is {:.4} 1/sr: {}", greatest.0, place.words()),
        (None, None) => "0 everywhere".to_owned(),
    };
    let value = if wrong.is_some() { f64::INFINITY } else { greatest.0 };
    Finding::judged(Check::Grazing, subject.info(), wrong.is_none(), value, detail)
}
