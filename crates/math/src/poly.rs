//! The polynomials behind `log2` and `exp2` in `f32` and in lanes.
//!
//! Coefficients: Remez exchange in 40 digits on the reduced interval, minimising the relative
//! error; rounded to `f32` by the compiler. Errors stated are those of the exact polynomials.

use crate::{PI, Real};

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

/// acos x / √(1 − x) on 0 … 1, degree 7, error 2e-8: M. Abramowitz and I. Stegun, Handbook of Mathematical
/// Functions, 1964, 4.4.46.
const ACOS: [f64; 8] = [
    1.5707963050,
    -0.2145988016,
    0.0889789874,
    -0.0501743046,
    0.0308918810,
    -0.0170881256,
    0.0066700901,
    -0.0012624911,
];

/// atan t / t in t² on −1 … 1, degree 8, error 2e-8: the same book, 4.4.49.
const ATAN: [f64; 9] = [
    1.0,
    -0.3333314528,
    0.1999355085,
    -0.1420889944,
    0.1065626393,
    -0.0752896400,
    0.0429096138,
    -0.0161657367,
    0.0028662257,
];

#[inline(always)]
fn horner<R: Real, const N: usize>(x: R, coefficients: &[f64; N]) -> R {
    let mut sum = x.lit(coefficients[N - 1]);
    for c in coefficients[..N - 1].iter().rev() {
        sum = sum * x + x.lit(*c);
    }
    sum
}

#[inline(always)]
pub(crate) fn acos<R: Real>(x: R) -> R {
    let size = x.abs().min(x.one());
    let angle = (size.one() - size).sqrt() * horner(size, &ACOS);
    (x.lit(PI) - angle).select(x.lt(x.zero()), angle)
}

#[inline(always)]
pub(crate) fn atan2<R: Real>(y: R, x: R) -> R {
    let (ax, ay) = (x.abs(), y.abs());
    // The floor makes the angle of the origin 0 rather than 0/0.
    let t = ax.min(ay) / ax.max(ay).max(x.lit(1e-30));
    let low = t * horner(t.sqr(), &ATAN);
    let steep = (x.lit(PI / 2.0) - low).select(ax.lt(ay), low);
    let around = (x.lit(PI) - steep).select(x.lt(x.zero()), steep);
    (-around).select(y.lt(y.zero()), around)
}
