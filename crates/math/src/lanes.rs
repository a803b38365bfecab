//! Sixteen `f32` that compute in step, on any SIMD level.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use fearless_simd::{Bytes, Select, Simd, SimdBase, SimdFloat, SimdMask, f32x16, i32x16, mask32x16};

use crate::{Real, RealFunction, SimdLevel, poly};

/// 16 lanes of `f32` under [`Real`]. Every lane gives the bits that `f32` gives.
///
/// All code between the dispatch and these operations must be `#[inline(always)]`, closures too:
/// otherwise the compiler leaves the SIMD level's registers and the code is several times slower.
#[derive(Clone, Copy)]
pub struct Lanes<S: Simd>(pub f32x16<S>);

/// The truth values of a comparison of [`Lanes`].
#[derive(Clone, Copy)]
pub struct LanesMask<S: Simd>(pub mask32x16<S>);

impl<S: Simd> Lanes<S> {
    /// The number of lanes.
    pub const LEN: usize = 16;

    /// `value` in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f32) -> Self {
        Self(simd.splat_f32x16(value))
    }
    /// The lanes from an array.
    #[inline(always)]
    pub fn load(simd: S, values: &[f32; 16]) -> Self {
        Self(f32x16::from_slice(simd, values))
    }
    /// The lanes to an array.
    #[inline(always)]
    pub fn store(self, values: &mut [f32; 16]) {
        self.0.store_slice(values);
    }
}

impl<S: Simd> LanesMask<S> {
    /// Bit i is set where lane i holds.
    #[inline(always)]
    pub fn bits(self) -> u32 {
        self.0.to_bitmask() as u32
    }
    /// The mask whose lane i holds where bit i is set.
    #[inline(always)]
    pub fn from_bits(simd: S, bits: u32) -> Self {
        Self(mask32x16::from_bitmask(simd, u64::from(bits)))
    }
}

