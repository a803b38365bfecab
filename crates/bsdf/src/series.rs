//! Functions of a cosine as short series, which sixteen pixels evaluate without looking anything up.

use glanz_math::{PI, Real};

/// A sum of Chebyshev polynomials over 0 … 1. Source: L. N. Trefethen, Approximation Theory and
/// Approximation Practice, 2013; C. W. Clenshaw 1955.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The coefficients, of degree 0 first.
    terms: Vec<f64>,
}

impl Series {
    /// The series of so many terms through a function's values at the Chebyshev nodes of 0 … 1.
    pub fn through(terms: usize, f: impl Fn(f64) -> f64) -> Self {
        let angle = |j: usize| PI * (j as f64 + 0.5) / terms as f64;
        let values: Vec<f64> = (0..terms).map(|j| f(0.5 * (1.0 + libm::cos(angle(j))))).collect();
        let coefficient = |k: usize| {
            let sum: f64 = values.iter().enumerate().map(|(j, v)| v * libm::cos(k as f64 * angle(j))).sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / terms as f64
        };
        Self { terms: (0..terms).map(coefficient).collect() }
    }

    /// The value at `x`, 0 … 1.
    #[inline(always)]
    pub fn at<R: Real>(&self, x: R) -> R {
        let t = x + x - x.one();
        let two_t = t + t;
        let (mut next, mut after) = (x.zero(), x.zero());
        let Some((first, others)) = self.terms.split_first() else { return next };
        for term in others.iter().rev() {
            let own = two_t * next - after + x.lit(*term);
            after = next;
            next = own;
        }
        t * next - after + x.lit(*first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_functions_come_back() {
        let series = Series::through(12, libm::exp);
        for step in 0..=20 {
            let x = f64::from(step) / 20.0;
            assert!((series.at(x) - libm::exp(x)).abs() < 1e-11, "{x}");
        }
        assert_eq!(Series::default().at(0.5), 0.0);
    }
}
