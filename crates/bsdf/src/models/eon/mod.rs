//! A rough diffuse surface that conserves energy: Oren–Nayar in Fujii's form, with multiple-scattering
//! compensation.
//!
//! Formula, parameters, source and cost: [`Eon::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy, and for ρ = 1 all of it: a white furnace stays white.
//!
//! **Limits** r = 0 is Lambert's law. Unlike the paper's listing nothing is divided by 1 − Ē, so that r = 0 needs
//! no floor: (1 − Eo)(1 − Ei)/(1 − Ē) = A r g(cosθo) g(cosθi)/(k1 − k2).
//!
//! **Notes** The lobe is for a tint of ρ: the paper's f is the tint times this, and takes ρ² where light is
//! scattered more than once. The albedo is the exact one; sinθ (1 − sin³θ)/c is computed as sinθ c (1 + sinθ +
//! sin²θ)/(1 + sinθ), which is finite at the horizon. Unlike in the paper's listing nothing is divided by 1 − Ē, so
//! that r = 0 needs no floor: (1 − Eo)(1 − Ei)/(1 − Ē) = A r g(cosθo) g(cosθi)/(k1 − k2).

use glanz_math::{PI, Real};

use crate::models::oren_nayar::RHO;
use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// What roughness takes from the albedo along the normal.
const K1: f64 = 0.5 - 2.0 / (3.0 * PI);
/// What it takes and gives on average.
const K2: f64 = 2.0 / 3.0 - 28.0 / (15.0 * PI);

/// The rough diffuse lobe that conserves energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eon {
    roughness: f64,
    rho: f64,
    /// A/π, A r/π and M/π.
    c: [f64; 3],
}

impl Model for Eon {
    const INFO: ModelInfo = ModelInfo {
        name: "eon",
        title: "EON 2024",
        formula: "cosθi/π · [A (1 + r t) + M g(cosθo) g(cosθi)], t = s / max(cosθi, cosθo) where s = wo·wi − cosθi cosθo is positive, else s; A = 1/(1 + k1 r), k1 = 1/2 − 2/(3π); M = ρ Ē/(1 − ρ(1 − Ē)) · A r/(k1 − k2), Ē = A (1 + k2 r), k2 = 2/3 − 28/(15π); g(c) = k1 − [sinθ (θ − sinθ c) + ⅔ (sinθ (1 − sin³θ)/c − sinθ)]/π",
        source: "J. Portsmouth, P. Kutz and S. Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF, JCGT 14(1), 2025",
        params: &[
            ParamInfo {
                name: "roughness",
                symbol: "r",
                doc: "how rough the surface is: 0 is Lambert's law",
                min: 0.0,
                max: 1.0,
                default: 0.5,
            },
            RHO,
        ],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 99,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (roughness, rho) = (values[0], values[1]);
        let a = 1.0 / (1.0 + K1 * roughness);
        let average = a * (1.0 + K2 * roughness);
        let multiple = rho * average / (1.0 - rho * (1.0 - average)) * a * roughness / (K1 - K2);
        Self { roughness, rho, c: [a / PI, a * roughness / PI, multiple / PI] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.roughness, self.rho]
    }

    fn numbers(&self) -> Vec<f32> {
        self.c.map(|c| c as f32).to_vec()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let [even, rough, multiple] = self.c.map(|c| zero.lit(c));
        let (cos_i, cos_o) = (pair.cos_i.max(zero), pair.cos_o.max(zero));
        let s = pair.cos_io - cos_i * cos_o;
        let behind = s / cos_i.max(cos_o).max(zero.lit(1e-20));
        let single = even + rough * behind.select(zero.lt(s), s);
        cos_i * (single.max(zero) + multiple * single_loss(cos_o) * single_loss(cos_i))
    }
}

/// g: 1 − E of the single scattering of a fully rough surface, up to a factor.
#[inline(always)]
fn single_loss<R: Real>(cosine: R) -> R {
    let one = cosine.one();
    let sine = (one - cosine.sqr()).max(one.zero()).sqrt();
    let cubes = sine * cosine * (one + sine + sine.sqr()) / (one + sine);
    let g = sine * (cosine.acos() - sine * cosine) + one.lit(2.0 / 3.0) * (cubes - sine);
    (one.lit(K1) - g * one.lit(1.0 / PI)).max(one.zero())
}

#[cfg(test)]
mod tests;
