//! Microfacet reflection with Smith's height-correlated masking and shadowing, and multiple-scattering compensation.

use glanz_math::{PI, Real, Vec3};

use super::compensation::Compensation;
use super::half_vector::axes;
use super::{Distribution, HalfVector, LEAST_ALPHA, factors, widths};
use crate::{DirectionPair, Model, ModelInfo};

/// f_cos = D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), over a distribution D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smith<D: Distribution> {
    /// The width along the tangent.
    alpha: f64,
    /// The width along the bitangent; 0 means as `alpha`.
    alpha_y: f64,
    /// The weight of the multiple-scattering compensation.
    multiscatter: f64,
    /// (αx², αy²) and their inverses.
    squares: (f64, f64),
    inverse2: (f64, f64),
    /// The constant factor: 1/(π αx αy) of D, 1/4, and that of G2.
    scale: f64,
    /// The factor that makes the lesser width the least allowed.
    least_scale: f64,
    compensation: Compensation<D>,
}

impl<D: Distribution> Model for Smith<D> {
    const INFO: ModelInfo = D::REFLECTION;

    fn from_params(values: &[f64]) -> Self {
        let (alpha, alpha_y, multiscatter) = (values[0], values[1], values[2]);
        let (x, y) = widths(alpha, alpha_y);
        Self {
            alpha,
            alpha_y,
            multiscatter,
            squares: (x * x, y * y),
            inverse2: (1.0 / (x * x), 1.0 / (y * y)),
            scale: 0.25 * D::G2_FACTOR / (PI * x * y),
            least_scale: LEAST_ALPHA / x.min(y),
            compensation: Compensation::new((x, y), multiscatter),
        }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha, self.alpha_y, self.multiscatter]
    }

    fn is_anisotropic(&self) -> bool {
        let (x, y) = widths(self.alpha, self.alpha_y);
        x != y
    }

    fn numbers(&self) -> Vec<f32> {
        let mut numbers = [axes(self.squares), axes(self.inverse2)].concat();
        numbers.extend([self.scale, self.least_scale, self.multiscatter].map(|number| number as f32));
        numbers.extend(self.compensation.numbers());
        numbers
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_o.zero();
        let mut value = self.single(pair);
        if self.multiscatter > 0.0 {
            value = value + self.compensation.f_cos(pair);
        }
        value.select(zero.lt(pair.cos_o) & zero.lt(pair.cos_i), zero)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(factors::d_above::<D>(half, widths(self.alpha, self.alpha_y)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(factors::g2_same_side::<D>(pair, widths(self.alpha, self.alpha_y)))
    }
}

impl<D: Distribution> Smith<D> {
    /// D · G2 / (4 cosθo) for light and viewer above.
    #[inline(always)]
    fn single<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = HalfVector::new(pair);
        let scale2 = D::alpha_scale(pair).map(
            #[inline(always)]
            |scale| scale.max(half.up2.lit(self.least_scale)).sqr(),
        );
        let d = D::d_unscaled(&half, pair, self.inverse2, scale2);
        let (numerator, denominator) = D::g2(pair, self.squares, scale2);
        d * d.lit(self.scale) * numerator / denominator.max(d.lit(1e-30))
    }
}
