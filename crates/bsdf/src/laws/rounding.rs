//! What the rounding of a direction's coordinates does to a value.

use super::subject::Subject;
use crate::DirectionPair;
use crate::direction_pair::FROM_VECTORS;

/// Rounding of a cosine that is formed in `f64` from three products.
pub(super) const COSINE_F64: f64 = 5e-16;
/// Rounding of a cosine that is formed in `f32` from three products.
pub(super) const COSINE_F32: f64 = 3e-7;

/// Moves a coordinate of a pair by what the rounding of a cosine makes of it.
type Move = fn(&mut DirectionPair<f64>, f64);

/// The coordinates of a pair; isotropic lobes read the first four, programs of users all of them.
const COORDINATES: [Move; 8] = [
    move_half,
    |p, step| p.cos_o += step,
    |p, step| p.cos_i += step,
    |p, step| p.cos_io += step,
    |p, step| p.tangent_o.0 += step,
    |p, step| p.tangent_o.1 += step,
    |p, step| p.tangent_i.0 += step,
    |p, step| p.tangent_i.1 += step,
];

/// Moves |wo + wi|² by twice what wo·wi is off, but that of a short half vector, which is added up from both directions, by
/// no more than its length is off. Where light passes from below, models mirror or refract it before they add, and a short
/// half vector of the pair is a long one of theirs.
fn move_half(pair: &mut DirectionPair<f64>, step: f64) {
    pair.half2 = match pair.half2 < FROM_VECTORS && pair.cos_i * pair.cos_o > 0.0 {
        true => {
            let length = (pair.half2.sqrt() + step).max(0.0);
            length * length
        }
        false => (pair.half2 + 2.0 * step).max(0.0),
    };
}

/// The least and the greatest value for coordinates that differ by at most `rounding` from the pair's: every
/// coordinate is moved both ways, then all together the ways in which the value fell, or rose.
pub(super) fn range(subject: &dyn Subject, pair: &DirectionPair<f64>, rounding: f64) -> (f64, f64) {
    let read = if subject.info().anisotropic || subject.is_single() { COORDINATES.len() } else { 4 };
    let at = subject.value(pair);
    let (mut low, mut high) = (at, at);
    let (mut falling, mut rising) = (*pair, *pair);
    for moved in &COORDINATES[..read] {
        let value = |step: f64| {
            let mut near = *pair;
            moved(&mut near, step);
            subject.value(&near)
        };
        let (less, more) = (value(-rounding), value(rounding));
        low = low.min(less).min(more);
        high = high.max(less).max(more);
        let up = if more > less { rounding } else { -rounding };
        moved(&mut rising, up);
        moved(&mut falling, -up);
    }
    (low.min(subject.value(&falling)), high.max(subject.value(&rising)))
}

/// The same pair in `f64`.
pub(super) fn to_f64(pair: &DirectionPair<f32>) -> DirectionPair<f64> {
    let both = |(x, y): (f32, f32)| (f64::from(x), f64::from(y));
    DirectionPair {
        cos_o: pair.cos_o.into(),
        cos_i: pair.cos_i.into(),
        cos_io: pair.cos_io.into(),
        half2: pair.half2.into(),
        tangent_o: both(pair.tangent_o),
        tangent_i: both(pair.tangent_i),
        alpha_scale: pair.alpha_scale.into(),
    }
}
