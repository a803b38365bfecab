//! The one trait that all formulas are written against.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use crate::{Exponent, RealFunction, poly};

/// Powers below 2^-100 are returned as exactly zero.
///
/// The clamp keeps denormal numbers (4 times slower on the processors measured) out of the pixel
/// loop. 2^-100 is 8e-31: no display, file format or eye tells it from zero.
pub const POW_FLOOR_LOG2: f64 = -100.0;

/// A real number, or a row of them that computes in step.
///
/// Scalars are lifted with [`Real::lit`], which takes its lane count from `self`.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The result of a comparison, one truth value per lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// `value` in every lane, rounded to the lane type.
    fn lit(self, value: f64) -> Self;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Lane-wise `self < other`.
    fn lt(self, other: Self) -> Self::Mask;
    /// Lane-wise `self <= other`.
    fn le(self, other: Self) -> Self::Mask;
    /// Lane-wise choice: `self` where `mask` holds, else `other`.
    fn select(self, mask: Self::Mask, other: Self) -> Self;
    /// Whether any lane of the mask holds.
    fn any(mask: Self::Mask) -> bool;
    /// Base-2 logarithm of a positive, normal number. Other arguments give a number without meaning
    /// but never a panic; use [`Real::pow`] where the base may be zero.
    fn log2(self) -> Self;
    /// 2 to the power `self`, for arguments in −126 … 127 (clamped to that range).
    fn exp2(self) -> Self;

    /// [`Real::exp2`] for arguments of −126 and more; others give a number without meaning.
    fn exp2_above_floor(self) -> Self;

    /// The lanes one by one; a scalar is all sixteen.
    fn to_array(self) -> [f32; 16];
    /// The lanes from an array; a scalar takes the first.
    fn with_array(self, values: &[f32; 16]) -> Self;
    /// The whole parts of numbers from 0 to 2^31, lane by lane and as numbers; a scalar is all sixteen. Others give
    /// numbers without meaning.
    #[inline(always)]
    fn whole(self) -> ([i32; 16], Self) {
        let (mut whole, mut floor) = ([0; 16], self.to_array());
        for (whole, floor) in whole.iter_mut().zip(&mut floor) {
            *whole = *floor as i32;
            *floor = *whole as f32;
        }
        (whole, self.with_array(&floor))
    }
    /// How many lanes there are.
    const LANES: usize;

    /// The value of a function that is known for each kind of number apart. `self` only says how many lanes there are.
    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self;

    /// What `f` gives, compiled for the SIMD level of the lanes: for code in a function of its own.
    #[inline(always)]
    fn at_own_level<T>(self, f: impl FnOnce() -> T) -> T {
        f()
    }

    /// 0 in every lane.
    #[inline(always)]
    fn zero(self) -> Self {
        self.lit(0.0)
    }
    /// 1 in every lane.
    #[inline(always)]
    fn one(self) -> Self {
        self.lit(1.0)
    }
    /// Lane-wise `self > other`.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// The greater of the two; `other` where either is NaN.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.select(other.lt(self), other)
    }
    /// The smaller of the two; `other` where either is NaN.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.select(self.lt(other), other)
    }
    /// Absolute value.
    #[inline(always)]
    fn abs(self) -> Self {
        self.max(-self)
    }
    /// `self` limited to `low ..= high`; a NaN becomes `low`.
    #[inline(always)]
    fn clamp(self, low: f64, high: f64) -> Self {
        self.max(self.lit(low)).min(self.lit(high))
    }
    /// `self` times itself.
    #[inline(always)]
    fn sqr(self) -> Self {
        self * self
    }
    /// 1 / √self.
    #[inline(always)]
    fn rsqrt(self) -> Self {
        self.one() / self.sqrt()
    }
    /// The angle in radians, 0 … π, whose cosine `self` is; arguments beyond −1 … 1 count as these. Within
    /// 3e-7 in single precision (see `poly`), exact to rounding in double.
    #[inline(always)]
    fn acos(self) -> Self {
        poly::acos(self)
    }
    /// The angle in radians, −π … π, of the point (`x`, `self`) around the origin; 0 at the origin. As exact as
    /// [`Real::acos`].
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        poly::atan2(self, x)
    }
    /// e to the power `self`, for arguments in −87 … 88 (clamped to that range).
    #[inline(always)]
    fn exp(self) -> Self {
        (self * self.lit(core::f64::consts::LOG2_E)).exp2()
    }
    /// `self` to the power `n`, for a base of up to 1 or a little above it and `n` >= 0; a base below 0 counts as 0.
    ///
    /// 0^0 is 1, as the limit of a Phong lobe wants it. Results below 2^-100 are exactly 0
    /// (see [`POW_FLOOR_LOG2`]).
    #[inline(always)]
    fn pow(self, n: Self) -> Self {
        let tiny = self.lit(f32::MIN_POSITIVE as f64);
        let exponent = self.max(tiny).log2() * n;
        let kept = self.lit(POW_FLOOR_LOG2).lt(exponent);
        if !Self::any(kept) {
            return self.zero();
        }
        exponent.exp2_above_floor().select(kept, self.zero())
    }
    /// [`Real::pow`] with an exponent that all lanes share. Whole ones up to [`Exponent::MOST_FACTORS`] are products,
    /// which cost a sixth of a power; in `f32` they are within n roundings of it.
    ///
    /// What lies below a floor between 2^-100 and 2^-89 is exactly 0, for the reason of [`POW_FLOOR_LOG2`].
    #[inline(always)]
    fn power(self, exponent: &Exponent) -> Self {
        match exponent.factors {
            0 => self.pow(self.lit(exponent.n())),
            _ => exponent.product(self),
        }
    }
}

impl Real for f64 {
    type Mask = bool;
    const LANES: usize = 1;

