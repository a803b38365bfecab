//! Oren and Nayar's rough diffuse surface in its short form, which most renderers mean by the name.
//!
//! Formula, parameters, source and cost: [`OrenNayarQualitative::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal. Energy: both ways wrong, see the exemption. Slightly rough surfaces (σ up to about 20°)
//! return up to 1.5 % more than arrives to a grazing view, and very rough ones lose a third, since light that meets
//! two walls is left out.
//!
//! **Limits** σ = 0 is Lambert's law. All light off the plane of view and forward gets the same dark value A/π,
//! with a crease where cosφ passes 0: the dark ring on spheres lit from the side.
//!
//! **Notes** The qualitative model; cosφ sinα tanβ = (wo·wi − cosθo cosθi) / max(cosθo, cosθi) needs no angle.

use glanz_math::{PI, Real};

use crate::models::oren_nayar::{SIGMA_DEG, variance};
use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, Side};

/// The short form of the rough diffuse lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayarQualitative {
    sigma_deg: f64,
    /// A/π and B/π.
    c: [f64; 2],
}

impl Model for OrenNayarQualitative {
    const INFO: ModelInfo = ModelInfo {
        name: "oren-nayar-qualitative",
        title: "Oren–Nayar 1994, qualitative",
        formula: "cosθi/π · (A + B max(0, cosφ) sinα tanβ), A = 1 − 0.5 σ²/(σ²+0.33), B = 0.45 σ²/(σ²+0.09), α = max(θi, θo), β = min(θi, θo)",
        source: "M. Oren and S. K. Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994",
        params: &[SIGMA_DEG],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 11,
        exempt: &[(
            Law::Energy,
            "for σ below about 20° B outgrows what A takes: grazing views get up to 1.015",
        )],
    };

    fn from_params(values: &[f64]) -> Self {
        let variance = variance(values[0]);
        let a = 1.0 - 0.5 * variance / (variance + 0.33);
        let b = 0.45 * variance / (variance + 0.09);
        Self { sigma_deg: values[0], c: [a / PI, b / PI] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.sigma_deg]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let [a, b] = self.c.map(|c| zero.lit(c));
        let (cos_i, cos_o) = (pair.cos_i.max(zero), pair.cos_o.max(zero));
        let behind = (pair.cos_io - cos_i * cos_o).max(zero);
        cos_i * (a + b * behind / cos_i.max(cos_o).max(zero.lit(1e-20)))
    }
}

#[cfg(test)]
mod tests;
