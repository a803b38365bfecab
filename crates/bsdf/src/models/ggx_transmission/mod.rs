//! Refraction by a rough boundary with GGX slopes.
//!
//! **Formula** f_cos = D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²), h along −(wo + η wi) or against it,
//! so that it points up; D = 1 / (π α² cos⁴θh (1 + tan²θh/α²)²), G1 = 2 / (1 + √(1 + α² tan²θ)).
//! **Parameters** `alpha`: the width of the distribution of slopes, a pure number, 0.001 … 1, default 0.2. A roughness texture
//! multiplies it.
//! `eta`: the index of refraction below the surface over that above, 0.25 … 4, default 1.5; values nearer to 1
//! than 0.01 count as 0.01 off, since at 1 nothing is bent and the lobe has no width.
//! **Laws** reciprocal as refraction is, f(wo, wi) / η_o² = f(wi, wo) / η_i²; energy: η² times the albedo stays below 1.
//! Radiance that arrives from a denser medium is spread, so that the albedo of a smooth boundary is 1/η²; what is written
//! for light particles leaves that factor out.
//! **Limits** towards α → 0 perfect refraction. Light that is reflected within the rough surface is lost.
//! **Source** B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough
//! Surfaces, 2007, equations 16, 21 and 23 to 34, with the factor of radiance that the paper leaves out. F is the tint.
//! **Cost** two square roots, three quotients.

use glanz_math::{PI, Real, Vec3};

use crate::models::ggx::{ALPHA, LEAST_ALPHA};
use crate::models::refraction::ETA;
use crate::terms::{Distribution, Refracted, bending, facets, refracted_cosine};
use crate::{Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Refraction by GGX slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GgxTransmission {
    /// The width of the distribution.
    pub alpha: f64,
    /// The index below over the index above.
    pub eta: f64,
    /// The index that is computed with.
    bending: f64,
    /// α², and what the lobe is multiplied with.
    square: f64,
    scale: f64,
}

impl Model for GgxTransmission {
    const INFO: ModelInfo = ModelInfo {
        name: "ggx-transmission",
        title: "Rough refraction, GGX slopes (Walter 2007)",
        formula: "D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²)",
        source: "B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007",
        params: &[ALPHA, ETA],
        term: LightTerm::Specular,
        side: Side::Transmission,
        anisotropic: false,
        delta: false,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (alpha, eta) = (values[0], values[1]);
        let square = alpha * alpha;
        Self { alpha, eta, bending: bending(eta), square, scale: 4.0 / PI }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha, self.eta]
    }

    fn eta(&self) -> f64 {
        bending(self.eta)
    }

    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        refracted_cosine(pair, self.bending)
    }

    /// With q = 1 / (|H|² − Hz² + w² α² Hz²), D (wo·h)(wi·h) / (wo·h + η wi·h)² is w² α² q² |wo·H| |wi·H| / π, where w
    /// widens.
    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let (zero, half) = (pair.cos_o.zero(), Refracted::new(pair, self.bending));
        let w = pair.alpha_scale.max(zero.lit(LEAST_ALPHA / self.alpha));
        let width2 = w.sqr() * zero.lit(self.square);
        let q = zero.one() / ((half.length2 - half.up2) + width2 * half.up2).max(zero.lit(1e-15));
        // 2 cosθ / (cosθ + √(cos²θ + α² sin²θ)) is G1.
        let down = -pair.cos_i;
        let masked = above(pair.cos_o, width2) * above(down, width2);
        let value = q.sqr() * width2 * half.product * down * zero.lit(self.scale) / masked;
        value.select(half.lit, zero)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(facets::distribution(Distribution::Ggx, half, (self.alpha, self.alpha)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(facets::shadowing_apart(Distribution::Ggx, pair, (self.alpha, self.alpha)))
    }
}

/// cosθ + √(cos²θ + α² sin²θ).
#[inline(always)]
fn above<R: Real>(cosine: R, width2: R) -> R {
    let sin2 = (cosine.one() - cosine.sqr()).max(cosine.zero());
    cosine + (cosine.sqr() + width2 * sin2).sqrt()
}

#[cfg(test)]
mod tests;
