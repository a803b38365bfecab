//! A perfectly smooth boundary to another medium: refraction as a delta lobe.
//!
//! Formula, parameters, source and cost: [`Refraction::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** trivially reciprocal and within its energy as a delta lobe; radiance is divided by η², as that of all
//! that is refracted.
//!
//! **Limits** η = 1 lets light pass as if there were no surface. For η < 1 nothing passes beyond the angle of total
//! reflection.
//!
//! **Notes** It refracts environment maps, not other lights.

use glanz_math::Real;

use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The index below over the index above.
pub const ETA: ParamInfo = ParamInfo {
    name: "eta",
    symbol: "η",
    doc: "index of refraction below the surface over that above it",
    min: 0.25,
    max: 4.0,
    default: 1.5,
};

/// Refraction at a perfectly smooth boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction {
    /// The index below over the index above.
    eta: f64,
}

impl Model for Refraction {
    const INFO: ModelInfo = ModelInfo {
        name: "refraction",
        title: "Perfect refraction",
        formula: "0, but for the one direction with sinθt = sinθo / η",
        source: "W. Snellius, 1621; the factor of radiance in E. Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, §5.2",
        params: &[ETA],
        term: LightTerm::Specular,
        side: Side::Transmission,
        anisotropic: false,
        delta: true,
        operations: 0,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { eta: values[0] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.eta]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.zero()
    }

    fn eta(&self) -> f64 {
        self.eta
    }

    /// The cosine of the view angle: the facet is the surface.
    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_o.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests;
