//! The polynomials behind `log2` and `exp2` in `f32` and in lanes.
//!
//! Coefficients: Remez exchange in 40 digits on the reduced interval, minimising the relative
//! error; rounded to `f32` by the compiler. Errors stated are those of the exact polynomials.

use crate::Real;

/// Bits of √½: a number is split as m·2^e with m in √½ … √2, so that log2 m is small around 1.
pub(crate) const SQRT_HALF_BITS: i32 = 0x3f35_04f3;

/// 1.5·2^23: adding it rounds a small `f32` to an integer, which then sits in the low bits.
pub(crate) const ROUND_TO_INT: f32 = 12_582_912.0;

/// log2(1 + t) / t on √½−1 … √2−1, degree 8, relative error 2.6e-8.
const LOG2: [f64; 9] = [
    1.442695004,
    -0.7213473468,
    0.480910643,
    -0.3607036835,
    0.2879162465,
    -0.2389448061,
    0.2157156049,
    -0.2072698469,
    0.1258371446,
];

/// (2^t − 1) / t on −½ … ½, degree 5, relative error of 2^t 2.6e-9.
const EXP2: [f64; 6] =
    [0.693147215, 0.2402265278, 0.05550310551, 0.009617692974, 0.001340664387, 0.0001559467789];

/// log2 of m·2^e. Even and odd halves of the polynomial run side by side.
#[inline(always)]
pub(crate) fn log2<R: Real>(mantissa: R, exponent: R) -> R {
    let t = mantissa - mantissa.one();
    let t2 = t * t;
    let c = |i: usize| t.lit(LOG2[i]);
    let even = (((c(8) * t2 + c(6)) * t2 + c(4)) * t2 + c(2)) * t2 + c(0);
    let odd = ((c(7) * t2 + c(5)) * t2 + c(3)) * t2 + c(1);
    t * (even + t * odd) + exponent
}

/// 2^t for t in −½ … ½.
#[inline(always)]
pub(crate) fn exp2_fraction<R: Real>(t: R) -> R {
    let t2 = t * t;
    let c = |i: usize| t.lit(EXP2[i]);
    let even = (c(4) * t2 + c(2)) * t2 + c(0);
    let odd = (c(5) * t2 + c(3)) * t2 + c(1);
    t * (even + t * odd) + t.one()
}
