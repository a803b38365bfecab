//! Cook and Torrance's reflection with the simpler distribution of their paper: angles of facets spread as a
//! Gaussian.
//!
//! Formula, parameters, source and cost: [`CookTorranceGaussian::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy.
//!
//! **Limits** towards m → 0 Beckmann's distribution of the same m, and a perfect mirror; at m = 0.5 the peak is
//! 1.16 times as high.
//!
//! **Notes** The paper calls c arbitrary. Here it is such that the facets cover the surface, 1/∫ exp(−(θ/m)²) cosθ
//! dω, about 1/(π m²), so that the lobe conserves energy.

use glanz_math::{Real, Vec3};

use crate::microfacet::HalfVector;
use crate::models::cook_torrance::{M, groove};
use crate::terms::{d_gaussian, g_v_cavity, gaussian_scale};
use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// Cook and Torrance's reflection with the Gaussian distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CookTorranceGaussian {
    /// The spread m in radians.
    m: f64,
    /// The constant c.
    scale: f64,
}

impl Model for CookTorranceGaussian {
    const INFO: ModelInfo = ModelInfo {
        name: "cook-torrance-gaussian",
        title: "Cook–Torrance 1982, Gaussian angles",
        formula: "D · G / (4 cosθo), D = c exp(−(θh/m)²), G = min(1, 2 (n·h)(n·wo)/(wo·h), 2 (n·h)(n·wi)/(wo·h))",
        source: "R. L. Cook and K. E. Torrance, A Reflectance Model for Computer Graphics, ACM Transactions on Graphics 1(1), 1982",
        params: &[ParamInfo {
            doc: "spread of the angles of the facets, in radians: greater is rougher",
            ..M
        }],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 74,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { m: values[0], scale: gaussian_scale(values[0]) }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.m]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = HalfVector::new(pair);
        // From sine and cosine: an arc cosine alone is coarse about 0.
        let theta = (half.length2 - half.up2).sqrt().atan2(half.up2.sqrt());
        let d = d_gaussian(theta, theta.lit(self.m), theta.lit(self.scale));
        d * groove(pair, half.length2)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        let across = (half.x * half.x + half.y * half.y).sqrt();
        Some(if half.z > 0.0 { d_gaussian(across.atan2(half.z), self.m, self.scale) } else { 0.0 })
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(g_v_cavity(pair.cos_half(), pair.cos_o, pair.cos_i, pair.cos_view_half()))
    }
}

#[cfg(test)]
mod tests;
