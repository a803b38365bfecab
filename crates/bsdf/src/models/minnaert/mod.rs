//! Minnaert's law: how the brightness of the Moon's disc falls or rises towards its limb.
//!
//! Formula, parameters, source and cost: [`Minnaert::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal: Minnaert made it the simplest law that is. Energy: the albedo is cosθoᵏ⁻¹, which is 1 along
//! the normal and less elsewhere for k > 1; for k < 1 it grows without bound towards the horizon.
//!
//! **Limits** k = 1 is Lambert's law; k = 1/2 makes a disc under light from the viewer evenly bright.
//!
//! **Notes** The factor (k+1)/2 makes the albedo along the normal that of the tint. Where cosθo is less than 1e-20
//! that is used for it.

use glanz_math::{PI, Real};

use crate::terms::above;
use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// Minnaert's lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minnaert {
    /// The exponent.
    k: f64,
}

impl Model for Minnaert {
    const INFO: ModelInfo = ModelInfo {
        name: "minnaert",
        title: "Minnaert 1941",
        formula: "(k+1)/(2π) · cosθiᵏ cosθoᵏ⁻¹",
        source: "M. Minnaert, The Reciprocity Principle in Lunar Photometry, ApJ 93, 1941",
        params: &[ParamInfo {
            name: "k",
            symbol: "k",
            doc: "limb exponent: below 1 the limb is brighter than a matte one, above 1 darker",
            min: 0.0,
            max: 10.0,
            default: 0.7,
        }],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 53,
        exempt: &[(Law::Energy, "for k < 1 the albedo cosθoᵏ⁻¹ is more than 1 off the normal")],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { k: values[0] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.k]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let power = (pair.cos_i * pair.cos_o).max(zero).pow(zero.lit(self.k));
        let value = power * zero.lit((self.k + 1.0) / (2.0 * PI)) / pair.cos_o.max(zero.lit(1e-20));
        above(pair, value)
    }
}

#[cfg(test)]
mod tests;
