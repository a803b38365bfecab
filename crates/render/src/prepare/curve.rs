//! Tints that depend on an angle, as a series in its cosine.
//!
//! Fresnel reflection makes a tint a function of the cosine between viewer and half vector. Over that
//! cosine it is smooth up to the ends of its range, so a series of Chebyshev polynomials converges
//! fast, and sixteen pixels evaluate it without looking anything up. Source: L. N. Trefethen,
//! Approximation Theory and Approximation Practice, 2013; C. W. Clenshaw 1955.

use glanz_math::{PI, Real};

/// Places at which the function is taken, and the most terms that are kept. A test holds that they keep 1e-4 for
/// every medium that ships and for indices from 1.05 to 20.
const NODES: usize = 32;

/// Terms at the end of the series whose sum is below this share of the greatest value are left out:
/// a third of the last place of the `f32` that the series is evaluated in.
const NEGLIGIBLE: f64 = 2e-8;

/// Three channels as series in x = 2 cosθ − 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// Coefficients of the Chebyshev polynomials, of degree 0 first. None: zero everywhere.
    terms: Vec<[f32; 3]>,
}

/// The cosines at which a function must be known for [`Curve::through`].
pub(super) fn nodes() -> impl Iterator<Item = f64> {
    (0..NODES).map(|j| 0.5 * (1.0 + libm::cos(PI * (j as f64 + 0.5) / NODES as f64)))
}

impl Curve {
    /// The series through values at [`nodes`].
    pub(super) fn through(values: &[[f64; 3]]) -> Self {
        debug_assert_eq!(values.len(), NODES);
        let coefficient = |k: usize, c: usize| {
            let sum: f64 = values
                .iter()
                .enumerate()
                .map(|(j, value)| value[c] * libm::cos(PI * k as f64 * (j as f64 + 0.5) / NODES as f64))
                .sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
        };
        let mut terms: Vec<[f64; 3]> =
            (0..NODES).map(|k| core::array::from_fn(|c| coefficient(k, c))).collect();
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

    /// The three channels at a cosine between 0 and 1.
    #[inline(always)]
    pub fn at<R: Real>(&self, cosine: R) -> [R; 3] {
        let x = cosine + cosine - cosine.one();
        let two_x = x + x;
        let (mut next, mut after) = ([cosine.zero(); 3], [cosine.zero(); 3]);
        let Some((first, others)) = self.terms.split_first() else { return next };
        for term in others.iter().rev() {
            for c in 0..3 {
                let own = two_x * next[c] - after[c] + x.lit(f64::from(term[c]));
                after[c] = next[c];
                next[c] = own;
            }
        }
        for c in 0..3 {
            next[c] = x * next[c] - after[c] + x.lit(f64::from(first[c]));
        }
        next
    }

    /// How many terms the series has: its cost.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it is zero everywhere.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use std::sync::Arc;

    use glanz_color::{Ior, ior, iors, light};
    use glanz_scene::{ColorMode, Tint};

    use super::*;
    use crate::prepare::{Observation, Sampling};

    fn of(f: impl Fn(f64) -> [f64; 3]) -> Curve {
        Curve::through(&nodes().map(f).collect::<Vec<_>>())
    }

    #[test]
    fn polynomials_come_back_and_take_no_more_terms_than_they_have() {
        let curve = of(|c| [1.0, c, c * c * c - 0.5 * c]);
        assert_eq!(curve.len(), 4);
        for c in [0.0, 0.1, 0.5, 0.93, 1.0] {
            let got = curve.at(c);
            for (got, expected) in got.iter().zip([1.0, c, c * c * c - 0.5 * c]) {
                assert!((got - expected).abs() < 1e-6, "{c}: {got} for {expected}");
            }
        }
    }

    /// What the table promises: relative to the reflection itself.
    const RELATIVE: f64 = 1e-4;

    #[test]
    fn every_metal_and_glass_keeps_its_reflection_at_every_angle() {
        let sampling = Sampling::new(&Observation::new(ColorMode::Spectral, None).unwrap(), 0);
        let lights = ["D65", "A", "FL11"].map(|name| light(name).unwrap().0.to_vec());
        let mut worst: (f64, String) = (0.0, String::new());
        let numbers = [1.05, 1.5, 20.0].map(Ior::constant);
        for ior in iors().iter().map(|info| ior(info.name).unwrap()).chain(numbers) {
            let name = ior.name.clone();
            let tint = Tint::Ior(Arc::new(ior));
            let at = |cosine: f64| sampling.response(&sampling.surface(&tint, cosine), None);
            for light in &lights {
                let values: Vec<_> = nodes().map(|cosine| at(cosine).under(light)).collect();
                let curve = Curve::through(&values);
                for step in 0..=300 {
                    let cosine = f64::from(step) / 300.0;
                    let exact = at(cosine).under(light);
                    for (got, exact) in curve.at(cosine as f32).iter().zip(exact) {
                        let error = (f64::from(*got) / exact - 1.0).abs();
                        if error > worst.0 {
                            worst = (error, format!("{name} at cosθ = {cosine}"));
                        }
                    }
                }
            }
        }
        assert!(worst.0 < RELATIVE, "{worst:?}");
        assert!(worst.0 > 1e-8, "{worst:?}: f32 is not as good as that");
    }

    #[test]
    fn nothing_is_zero() {
        assert!(of(|_| [0.0; 3]).is_empty());
        assert_eq!(Curve::default().at(0.3), [0.0; 3]);
    }
}
