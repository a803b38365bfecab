//! The anisotropic Phong lobe of Ashikhmin and Shirley: reciprocal, and close to energy conservation.
//!
//! Formula, parameters, source and cost: [`AshikhminShirley::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy, though not all of it: with F = 1 the exponent 100 returns 0.961 at 0°,
//! 0.846 at 60°, and every exponent half of the light at the horizon.
//!
//! **Limits** n → ∞ is a perfect mirror of reflectance 1.
//!
//! **Notes** The specular part for F = 1: Fresnel's law (there Schlick's) is a tint. With H = wi + wo not
//! normalised, (n·h)^… = exp(−(nu Hx² + nv Hy²)/(2 Hz²) · ln(1 + x)/x), x = (Hx² + Hy²)/Hz²; ln(1 + x)/x comes from
//! a series where the light is near the mirror direction, so that great exponents cost no digits.

use core::f64::consts::LOG2_E;

use glanz_math::{PI, Real};

use crate::terms::{above, exp2_or_zero, height_squared};
use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// Below this x the series is used: its first term left out is 1/15 · (x/(2+x))¹⁴ = 3e-15 there.
const SERIES_UP_TO: f64 = 0.25;

/// The anisotropic Phong lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AshikhminShirley {
    nu: f64,
    nv: f64,
    /// Half of both exponents as used.
    halves: (f64, f64),
    /// √((nu+1)(nv+1)) / (4π): with |H| = 2 wo·h the formula has twice the paper's factor.
    height: f64,
}

impl Model for AshikhminShirley {
    const INFO: ModelInfo = ModelInfo {
        name: "ashikhmin-shirley",
        title: "Ashikhmin–Shirley 2000, specular",
        formula: "cosθi · √((nu+1)(nv+1))/(8π) · (n·h)^((nu hx² + nv hy²)/(1 − hz²)) / (wo·h · max(cosθi, cosθo))",
        source: "M. Ashikhmin and P. Shirley, An Anisotropic Phong BRDF Model, JGT 5(2), 2000",
        params: &[
            ParamInfo {
                name: "nu",
                symbol: "nu",
                doc: "exponent along the tangent: the greater, the narrower the highlight",
                min: 0.0,
                max: 1e5,
                default: 100.0,
            },
            ParamInfo {
                name: "nv",
                symbol: "nv",
                doc: "exponent across the tangent; 0: as nu",
                min: 0.0,
                max: 1e5,
                default: 0.0,
            },
        ],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        operations: 91,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (nu, nv) = (values[0], values[1]);
        let across = if nv > 0.0 { nv } else { nu };
        let height = libm::sqrt((nu + 1.0) * (across + 1.0)) / (4.0 * PI);
        Self { nu, nv, halves: (0.5 * nu, 0.5 * across), height }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.nu, self.nv]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let one = pair.cos_i.one();
        let x2 = (pair.tangent_o.0 + pair.tangent_i.0).sqr();
        let y2 = (pair.tangent_o.1 + pair.tangent_i.1).sqr();
        let z2 = height_squared(pair);
        let per_z2 = one / z2;
        let exponent = (x2 * one.lit(self.halves.0) + y2 * one.lit(self.halves.1)) * per_z2;
        let flat = x2 + y2;
        let power = exp2_or_zero(-(exponent * log2_1p_per_x(flat * per_z2)));
        let length = (flat + z2).sqrt();
        let value = pair.cos_i * one.lit(self.height) * power / (length * pair.cos_i.max(pair.cos_o));
        above(pair, value)
    }
}

/// log₂(1 + x) / x for x >= 0, with as many digits as the numbers have.
#[inline(always)]
fn log2_1p_per_x<R: Real>(x: R) -> R {
    let near = x.lt(x.lit(SERIES_UP_TO));
    let per = x.one() / (x + x.lit(2.0)).select(near, x.max(x.lit(SERIES_UP_TO)));
    // ln(1 + x) = 2 artanh(x / (2 + x)).
    let y2 = (x * per).sqr();
    let mut series = x.lit(1.0 / 13.0);
    for odd in [11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
        series = series * y2 + x.lit(1.0 / odd);
    }
    (series * x.lit(2.0 * LOG2_E)).select(near, (x + x.one()).log2()) * per
}

#[cfg(test)]
mod tests;
