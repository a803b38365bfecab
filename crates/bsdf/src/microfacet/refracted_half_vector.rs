//! The half vector of refraction, unnormalised.
//!
//! With H = wo + η wi, where η is the index on the light's side over that on the viewer's: the facet that sends wi to
//! wo has its normal along H or −H, whichever points up. Walter and others 2007, equation 16.

use glanz_math::Real;

use crate::DirectionPair;

/// H = wo + η wi.
pub struct RefractedHalfVector<R: Real> {
    /// (n·H)².
    pub up2: R,
    /// |H|², at least `up2`; not below (η − 1)².
    pub length2: R,
    /// |wo·H| |wi·H|.
    pub product: R,
    /// Whether there is light on the other side and the facet is seen and lit.
    pub lit: R::Mask,
}

impl<R: Real> RefractedHalfVector<R> {
    /// That of a pair for this index of refraction.
    #[inline(always)]
    pub fn new(pair: &DirectionPair<R>, eta: f64) -> Self {
        let zero = pair.cos_o.zero();
        let Projections { up, with_o, with_i, length2 } = Projections::of(pair, eta);
        let up2 = up.sqr();
        // The normal has the sign of `up`: seen is (wo·H) up > 0, lit from behind (wi·H) up < 0.
        let faces = zero.lt(with_o * up) & (with_i * up).lt(zero);
        let lit = zero.lt(pair.cos_o) & pair.cos_i.lt(zero) & faces;
        Self { up2, length2: length2.max(up2), product: (with_o * with_i).abs(), lit }
    }
}

/// Below this |H|² the parts of H are taken from |wo + wi|²: where light goes on nearly straight through a boundary of
/// nearly equal indices, those of wo·wi have lost their digits.
const FROM_HALF: f64 = 0.05;

/// H along the normal and both directions, and its length.
struct Projections<R> {
    /// n·H.
    up: R,
    /// wo·H.
    with_o: R,
    /// wi·H.
    with_i: R,
    /// |H|².
    length2: R,
}

impl<R: Real> Projections<R> {
    #[inline(always)]
    fn of(pair: &DirectionPair<R>, eta: f64) -> Self {
        let (one, index) = (pair.cos_o.one(), pair.cos_o.lit(eta));
        let up = pair.cos_o + index * pair.cos_i;
        let (with_o, with_i) = (one + index * pair.cos_io, pair.cos_io + index);
        let length2 = with_o + index * with_i;
        let short = length2.lt(one.lit(FROM_HALF));
        if !R::any(short) {
            return Self { up, with_o, with_i, length2 };
        }
        // With c = |wo + wi|²/2 − 1: wo·H = 1 + η c, wi·H = η + c, |H|² = (η − 1)² + η |wo + wi|².
        let (half, step) = (pair.half2 * one.lit(0.5), one.lit(eta - 1.0));
        Self {
            up: ((pair.cos_o + pair.cos_i) + step * pair.cos_i).select(short, up),
            with_o: (index * half - step).select(short, with_o),
            with_i: (half + step).select(short, with_i),
            length2: (step.sqr() + index * pair.half2).select(short, length2),
        }
    }
}

/// |wo·h|, 0 … 1: the cosine at which light meets the facet, on the viewer's side.
#[inline(always)]
pub(crate) fn refracted_cosine<R: Real>(pair: &DirectionPair<R>, eta: f64) -> R {
    let Projections { with_o, length2, .. } = Projections::of(pair, eta);
    (with_o.abs() * length2.max(length2.lit(1e-12)).rsqrt()).clamp(0.0, 1.0)
}

/// The index that rough refraction is computed with: at 1 nothing is refracted and the lobe has no width, so that values
/// nearer to 1 than 0.01 count as 0.01 off.
pub(crate) fn effective_eta(eta: f64) -> f64 {
    match eta - 1.0 {
        d if d.abs() >= 0.01 => eta,
        d if d < 0.0 => 0.99,
        _ => 1.01,
    }
}
