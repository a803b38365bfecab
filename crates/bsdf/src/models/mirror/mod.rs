//! A perfect mirror: a delta lobe.
//!
//! Formula, parameters, source and cost: [`Mirror::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** trivially reciprocal and within its energy as a delta lobe.
//!
//! **Notes** It reflects environment maps and area lights, not punctual lights.

use glanz_math::Real;

use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// A perfect mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror;

impl Model for Mirror {
    const INFO: ModelInfo = ModelInfo {
        name: "mirror",
        title: "Perfect mirror",
        formula: "0, but for the one direction with θi = θo on the other side of the normal",
        source: "Euclid, Catoptrics",
        params: &[],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: true,
        operations: 0,
        exempt: &[],
    };

    fn from_params(_values: &[f64]) -> Self {
        Self
    }

    fn params(&self) -> Vec<f64> {
        Vec::new()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.zero()
    }

    /// The cosine of the view angle: the facet is the surface.
    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests;
