//! The diffuse part of Ashikhmin and Shirley's model: the substrate below a glossy coat.
//!
//! Formula, parameters, source and cost: [`AshikhminShirleyDiffuse::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: seen at θo the albedo is (1 − Rs) (1 − (1 − cosθo/2)⁵), at most 31/32.
//!
//! **Limits** at the horizon all is reflected by the coat and the lobe vanishes. Rs = 1 is black.
//!
//! **Notes** The tint is the paper's Rd; since Rs may not depend on the wavelength here, metals and other coloured
//! coats take an average. The default of Rs is that of an index of 1.5.

use glanz_math::{PI, Real};

use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The diffuse lobe below a coat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AshikhminShirleyDiffuse {
    /// The reflectance of the coat along the normal.
    rs: f64,
}

impl Model for AshikhminShirleyDiffuse {
    const INFO: ModelInfo = ModelInfo {
        name: "ashikhmin-shirley-diffuse",
        title: "Ashikhmin–Shirley 2000, diffuse",
        formula: "cosθi · 28/(23π) · (1 − Rs) (1 − (1 − cosθi/2)⁵) (1 − (1 − cosθo/2)⁵)",
        source: "M. Ashikhmin and P. Shirley, An Anisotropic Phong BRDF Model, JGT 5(2), 2000",
        params: &[ParamInfo {
            name: "rs",
            symbol: "Rs",
            doc: "reflectance of the glossy coat along the normal",
            min: 0.0,
            max: 1.0,
            default: 0.04,
        }],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 17,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { rs: values[0] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.rs]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let (cos_i, cos_o) = (pair.cos_i.max(zero), pair.cos_o.max(zero));
        cos_i
            * coat_transmittance(cos_i)
            * coat_transmittance(cos_o)
            * zero.lit(28.0 / (23.0 * PI) * (1.0 - self.rs))
    }
}

/// 1 − (1 − cosθ/2)⁵, the paper's stand-in for the transmittance of the coat.
#[inline(always)]
fn coat_transmittance<R: Real>(cosine: R) -> R {
    let rest = cosine.one() - cosine * cosine.lit(0.5);
    cosine.one() - rest.sqr().sqr() * rest
}

#[cfg(test)]
mod tests;
