//! What the rounding of a direction's coordinates does to a value.

use super::subject::Subject;
use crate::DirectionPair;

/// Rounding of a cosine that is formed in `f64` from three products.
pub(super) const COSINE_F64: f64 = 5e-16;
/// Rounding of a cosine that is formed in `f32` from three products.
pub(super) const COSINE_F32: f64 = 3e-7;

type Coordinate = fn(&mut DirectionPair<f64>) -> &mut f64;

/// The coordinates of a pair; isotropic lobes read the first three.
const COORDINATES: [Coordinate; 7] = [
    |p| &mut p.cos_o,
    |p| &mut p.cos_i,
    |p| &mut p.cos_io,
    |p| &mut p.tangent_o.0,
    |p| &mut p.tangent_o.1,
    |p| &mut p.tangent_i.0,
    |p| &mut p.tangent_i.1,
];

/// The least and the greatest value for coordinates that differ by at most `rounding` from the pair's: every
/// coordinate is moved both ways, then all together the ways in which the value fell, or rose.
pub(super) fn range(subject: &dyn Subject, pair: &DirectionPair<f64>, rounding: f64) -> (f64, f64) {
    let read = if subject.info().anisotropic { 7 } else { 3 };
    let at = subject.value(pair);
    let (mut low, mut high) = (at, at);
    let (mut falling, mut rising) = (*pair, *pair);
    for coordinate in &COORDINATES[..read] {
        let moved = |step: f64| {
            let mut near = *pair;
            *coordinate(&mut near) += step;
            subject.value(&near)
        };
        let (less, more) = (moved(-rounding), moved(rounding));
        low = low.min(less).min(more);
        high = high.max(less).max(more);
        let up = if more > less { rounding } else { -rounding };
        *coordinate(&mut rising) += up;
        *coordinate(&mut falling) -= up;
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
        tangent_o: both(pair.tangent_o),
        tangent_i: both(pair.tangent_i),
        alpha_scale: pair.alpha_scale.into(),
    }
}
