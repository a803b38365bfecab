//! A rough diffuse surface: V-shaped grooves with Lambertian walls, with masking, shadowing and interreflection.
//!
//! Formula, parameters, source and cost: [`OrenNayar::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal. Energy: the paper's fit of its integrals does not mind it. For σ up to 35° a grazing view
//! gets more than arrives, 1.05 at most (σ = 17°); rougher surfaces lose (σ = 90° returns 0.72 at 0°).
//!
//! **Limits** σ = 0 is Lambert's law. The fit has no floor: L1 + L2 falls below 0 for forward light at grazing
//! angles of very rough surfaces; that counts as 0.
//!
//! **Notes** The functional model with interreflection. The lobe is for a tint of ρ: the tint multiplies L1 + ρ L2,
//! and the paper's radiance comes out where both agree. The angles α and β enter through sinα, tanβ and
//! tan((α+β)/2) = (sinα + sinβ) / (cosα + cosβ), so that only the powers of β need an arc cosine.

use glanz_math::{PI, Real};

use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The roughness of both models of this paper, as files and command line name it.
pub(crate) const SIGMA_DEG: ParamInfo = ParamInfo {
    name: "sigma_deg",
    symbol: "σ",
    doc: "standard deviation of the slope angle of the grooves, in degrees",
    min: 0.0,
    max: 90.0,
    default: 20.0,
};

/// The reflectance that light scattered more than once takes.
pub(crate) const RHO: ParamInfo = ParamInfo {
    name: "rho",
    symbol: "ρ",
    doc: "reflectance at every scattering after the first; the tint's own value fits",
    min: 0.0,
    max: 1.0,
    default: 1.0,
};

/// Keeps quotients of vanishing sines and cosines finite; what they multiply vanishes faster.
const NOTHING: f64 = 1e-20;

/// The rough diffuse lobe with interreflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayar {
    sigma_deg: f64,
    rho: f64,
    /// C1, and what C2, C3 and L2 have in σ.
    c: [f64; 4],
}

impl Model for OrenNayar {
    const INFO: ModelInfo = ModelInfo {
        name: "oren-nayar",
        title: "Oren–Nayar 1994",
        formula: "cosθi/π · max(0, L1 + ρ L2), L1 = C1 + C2 cosφ tanβ + (1 − |cosφ|) C3 tan((α+β)/2), L2 = 0.17 σ²/(σ²+0.13) (1 − cosφ (2β/π)²), C1 = 1 − 0.5 σ²/(σ²+0.33), C2 = 0.45 σ²/(σ²+0.09) (sinα − (where cosφ < 0) (2β/π)³), C3 = 0.125 σ²/(σ²+0.09) (4αβ/π²)², α = max(θi, θo), β = min(θi, θo)",
        source: "M. Oren and S. K. Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994",
        params: &[SIGMA_DEG, RHO],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 96,
        exempt: &[
            (Law::Energy, "a fit of integrals: for σ up to 35° grazing views get up to 1.05"),
            (
                Law::Precision,
                "for σ near 90° terms cancel at the horizon: with both directions at 89.99° f32 is 0.5 % off",
            ),
        ],
    };

    fn from_params(values: &[f64]) -> Self {
        let (sigma_deg, rho) = (values[0], values[1]);
        let variance = variance(sigma_deg);
        let part = |offset: f64| variance / (variance + offset);
        let c = [1.0 - 0.5 * part(0.33), 0.45 * part(0.09), 0.125 * part(0.09), 0.17 * rho * part(0.13)];
        Self { sigma_deg, rho, c }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.sigma_deg, self.rho]
    }

    fn numbers(&self) -> Vec<f32> {
        self.c.map(|c| c as f32).to_vec()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let (one, nothing) = (zero.one(), zero.lit(NOTHING));
        let [c1, c2, c3, l2] = self.c.map(|c| zero.lit(c));
        let (cos_i, cos_o) = (pair.cos_i.max(zero), pair.cos_o.max(zero));
        let (cos_a, cos_b) = (cos_i.min(cos_o), cos_i.max(cos_o));
        let sine = |cosine: R| (one - cosine.sqr()).max(zero).sqrt();
        let (sin_a, sin_b) = (sine(cos_a), sine(cos_b));
        // sinα sinβ cosφ.
        let s = pair.cos_io - cos_i * cos_o;
        let cos_phi = (s / (sin_a * sin_b).max(nothing)).clamp(-1.0, 1.0);
        let (a, b) = (cos_a.acos() * zero.lit(2.0 / PI), cos_b.acos() * zero.lit(2.0 / PI));
        let forward = cos_phi.min(zero) * sin_b * (b.sqr() * b);
        let grooves = c2 * (s - forward) / cos_b.max(nothing);
        let sides =
            (one - cos_phi.abs()) * c3 * (a * b).sqr() * (sin_a + sin_b) / (cos_a + cos_b).max(nothing);
        let between = l2 * (one - cos_phi * b.sqr());
        cos_i * zero.lit(1.0 / PI) * (c1 + grooves + sides + between).max(zero)
    }
}

/// σ² in square radians.
pub(crate) fn variance(sigma_deg: f64) -> f64 {
    let sigma = sigma_deg * PI / 180.0;
    sigma * sigma
}

#[cfg(test)]
mod tests;
