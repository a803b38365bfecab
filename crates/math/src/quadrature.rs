//! Integrals: Gauss–Legendre nodes and the hemisphere.

use crate::{PI, Vec3};

/// The nodes and weights of n-point Gauss–Legendre quadrature on −1 … 1.
#[derive(Debug, Clone)]
pub struct GaussLegendre {
    /// Where to evaluate.
    pub nodes: Vec<f64>,
    /// What each value counts; the weights add up to 2.
    pub weights: Vec<f64>,
}

impl GaussLegendre {
    /// The rule with `n` points, exact for polynomials up to degree 2n − 1.
    ///
    /// Newton's method on the Legendre recurrence from the Chebyshev guess.
    pub fn new(n: usize) -> Self {
        let mut nodes = Vec::with_capacity(n);
        let mut weights = Vec::with_capacity(n);
        for i in 0..n {
            let mut x = -libm::cos(PI * (i as f64 + 0.75) / (n as f64 + 0.5));
            let mut slope = 1.0;
            for _ in 0..100 {
                let (value, derivative) = legendre(n, x);
                slope = derivative;
                let step = value / derivative;
                x -= step;
                if step.abs() < 1e-15 {
                    break;
                }
            }
            nodes.push(x);
            weights.push(2.0 / ((1.0 - x * x) * slope * slope));
        }
        Self { nodes, weights }
    }

    /// ∫ f over `low … high`.
    pub fn integrate(&self, low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
        let (half, mid) = (0.5 * (high - low), 0.5 * (high + low));
        let sum: f64 = self.nodes.iter().zip(&self.weights).map(|(x, w)| w * f(mid + half * x)).sum();
        half * sum
    }
}

/// P_n(x) and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut previous, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        let next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k;
        previous = value;
        value = next;
    }
    (value, n as f64 * (x * value - previous) / (x * x - 1.0))
}

/// ∫ f(wi) dωi over the upper hemisphere: Gauss–Legendre in cosθ, the midpoint rule in azimuth.
///
/// Narrow lobes want many points: with `n` in θ and 2n in φ, a lobe of cosine power p is integrated
/// to 1e-6 for p up to about n.
pub fn hemisphere(n: usize, mut f: impl FnMut(Vec3<f64>) -> f64) -> f64 {
    let rule = GaussLegendre::new(n);
    let azimuths = 2 * n;
    let step = 2.0 * PI / azimuths as f64;
    rule.integrate(0.0, 1.0, |cos_theta| {
        let sin_theta = libm::sqrt(1.0 - cos_theta * cos_theta);
        let ring: f64 = (0..azimuths)
            .map(|i| {
                let (sin_phi, cos_phi) = libm::sincos((i as f64 + 0.5) * step);
                f(Vec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta))
            })
            .sum();
        ring * step
    })
}

/// `n` directions spread evenly over the upper hemisphere (a Fibonacci spiral), for tests and tables.
pub fn sphere_directions(n: usize) -> impl Iterator<Item = Vec3<f64>> {
    const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
    (0..n).map(move |i| {
        let z = (i as f64 + 0.5) / n as f64;
        Vec3::from_angles(libm::acos(z), i as f64 * GOLDEN_ANGLE)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_legendre_is_exact_for_polynomials() {
        let rule = GaussLegendre::new(8);
        let got = rule.integrate(0.0, 2.0, |x| libm::pow(x, 15.0));
        assert!((got / 4096.0 - 1.0).abs() < 1e-13);
        assert!((rule.weights.iter().sum::<f64>() - 2.0).abs() < 1e-14);
    }

    #[test]
    fn the_cosine_over_the_hemisphere_is_pi() {
        assert!((hemisphere(16, |w| w.z) - PI).abs() < 1e-12);
    }
}
