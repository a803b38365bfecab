//! Powers of two that become exactly 0, so that highlights fade without denormal numbers.

use glanz_math::{POW_FLOOR_LOG2, Real};

/// 2 to the power `exponent`, and exactly 0 below 2^-100, as [`Real::pow`] has it and for the same reason.
#[inline(always)]
pub(crate) fn exp2_or_zero<R: Real>(exponent: R) -> R {
    exponent.exp2().select(exponent.lit(POW_FLOOR_LOG2).lt(exponent), exponent.zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fades_to_zero_and_not_to_denormal_numbers() {
        assert_eq!((exp2_or_zero(0.0f32), exp2_or_zero(-3.0f32)), (1.0, 0.125));
        assert!(exp2_or_zero(-99.0f32) > 0.0);
        assert_eq!((exp2_or_zero(-101.0f32), exp2_or_zero(f64::NEG_INFINITY)), (0.0, 0.0));
    }
}
