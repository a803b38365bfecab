//! Blinn's lobe scaled so that it keeps its energy at normal incidence.
//!
//! Formula, parameters, source and cost: [`BlinnPhongNormalized::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: the albedo is 1 along the normal for every n and less elsewhere.
//!
//! **Limits** n = 0 is Lambert's law; towards n → ∞ the albedo is cos²θo: it darkens towards grazing angles even
//! more than the normalised Phong lobe.

use glanz_math::{Exponent, PI, Real};

use crate::models::phong::SHININESS;
use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// Blinn's lobe scaled so that it keeps its energy at normal incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhongNormalized {
    /// The exponent n.
    shininess: Exponent,
    /// (n+2)(n+4) / (8π (2^(−n/2) + n)).
    scale: f64,
}

impl Model for BlinnPhongNormalized {
    const INFO: ModelInfo = ModelInfo {
        name: "blinn-phong-normalized",
        title: "Blinn–Phong, energy-normalised",
        formula: "(n+2)(n+4) / (8π (2^(−n/2) + n)) · max(n·h, 0)ⁿ · cosθi",
        source: "the normalisation factor for the half-vector lobe, after F. Giesen, 2009",
        params: &[SHININESS],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 15,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let n = values[0];
        let scale = (n + 2.0) * (n + 4.0) / (8.0 * PI * (libm::exp2(-0.5 * n) + n));
        Self { shininess: Exponent::new(n), scale }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.shininess.n()]
    }

    fn numbers(&self) -> Vec<f32> {
        [&self.shininess.numbers()[..], &[self.scale as f32]].concat()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        // Rounding may leave more than 1 for the mirror direction near the horizon, which a power of 10⁵ makes infinite.
        let cosine = pair.cos_half().min(zero.one());
        let value = cosine.power(&self.shininess) * pair.cos_i * zero.lit(self.scale);
        value.select(zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests;
