//! Diffuse transmission of a thin sheet, such as a leaf or a lampshade.
//!
//! Formula, parameters, source and cost: [`LambertTransmission::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: all light from the other side leaves, in all directions alike.

use glanz_math::{PI, Real};

use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// Lambert's law for light from behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LambertTransmission;

impl Model for LambertTransmission {
    const INFO: ModelInfo = ModelInfo {
        name: "lambert-transmission",
        title: "Lambert's law for light from behind",
        formula: "max(−cosθi, 0) / π",
        source: "J. H. Lambert, Photometria, 1760",
        params: &[],
        term: LightTerm::Diffuse,
        side: Side::Transmission,
        anisotropic: false,
        delta: false,
        operations: 3,
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
        let zero = pair.cos_i.zero();
        let value = -pair.cos_i * zero.lit(1.0 / PI);
        value.select(pair.cos_i.lt(zero) & zero.lt(pair.cos_o), zero)
    }
}

#[cfg(test)]
mod tests;