    #[inline(always)]
    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self {
        function.in_f64(arguments)
    }

    #[inline(always)]
    fn to_array(self) -> [f32; 16] {
        [self as f32; 16]
    }
    #[inline(always)]
    fn with_array(self, values: &[f32; 16]) -> Self {
        f64::from(values[0])
    }

    #[inline(always)]
    fn lit(self, value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn log2(self) -> Self {
        libm::log2(self)
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        libm::exp2(self.clamp(-126.0, 127.0))
    }
    #[inline(always)]
    fn exp2_above_floor(self) -> Self {
        self.exp2()
    }
    /// The power itself for all exponents: what others are compared with multiplies nothing.
    #[inline(always)]
    fn power(self, exponent: &Exponent) -> Self {
        self.pow(exponent.n())
    }
    #[inline(always)]
    fn acos(self) -> Self {
        libm::acos(self.clamp(-1.0, 1.0))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        libm::atan2(self, x)
    }
}

impl Real for f32 {
    type Mask = bool;
    const LANES: usize = 1;

    #[inline(always)]
    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self {
        function.in_f32(arguments)
    }

    #[inline(always)]
    fn to_array(self) -> [f32; 16] {
        [self; 16]
    }
    #[inline(always)]
    fn with_array(self, values: &[f32; 16]) -> Self {
        values[0]
    }

    #[inline(always)]
    fn lit(self, value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // IEEE 754 defines the square root exactly, so the standard one is the same everywhere.
        f32::sqrt(self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn log2(self) -> Self {
        let bits = self.to_bits() as i32;
        let shifted = bits.wrapping_sub(poly::SQRT_HALF_BITS);
        let exponent = shifted >> 23;
        let mantissa = f32::from_bits(bits.wrapping_sub(exponent << 23) as u32);
        poly::log2(mantissa, exponent as f32)
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        Real::max(self, -126.0).exp2_above_floor()
    }
    #[inline(always)]
    fn exp2_above_floor(self) -> Self {
        let x = Real::min(self, 127.0);
        let shifted = x + poly::ROUND_TO_INT;
        let whole = shifted - poly::ROUND_TO_INT;
        let exponent = (shifted.to_bits() as i32).wrapping_shl(23);
        let mantissa = poly::exp2_fraction(x - whole);
        f32::from_bits((mantissa.to_bits() as i32).wrapping_add(exponent) as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative error of `f32` powers: 3 units of the last place of `n·log2(x)`.
    const POW_TOLERANCE: f64 = 4e-7;

    #[test]
    fn log2_agrees_with_libm_over_all_exponents() {
        for i in 1..200_000u32 {
            let x = f32::from_bits(0x0080_0000 + i * 10_500);
            let exact = libm::log2(x as f64);
            let error = (Real::log2(x) as f64 - exact).abs();
            assert!(error <= 2e-7 * exact.abs().max(1e-30) + 1e-12, "log2({x}) = {exact}, off by {error}");
        }
    }

    #[test]
    fn exp2_agrees_with_libm_over_its_range() {
        for i in 0..=253_000 {
            let x = (-126.0 + i as f32 * 0.001).min(127.0);
            let exact = libm::exp2(x as f64);
            let error = (Real::exp2(x) as f64 / exact - 1.0).abs();
            assert!(error < 2e-7, "exp2({x}) is off by {error}");
        }
    }

    #[test]
    fn exp2_of_an_integer_is_exact() {
        for n in -126..=127 {
            assert_eq!(Real::exp2(n as f32) as f64, libm::exp2(n as f64));
        }
    }

    #[test]
    fn powers_agree_with_f64() {
        for i in 0..=1000 {
            let x = i as f32 / 1000.0;
            for n in [1.0f32, 2.0, 5.0, 32.0, 256.0, 1000.0] {
                let exact = libm::pow(x as f64, n as f64);
                let got = Real::pow(x, n) as f64;
                if exact < 1e-29 {
                    assert!(got < 1e-29);
                } else {
                    let scale = 1.0 + (n as f64 * libm::log2(x as f64)).abs();
                    assert!((got / exact - 1.0).abs() < POW_TOLERANCE * scale, "{x}^{n}: {got} for {exact}");
                }
            }
        }
    }

    /// Of angles in single precision: rounding of numbers up to π.
    const ANGLE_F32: f64 = 6e-7;

    #[test]
    fn angles_agree_with_libm_all_around() {
        for i in -1000..=1000 {
            let x = i as f32 / 1000.0;
            let error = (Real::acos(x) as f64 - libm::acos(x as f64)).abs();
            assert!(error < ANGLE_F32, "acos({x}) is off by {error}");
            let (y, x) = libm::sincos(i as f64 * 0.003_141);
            for radius in [1e-12, 1.0, 1e12] {
                let (x, y) = ((x * radius) as f32, (y * radius) as f32);
                let error = (Real::atan2(y, x) as f64 - libm::atan2(y as f64, x as f64)).abs();
                assert!(error < ANGLE_F32, "atan2({y}, {x}) is off by {error}");
            }
        }
        assert_eq!((Real::acos(1.0f32), Real::acos(2.0f32), Real::atan2(0.0f32, 0.0)), (0.0, 0.0, 0.0));
    }

    #[test]
    fn powers_below_the_floor_are_zero_and_the_zeroth_power_is_one() {
        assert_eq!(Real::pow(0.5f32, 101.0), 0.0);
        assert!(Real::pow(0.5f32, 99.0) > 0.0);
        assert_eq!(Real::pow(0.0f32, 32.0), 0.0);
        assert_eq!(Real::pow(0.0f32, 0.0), 1.0);
        assert_eq!(Real::pow(0.3f32, 0.0), 1.0);
    }
}
