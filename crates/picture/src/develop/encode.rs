//! The transfer function of IEC 61966-2-1 (sRGB) in units of display codes.

use glanz_math::Real;

/// Below this the transfer function is a straight line.
const LINEAR_BELOW: f64 = 0.003_130_8;

/// 255 · (1.055 · s^(5/6) − 0.055) for s = √x on √0.0031308 … 1, lowest power first.
///
/// Remez exchange in 40 digits: the polynomial is within 0.00904 of the exact value. Computed in
/// `f32`, by Horner's rule, it stays within 0.0100.
const CODE_OF_ROOT: [f64; 9] = [
    -11.4673446,
    424.904015,
    -758.732055,
    2545.84045,
    -6031.02708,
    9194.1588,
    -8546.70106,
    4392.70463,
    -954.689381,
];

/// The 8-bit sRGB code of linear light, not yet rounded: 0 … 255, at most 0.01 away from the exact
/// function. Clips; NaN gives 0.
///
/// Cost: a square root and 21 other operations. A second root would save four powers, but roots are
/// what bounds this loop.
#[inline(always)]
pub(super) fn srgb_code_8<R: Real>(linear: R) -> R {
    let x = linear.clamp(0.0, 1.0);
    let root = x.sqrt();
    let mut curve = x.lit(CODE_OF_ROOT[8]);
    for k in (0..8).rev() {
        curve = curve * root + x.lit(CODE_OF_ROOT[k]);
    }
    (x * x.lit(255.0 * 12.92)).select(x.lt(x.lit(LINEAR_BELOW)), curve)
}

/// The 16-bit sRGB code of linear light, not yet rounded: 0 … 65535, in `f32` at most 0.06 away from
/// the exact function. Clips; NaN gives 0.
#[inline(always)]
pub(super) fn srgb_code_16<R: Real>(linear: R) -> R {
    let x = linear.clamp(0.0, 1.0);
    let power = x.pow(x.lit(1.0 / 2.4));
    let curve = power * x.lit(65535.0 * 1.055) - x.lit(65535.0 * 0.055);
    (x * x.lit(65535.0 * 12.92)).select(x.lt(x.lit(LINEAR_BELOW)), curve).clamp(0.0, 65535.0)
}

/// The code of linear light without a transfer function, not yet rounded: 0 … `most`. Clips; NaN gives 0.
#[inline(always)]
pub(super) fn raw_code<R: Real>(linear: R, most: f64) -> R {
    linear.clamp(0.0, 1.0) * linear.lit(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The standard's formula.
    fn exact(x: f64) -> f64 {
        if x <= LINEAR_BELOW { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 }
    }

    /// Dense in linear light and dense near black.
    fn samples() -> impl Iterator<Item = f32> {
        let even = (0..=300_000).map(|i| i as f32 / 300_000.0);
        let dark = (0..=100_000).map(|i| (i as f32 / 100_000.0).powi(4) * 0.05);
        even.chain(dark)
    }

    #[test]
    fn the_8_bit_code_is_within_a_hundredth_of_the_exact_one() {
        let worst = samples()
            .map(|x| (f64::from(srgb_code_8(x)) - 255.0 * exact(f64::from(x))).abs())
            .fold(0.0, f64::max);
        assert!(worst <= 0.010_05, "{worst}");
        assert!(worst > 0.008, "{worst}: better than the polynomial can be");
    }

    #[test]
    fn the_16_bit_code_is_within_6_hundredths_of_the_exact_one() {
        let worst = samples()
            .map(|x| (f64::from(srgb_code_16(x)) - 65535.0 * exact(f64::from(x))).abs())
            .fold(0.0, f64::max);
        assert!(worst <= 0.06, "{worst}");
    }

    #[test]
    fn every_8_bit_code_survives_the_round_trip() {
        for code in 0..=255u8 {
            let back = srgb_code_8(glanz_color::srgb_decode_u8(code));
            assert!((back - f32::from(code)).abs() < 0.0101, "{code} came back as {back}");
        }
    }

    #[test]
    fn brighter_light_gets_a_darker_code_by_no_more_than_rounding_noise() {
        // The terms of the polynomial reach 9194, whose last place in f32 is 0.001.
        const NOISE: f32 = 0.002;
        let mut last = 0.0;
        for i in 0..=1_000_000u32 {
            let code = srgb_code_8(i as f32 * 1e-6);
            assert!(code > last - NOISE, "from {last} to {code} at {i}e-6");
            last = code;
        }
    }

    #[test]
    fn what_is_no_light_is_black_and_too_much_is_white() {
        for x in [-0.0f32, -1.0, f32::NAN, f32::NEG_INFINITY, f32::MIN_POSITIVE] {
            assert!(srgb_code_8(x).abs() < 1e-30, "{x}");
            assert!(srgb_code_16(x).abs() < 1e-30, "{x}");
        }
        for x in [1.0f32, 2.0, f32::MAX, f32::INFINITY] {
            assert_eq!(srgb_code_8(x).round(), 255.0);
            assert_eq!(srgb_code_16(x).round(), 65535.0);
        }
    }
}
