//! Exponents that all lanes share, and powers that are products.

use crate::Real;

/// An exponent n >= 0 of [`Real::power`], and what follows from it.
///
/// ```
/// use glanz_math::{Exponent, Real};
///
/// // A highlight of exponent 2 at half its cosine, by a product; one of exponent 0.5, by a logarithm.
/// assert_eq!(0.5f32.power(&Exponent::new(2.0)), 0.25);
/// assert!((0.25f32.power(&Exponent::new(0.5)) - 0.5).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    n: f64,
    /// n, if the power is a product of so many factors; 0 if not.
    pub(crate) factors: u32,
    /// The base below which a product is 0.
    least: f32,
}

impl Exponent {
    /// The greatest whole exponent for which powers are products. Beyond it the roundings of the factors add up to more
    /// than those of a logarithm.
    pub const MOST_FACTORS: u32 = 128;

    /// The exponent n.
    pub fn new(n: f64) -> Self {
        let whole = n as u32;
        let is_whole = f64::from(whole) == n && (1..=Self::MOST_FACTORS).contains(&whole);
        let factors = if is_whole { whole } else { 0 };
        // The bits of 1, less 100/n of the step of the exponent: 2^(-100/n), between two powers of 2 along a straight
        // line and so at most 6 % above it.
        let least = f32::from_bits((127 << 23) - (100 << 23) / whole.clamp(1, Self::MOST_FACTORS));
        Self { n, factors, least }
    }

    /// The number itself.
    #[inline(always)]
    pub fn n(&self) -> f64 {
        self.n
    }

    /// The power of any base up to this is 0: at least 0 from n = 1 on, and −∞, where no such thing is known, below.
    #[inline(always)]
    pub fn dark_up_to(&self) -> f64 {
        match self.factors {
            0 if self.n >= 1.0 => 0.0,
            0 => f64::NEG_INFINITY,
            _ => f64::from(self.least),
        }
    }

    /// What [`wgsl::EXPONENT`](crate::wgsl::EXPONENT) reads: n, the number of factors or 0, the base below which a product
    /// is 0.
    pub fn numbers(&self) -> [f32; 3] {
        [self.n as f32, self.factors as f32, self.least]
    }

    /// The product of the factors, at least one; 0 where it would be below the floor.
    #[inline(always)]
    pub(crate) fn product<R: Real>(&self, base: R) -> R {
        let base = base.select(base.lit(f64::from(self.least)).lt(base), base.zero());
        // n = odd · 2^twos.
        let twos = self.factors.trailing_zeros();
        let odd = self.factors >> twos;
        let mut power = base;
        // From the second highest bit of the odd part to the lowest.
        for bit in (0..odd.ilog2()).rev() {
            power = power * power;
            if odd >> bit & 1 == 1 {
                power = power * base;
            }
        }
        for _ in 0..twos {
            power = power * power;
        }
        power
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::POW_FLOOR_LOG2;

    #[test]
    fn products_agree_with_powers_and_have_a_floor() {
        for n in 1..=Exponent::MOST_FACTORS {
            let exponent = Exponent::new(f64::from(n));
            let mut worst = 0.0f64;
            for i in 0..=2000 {
                let x = i as f32 / 2000.0;
                let (got, exact) = (f64::from(x.power(&exponent)), libm::pow(f64::from(x), f64::from(n)));
                if got == 0.0 {
                    assert!(exact < libm::exp2(-89.0), "{x}^{n} is no 0 but {exact}");
                } else {
                    assert!(got > libm::exp2(POW_FLOOR_LOG2) * 0.999, "{x}^{n} = {got} is below the floor");
                    worst = worst.max((got / exact - 1.0).abs());
                }
            }
            // Half a unit of the last place for each factor.
            assert!(worst <= f64::from(n) * 6e-8, "n = {n}: {worst}");
        }
    }

    #[test]
    fn other_exponents_are_powers() {
        for n in [0.0, 0.5, 128.5, 129.0, 1e5] {
            assert_eq!(0.7f32.power(&Exponent::new(n)), 0.7f32.pow(n as f32), "{n} is no number of factors");
        }
    }

    #[test]
    fn a_base_below_0_counts_as_0_and_one_stays_one() {
        let power = |x: f32, n: f64| x.power(&Exponent::new(n));
        assert_eq!(
            [power(-0.5, 2.0), power(f32::NAN, 3.0), power(0.0, 1.0), power(1.0, 128.0)],
            [0.0, 0.0, 0.0, 1.0]
        );
    }
}
