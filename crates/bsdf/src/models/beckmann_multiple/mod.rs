//! What a surface of Beckmann's slopes sends out after more than one reflection, as a lobe that may have a tint of its own.
//!
//! **Formula** f_cos = (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), with E the directional albedo of single reflections
//! and Eavg its mean over diffuse light.
//! **Parameters** `alpha`, `alpha_y`: as of [`beckmann`](crate::models::beckmann), whose second part this is.
//! **Laws** reciprocal; keeps energy: the albedo is 1−E(wo), to half a percent from below (elongated surfaces: see there).
//! **Limits** towards α → 0 it vanishes. Where both widths are equal tangents are not read.
//! **Source** C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH course, 2017. Light
//! reflected twice has met Fresnel's law twice: the tint is F²avg Eavg / (1 − Favg (1 − Eavg)), for which
//! [`smith_albedo_average`](crate::terms::smith_albedo_average) gives Eavg.
//! **Cost** two quotients, two polynomials.

use glanz_math::Real;

use crate::models::ggx::{ALPHA, ALPHA_Y, widths};
use crate::terms::{Distribution, MultiScatter};
use crate::{Model, ModelInfo, DirectionPair, LightTerm, Side};

/// The energy of further reflections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeckmannMultiple {
    /// The width along the tangent.
    pub alpha: f64,
    /// The width along the bitangent; 0 means as `alpha`.
    pub alpha_y: f64,
    compensation: MultiScatter,
}

impl Model for BeckmannMultiple {
    const INFO: ModelInfo = ModelInfo {
        name: "beckmann-multiple",
        title: "Beckmann's slopes, reflected more than once (Kulla and Conty 2017)",
        formula: "(1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg))",
        source: "C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH course, 2017",
        params: &[ALPHA, ALPHA_Y],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (alpha, alpha_y) = (values[0], values[1]);
        Self { alpha, alpha_y, compensation: MultiScatter::new(Distribution::Beckmann, widths(alpha, alpha_y), 1.0) }
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
        let value = self.compensation.f_cos(pair, None);
        value.select(zero.lt(pair.cos_o) & zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests;