macro_rules! lane_operator {
    ($trait:ident, $method:ident) => {
        impl<S: Simd> $trait for Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    };
}
lane_operator!(Add, add);
lane_operator!(Sub, sub);
lane_operator!(Mul, mul);
lane_operator!(Div, div);

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> BitAnd for LanesMask<S> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<S: Simd> BitOr for LanesMask<S> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl<S: Simd> Not for LanesMask<S> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl<S: Simd> Real for Lanes<S> {
    type Mask = LanesMask<S>;

    const LANES: usize = 16;

    #[inline(always)]
    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self {
        let simd = self.0.simd;
        let rows = arguments.map(
            #[inline(always)]
            |argument| argument.to_array(),
        );
        Self::load(simd, &function.in_lanes(SimdLevel::of(simd.level()), &rows))
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 16] {
        let mut values = [0.0; 16];
        self.store(&mut values);
        values
    }
    #[inline(always)]
    fn with_array(self, values: &[f32; 16]) -> Self {
        Self::load(self.0.simd, values)
    }
    #[inline(always)]
    fn whole(self) -> ([i32; 16], Self) {
        let simd = self.0.simd;
        let numbers = simd.cvt_i32_f32x16(self.0);
        let mut whole = [0; 16];
        numbers.store_slice(&mut whole);
        (whole, Self(simd.cvt_f32_i32x16(numbers)))
    }
    #[inline(always)]
    fn at_own_level<T>(self, f: impl FnOnce() -> T) -> T {
        self.0.simd.vectorize(f)
    }
    #[inline(always)]
    fn lit(self, value: f64) -> Self {
        Self(self.0.simd.splat_f32x16(value as f32))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(SimdFloat::sqrt(self.0))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> LanesMask<S> {
        LanesMask(self.0.simd.simd_lt_f32x16(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> LanesMask<S> {
        LanesMask(self.0.simd.simd_le_f32x16(self.0, other.0))
    }
    #[inline(always)]
    fn select(self, mask: LanesMask<S>, other: Self) -> Self {
        Self(mask.0.select(self.0, other.0))
    }
    // On x86 the instructions for maximum and minimum are the very comparison and choice of `Real`, to
    // the case of NaN and of two zeros: the second operand wins. Elsewhere they differ in these cases.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.simd.max_f32x16(self.0, other.0))
    }
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.simd.min_f32x16(self.0, other.0))
    }
    #[inline(always)]
    fn any(mask: LanesMask<S>) -> bool {
        mask.0.any_true()
    }
    #[inline(always)]
    fn log2(self) -> Self {
        let simd = self.0.simd;
        let bits: i32x16<S> = self.0.bitcast();
        let shifted = bits - simd.splat_i32x16(poly::SQRT_HALF_BITS);
        let exponent = shifted >> 23;
        let mantissa: f32x16<S> = (bits - (exponent << 23)).bitcast();
        poly::log2(Self(mantissa), Self(simd.cvt_f32_i32x16(exponent)))
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        self.max(self.lit(-126.0)).exp2_above_floor()
    }
    #[inline(always)]
    fn exp2_above_floor(self) -> Self {
        let simd = self.0.simd;
        let x = self.min(self.lit(127.0));
        let round = Self::splat(simd, poly::ROUND_TO_INT);
        let shifted = x + round;
        let whole = shifted - round;
        let exponent = shifted.0.bitcast::<i32x16<S>>() << 23;
        let mantissa = poly::exp2_fraction(x - whole);
        let bits = mantissa.0.bitcast::<i32x16<S>>() + exponent;
        Self(bits.bitcast())
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[inline(always)]
    fn every_operation<R: Real>(x: R, y: R) -> [R; 12] {
        [
            x + y,
            x - y,
            x * y,
            x / y,
            x.sqrt(),
            x.log2(),
            y.exp2(),
            x.pow(y.abs()),
            x.max(y),
            x.min(y),
            y.abs().rsqrt(),
            -x,
        ]
    }

    /// Sixteen pairs that include the awkward ones.
    fn pairs() -> ([f32; 16], [f32; 16]) {
        let x = [
            0.0,
            1.0,
            0.5,
            1e-30,
            1e30,
            0.999_999_9,
            1.000_000_1,
            3.0,
            0.1,
            0.7,
            core::f32::consts::FRAC_1_SQRT_2,
            core::f32::consts::SQRT_2,
            2e-38,
            12.5,
            1e-7,
            0.25,
        ];
        let y = [
            0.0,
            -1.0,
            32.0,
            2.0,
            -0.5,
            256.0,
            0.499_999_97,
            0.5,
            -126.0,
            127.0,
            100.0,
            -0.0,
            300.0,
            -300.0,
            1e-20,
            64.0,
        ];
        (x, y)
    }

    #[test]
    fn sixteen_lanes_give_the_bits_of_one() {
        let (x, y) = pairs();
        let mut wide = [[0.0f32; 16]; 12];
        dispatch!(Level::new(), simd => {
            let results = every_operation(Lanes::load(simd, &x), Lanes::load(simd, &y));
            for (out, lanes) in wide.iter_mut().zip(results) {
                lanes.store(out);
            }
        });
        for lane in 0..16 {
            let scalar = every_operation(x[lane], y[lane]);
            for (op, value) in scalar.into_iter().enumerate() {
                let same =
                    value.to_bits() == wide[op][lane].to_bits() || value.is_nan() && wide[op][lane].is_nan();
                assert!(same, "operation {op}, lane {lane}: {value} against {}", wide[op][lane]);
            }
        }
    }

    #[test]
    fn maximum_and_minimum_are_those_of_one_lane_for_nan_and_both_zeros_too() {
        let awkward = [0.0, -0.0, f32::NAN, 1.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, 1e-40];
        for x in awkward {
            for y in awkward {
                let mut wide = [[0.0f32; 16]; 2];
                dispatch!(Level::new(), simd => {
                    let (x, y) = (Lanes::splat(simd, x), Lanes::splat(simd, y));
                    x.max(y).store(&mut wide[0]);
                    x.min(y).store(&mut wide[1]);
                });
                for (wide, scalar) in wide.iter().zip([Real::max(x, y), Real::min(x, y)]) {
                    assert_eq!(wide[3].to_bits(), scalar.to_bits(), "{x} and {y}");
                }
            }
        }
    }

    #[test]
    fn masks_survive_the_way_through_bits() {
        dispatch!(Level::new(), simd => {
            for bits in [0u32, 1, 0x8000, 0xffff, 0x1234] {
                assert_eq!(LanesMask::from_bits(simd, bits).bits(), bits);
            }
        });
    }
}
