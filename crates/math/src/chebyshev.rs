//! Functions of a cosine as short sums of Chebyshev polynomials, which sixteen pixels evaluate without a table.
//!
//! Over a cosine, Fresnel reflectance and albedos are smooth up to the ends of the range, so the sums converge
//! fast. Sources: L. N. Trefethen, Approximation Theory and Approximation Practice, 2013; C. W. Clenshaw,
//! "A note on the summation of Chebyshev series", MTAC 9, 1955.

use crate::{PI, Real};

/// `C` functions over 0 … 1, each a sum of Chebyshev polynomials in 2x − 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chebyshev<T = f64, const C: usize = 1> {
    /// The coefficients, of degree 0 first. None: zero everywhere.
    pub terms: Vec<[T; C]>,
}

/// The places in 0 … 1 at which a function must be known for a sum of so many terms.
pub fn chebyshev_nodes(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |j| 0.5 * (1.0 + libm::cos(PI * (j as f64 + 0.5) / count as f64)))
}

/// The coefficients of the sum through values at [`chebyshev_nodes`], as many as there are values.
fn coefficients<const C: usize>(values: &[[f64; C]]) -> Vec<[f64; C]> {
    let count = values.len();
    let coefficient = |k: usize, c: usize| {
        let term = |(j, value): (usize, &[f64; C])| {
            value[c] * libm::cos(PI * k as f64 * (j as f64 + 0.5) / count as f64)
        };
        let sum: f64 = values.iter().enumerate().map(term).sum();
        sum * if k == 0 { 1.0 } else { 2.0 } / count as f64
    };
    (0..count).map(|k| core::array::from_fn(|c| coefficient(k, c))).collect()
}

impl<T: Copy + Into<f64>, const C: usize> Chebyshev<T, C> {
    /// The values at `x`, 0 … 1.
    #[inline(always)]
    fn evaluate<R: Real>(&self, x: R) -> [R; C] {
        let t = x + x - x.one();
        let two_t = t + t;
        let (mut next, mut after) = ([x.zero(); C], [x.zero(); C]);
        let Some((first, others)) = self.terms.split_first() else { return next };
        for term in others.iter().rev() {
            for c in 0..C {
                let own = two_t * next[c] - after[c] + x.lit(term[c].into());
                after[c] = next[c];
                next[c] = own;
            }
        }
        for c in 0..C {
            next[c] = t * next[c] - after[c] + x.lit(first[c].into());
        }
        next
    }

    /// How many terms there are: what an evaluation costs.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether the functions are zero everywhere.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }
}

impl Chebyshev {
    /// The sum of so many terms through a function's values at the nodes.
    ///
    /// ```
    /// let series = glanz_math::Chebyshev::interpolate(12, |x| x * x);
    /// assert!((series.at(0.3) - 0.09_f64).abs() < 1e-12);
    /// ```
    pub fn interpolate(terms: usize, f: impl Fn(f64) -> f64) -> Self {
        let values: Vec<[f64; 1]> = chebyshev_nodes(terms).map(|x| [f(x)]).collect();
        Self { terms: coefficients(&values) }
    }

    /// The value at `x`, 0 … 1.
    #[inline(always)]
    pub fn at<R: Real>(&self, x: R) -> R {
        self.evaluate(x)[0]
    }
}

/// Terms at the end of a sum in `f32` that add up to less than this, in parts of the greatest value, are left
/// out: a third of the last place of the `f32` that it is evaluated in.
const NEGLIGIBLE: f64 = 2e-8;

impl Chebyshev<f32, 3> {
    /// The sums through the values of three functions at [`chebyshev_nodes`], without terms that `f32` cannot
    /// tell from none.
    pub fn fit(values: &[[f64; 3]]) -> Self {
        let mut terms = coefficients(values);
        let size = |term: &[f64; 3]| term.iter().fold(0.0_f64, |size, c| size.max(c.abs()));
        let greatest = values.iter().map(size).fold(0.0, f64::max);
        let mut dropped = 0.0;
        while let Some(last) = terms.last() {
            dropped += size(last);
            if dropped > NEGLIGIBLE * greatest {
                break;
            }
            terms.pop();
        }
        Self { terms: terms.iter().map(|term| term.map(|c| c as f32)).collect() }
    }

    /// The three values at `x`, 0 … 1.
    #[inline(always)]
    pub fn at<R: Real>(&self, x: R) -> [R; 3] {
        self.evaluate(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_functions_come_back() {
        let series = Chebyshev::interpolate(12, libm::exp);
        for step in 0..=20 {
            let x = f64::from(step) / 20.0;
            assert!((series.at(x) - libm::exp(x)).abs() < 1e-11, "{x}");
        }
        assert_eq!(Chebyshev::<f64, 1>::default().at(0.5), 0.0);
    }

    #[test]
    fn polynomials_come_back_and_take_no_more_terms_than_they_have() {
        let f = |c: f64| [1.0, c, c * c * c - 0.5 * c];
        let series = Chebyshev::fit(&chebyshev_nodes(32).map(f).collect::<Vec<_>>());
        assert_eq!(series.len(), 4);
        for c in [0.0, 0.1, 0.5, 0.93, 1.0] {
            for (got, expected) in series.at(c).iter().zip(f(c)) {
                assert!((got - expected).abs() < 1e-6, "{c}: {got} for {expected}");
            }
        }
    }
}
