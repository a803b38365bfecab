//! Multiple-scattering compensation as a lobe of its own, which may have its own tint.

use glanz_math::Real;

use super::compensation::Compensation;
use super::{Distribution, widths};
use crate::{DirectionPair, Model, ModelInfo};

/// f_cos = (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), over the distribution whose single reflections have the albedo E.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmithMultiple<D: Distribution> {
    /// The width along the tangent.
    alpha: f64,
    /// The width along the bitangent; 0 means as `alpha`.
    alpha_y: f64,
    compensation: Compensation<D>,
}

impl<D: Distribution> Model for SmithMultiple<D> {
    const INFO: ModelInfo = D::MULTIPLE;

    fn from_params(values: &[f64]) -> Self {
        let (alpha, alpha_y) = (values[0], values[1]);
        Self { alpha, alpha_y, compensation: Compensation::new(widths(alpha, alpha_y), 1.0) }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha, self.alpha_y]
    }

    fn is_anisotropic(&self) -> bool {
        let (x, y) = widths(self.alpha, self.alpha_y);
        x != y
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_o.zero();
        let value = self.compensation.f_cos(pair);
        value.select(zero.lt(pair.cos_o) & zero.lt(pair.cos_i), zero)
    }
}
