//! The half vector of a pair, unnormalised, as the numbers that distributions of slopes use.
//!
//! With H = wo + wi, (n·h)² = (n·H)² / |H|² and tan²θh = (|H|² − (n·H)²) / (n·H)²: no vector needs the length 1.

use glanz_math::Real;

use crate::DirectionPair;

/// H = wo + wi.
#[derive(Clone, Copy, Debug)]
pub struct HalfVector<R> {
    /// (n·H)², at least 1e-12: below are directions at grazing angles both, which no picture shows, and quotients
    /// stay finite.
    pub up2: R,
    /// |H|², at least `up2`.
    pub length2: R,
}

impl<R: Real> HalfVector<R> {
    /// That of a pair.
    #[inline(always)]
    pub fn new(pair: &DirectionPair<R>) -> Self {
        let up2 = (pair.cos_o + pair.cos_i).sqr().max(pair.cos_o.lit(1e-12));
        Self { up2, length2: pair.half2.max(up2) }
    }

    /// The tangential part of H in parts of the widths, squared. `inverse2` is (1/αx², 1/αy²); where both are equal
    /// the tangents are not read.
    #[inline(always)]
    pub fn across2(&self, pair: &DirectionPair<R>, inverse2: (f64, f64)) -> R {
        let x = self.up2.lit(inverse2.0);
        if inverse2.0 == inverse2.1 {
            return (self.length2 - self.up2) * x;
        }
        let y = self.up2.lit(inverse2.1);
        (pair.tangent_o.0 + pair.tangent_i.0).sqr() * x + (pair.tangent_o.1 + pair.tangent_i.1).sqr() * y
    }
}

/// α² sin²θ of a direction for the width along it: αx² x² + αy² y². `squares` is (αx², αy²); where both are equal
/// the tangent is not read.
#[inline(always)]
pub(crate) fn stretched2<R: Real>(cosine: R, tangent: (R, R), squares: (f64, f64)) -> R {
    let x = cosine.lit(squares.0);
    if squares.0 == squares.1 {
        return (cosine.one() - cosine.sqr()).max(cosine.zero()) * x;
    }
    tangent.0.sqr() * x + tangent.1.sqr() * cosine.lit(squares.1)
}

/// What `half_vector.wgsl` reads of a pair of numbers: both, and 1 where they are equal, which single precision may not
/// tell.
pub(super) fn axes((x, y): (f64, f64)) -> [f32; 3] {
    [x as f32, y as f32, f32::from(u8::from(x == y))]
}
