//! Side: a lobe is black for light on the other side of the surface than its own.

use crate::laws::grid::places_anywhere;
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};

/// Looks for light from the wrong side, the horizon included.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_directional_light() {
        return Finding::not_applicable(Law::Side, reason);
    }
    let is_wrong = |z: f64| if subject.transmits() { z >= 0.0 } else { z <= 0.0 };
    let mut worst = (0.0_f64, None);
    for place in places_anywhere(subject).into_iter().filter(|place| is_wrong(place.wi.z)) {
        let single = subject.value_f32(&place.pair_f32()).map_or(0.0, f64::from);
        for value in [subject.value(&place.pair()), single] {
            if value.abs() > worst.0 || value.is_nan() {
                worst = (value.abs(), Some(place));
            }
        }
    }
    let detail = match worst.1 {
        Some(place) => format!("light from the wrong side, {:.3e} 1/sr: {}", worst.0, place.words()),
        None if subject.transmits() => "black for light from above".to_owned(),
        None => "black for light from below".to_owned(),
    };
    Finding::judged(Law::Side, subject.info(), worst.1.is_none(), worst.0, detail)
}
