//! Functions of lanes beyond [`Real`]: bits, masks, angles, rounding.

use glanz_math::simd::{Bytes, Select, Simd, SimdBase, SimdFloat, i32x16, mask32x16, u32x16};
use glanz_math::{Lanes, Real};

#[inline(always)]
pub(super) fn int<S: Simd>(x: Lanes<S>) -> i32x16<S> {
    x.0.bitcast()
}

#[inline(always)]
pub(super) fn uint<S: Simd>(x: Lanes<S>) -> u32x16<S> {
    x.0.bitcast()
}

#[inline(always)]
pub(super) fn from_int<S: Simd>(x: i32x16<S>) -> Lanes<S> {
    Lanes(x.bitcast())
}

/// The lanes whose truth value holds: all bits are set, the sign among them.
#[inline(always)]
pub(super) fn mask<S: Simd>(x: Lanes<S>) -> mask32x16<S> {
    int(x).simd_lt(x.0.simd.splat_i32x16(0))
}

/// Truth values from a mask.
#[inline(always)]
pub(super) fn truth<S: Simd>(simd: S, m: mask32x16<S>) -> Lanes<S> {
    from_int(m.select(simd.splat_i32x16(-1), simd.splat_i32x16(0)))
}

/// sin (`shift` 0) and cos (`shift` 1). Reduction by Cody and Waite in three parts, polynomials of the Cephes library
/// (S. Moshier). Within 2e-7 for |x| < 8192; beyond that the reduction loses digits.
#[inline(always)]
pub(super) fn sine<S: Simd>(x: Lanes<S>, shift: i32) -> Lanes<S> {
    let simd = x.0.simd;
    let round = Lanes::splat(simd, 12_582_912.0);
    let shifted = x * x.lit(core::f64::consts::FRAC_2_PI) + round;
    let whole = shifted - round;
    let quadrant = int(shifted) + simd.splat_i32x16(shift);
    let r = x
        - whole * x.lit(1.570_312_5)
        - whole * x.lit(4.837_512_969_970_703e-4)
        - whole * x.lit(7.549_789_948_768_648e-8);
    let z = r * r;
    let s = r + r
        * z
        * ((z * x.lit(-1.951_529_589_1e-4) + x.lit(8.332_160_873_6e-3)) * z + x.lit(-1.666_665_461_1e-1));
    let c = x.one() - z * x.lit(0.5)
        + z * z
            * ((z * x.lit(2.443_315_711_809_948e-5) + x.lit(-1.388_731_625_493_765e-3)) * z
                + x.lit(4.166_664_568_298_827e-2));
    let odd = (quadrant & simd.splat_i32x16(1)).simd_eq(simd.splat_i32x16(1));
    let negative = (quadrant & simd.splat_i32x16(2)).simd_eq(simd.splat_i32x16(2));
    let value = Lanes(odd.select(c.0, s.0));
    Lanes(negative.select((-value).0, value.0))
}

#[inline(always)]
pub(super) fn floor<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    Lanes(x.0.floor())
}

/// −1, 0 or 1; 0 for NaN.
#[inline(always)]
pub(super) fn sign<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let up = x.one().select(x.gt(x.zero()), x.zero());
    (-x.one()).select(x.lt(x.zero()), up)
}

/// Remainder with the sign of the dividend, as WGSL's `%`.
#[inline(always)]
pub(super) fn remainder<S: Simd>(x: Lanes<S>, y: Lanes<S>) -> Lanes<S> {
    x - y * Lanes((x / y).0.trunc())
}

#[inline(always)]
pub(super) fn smoothstep<S: Simd>(low: Lanes<S>, high: Lanes<S>, x: Lanes<S>) -> Lanes<S> {
    let t = ((x - low) / (high - low)).max(x.zero()).min(x.one());
    t * t * (x.lit(3.0) - x.lit(2.0) * t)
}

/// log2 for any argument: −∞ at 0, NaN below, +∞ at +∞.
#[inline(always)]
pub(super) fn log2<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let usual = x.max(x.lit(f64::from(f32::MIN_POSITIVE))).log2();
    let infinite = x.lit(f64::INFINITY).select(x.lit(f64::from(f32::MAX)).lt(x), usual);
    let zero = x.lit(f64::NEG_INFINITY).select(x.lt(x.lit(f64::from(f32::MIN_POSITIVE))), infinite);
    let valid = x.zero().le(x);
    zero.select(valid, x.lit(f64::NAN))
}

/// Powers: [`Real::pow`], but NaN for a base below 0, which GLSL leaves undefined, and for NaN, and infinite beyond 2^127.
#[inline(always)]
pub(super) fn pow<S: Simd>(x: Lanes<S>, y: Lanes<S>) -> Lanes<S> {
    let exponent = x.max(x.lit(f64::from(f32::MIN_POSITIVE))).log2() * y;
    let finite = x.pow(y);
    let usual = x.lit(f64::INFINITY).select(x.lit(127.0).lt(exponent), finite);
    usual.select(x.zero().le(x), x.lit(f64::NAN))
}

/// [`Real::exp2`], but infinite from 128 on, 0 below −126 and NaN for NaN.
#[inline(always)]
pub(super) fn exp2<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    let usual = x.exp2();
    let high = x.lit(f64::INFINITY).select(x.lit(128.0).le(x), usual);
    let low = x.zero().select(x.lt(x.lit(-126.0)), high);
    low.select(x.le(x), x.lit(f64::NAN))
}
