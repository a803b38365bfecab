//! The Phong lobe scaled so that it keeps its energy whatever the exponent.
//!
//! Formula, parameters, source and cost: [`PhongNormalized::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: the albedo is 1 along the normal for every n and less elsewhere.
//!
//! **Limits** n = 0 is Lambert's law; towards n → ∞ the albedo is cosθo, not 1, so a mirror of this kind darkens
//! towards grazing angles. Part of the lobe is below the horizon there and is lost as well.

use glanz_math::{Exponent, PI, Real};

use crate::models::phong::SHININESS;
use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// The Phong lobe scaled so that it keeps its energy whatever the exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhongNormalized {
    /// The exponent n.
    shininess: Exponent,
    /// (n+2)/(2π).
    scale: f64,
}

impl Model for PhongNormalized {
    const INFO: ModelInfo = ModelInfo {
        name: "phong-normalized",
        title: "Phong, energy-normalised (Lewis 1994)",
        formula: "(n+2)/(2π) · max(R·wo, 0)ⁿ · cosθi",
        source: "R. R. Lewis, Making Shaders More Physically Plausible, Computer Graphics Forum 13(2), 1994",
        params: &[SHININESS],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 12,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let shininess = values[0];
        Self { shininess: Exponent::new(shininess), scale: (shininess + 2.0) / (2.0 * PI) }
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
        // Below 0 it counts as 0.
        let cosine = pair.cos_mirror();
        // A shortcut that changes no bit.
        if !R::any(zero.lit(self.shininess.dark_up_to()).lt(cosine)) {
            return zero;
        }
        let value = cosine.power(&self.shininess) * pair.cos_i * zero.lit(self.scale);
        value.select(zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests;
