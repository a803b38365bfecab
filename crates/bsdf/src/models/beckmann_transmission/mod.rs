//! Refraction by a rough boundary with Beckmann's slopes.
//!
//! **Formula** f_cos = D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²), h along −(wo + η wi) or against it,
//! so that it points up; D = exp(−tan²θh/α²) / (π α² cos⁴θh), G1 = (3.535 a + 2.181 a²) / (1 + 2.276 a + 2.577 a²) for
//! a = 1/(α tanθ) < 1.6, else 1.
//! **Parameters** `alpha`: the width of the distribution of slopes, a pure number, 0.001 … 1, default 0.2.
//! `eta`: the index of refraction below the surface over that above, 0.25 … 4, default 1.5; values nearer to 1
//! than 0.01 count as 0.01 off, since at 1 nothing is bent and the lobe has no width.
//! **Laws** reciprocal as refraction is, f(wo, wi) / η_o² = f(wi, wo) / η_i²; energy: η² times the albedo stays below 1,
//! but for 0.3 % at grazing angles, where the rational G1 is too great.
//! Radiance that arrives from a denser medium is spread, so that the albedo of a smooth boundary is 1/η²; what is written
//! for light particles leaves that factor out.
//! **Limits** towards α → 0 perfect refraction. Light that is reflected within the rough surface is lost.
//! **Source** B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough
//! Surfaces, 2007, equations 16, 21 and 23 to 34, with the factor of radiance that the paper leaves out. F is the tint.
//! **Cost** one exponential, two square roots, four quotients.

use glanz_math::{PI, Real, Vec3};

use crate::models::ggx::ALPHA;
use crate::models::refraction::ETA;
use crate::terms::{Distribution, Refracted, bending, exp_of_minus, facets, refracted_cosine, stretched2};
use crate::{Law, Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Refraction by Beckmann's slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeckmannTransmission {
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

impl Model for BeckmannTransmission {
    const INFO: ModelInfo = ModelInfo {
        name: "beckmann-transmission",
        title: "Rough refraction, Beckmann's slopes (Walter 2007)",
        formula: "D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²)",
        source: "B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007",
        params: &[ALPHA, ETA],
        term: LightTerm::Specular,
        side: Side::Transmission,
        anisotropic: false,
        delta: false,
        exempt: &[(Law::Energy, "Walter's rational form of G1 is up to 0.35 % too great: the albedo comes to 1.003 at 89°")],
    };

    fn from_params(values: &[f64]) -> Self {
        let (alpha, eta) = (values[0], values[1]);
        let square = alpha * alpha;
        Self { alpha, eta, bending: bending(eta), square, scale: 1.0 / (PI * square) }
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

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let (zero, half) = (pair.cos_o.zero(), Refracted::new(pair, self.bending));
        let inverse = zero.one() / half.up2.max(zero.lit(1e-12));
        let tan2 = (half.length2 - half.up2) * inverse;
        // D has |H|⁴ above, (wo·h)(wi·h) / (wo·h + η wi·h)² has it below.
        let d = exp_of_minus(tan2 * zero.lit(1.0 / self.square)) * inverse.sqr() * zero.lit(self.scale);
        let down = -pair.cos_i;
        let value = d * half.product * self.seen(pair.cos_o) * (self.seen(down) * down);
        value.select(half.lit, zero)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(facets::distribution(Distribution::Beckmann, half, (self.alpha, self.alpha)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(facets::shadowing_apart(Distribution::Beckmann, pair, (self.alpha, self.alpha)))
    }
}

impl BeckmannTransmission {
    /// G1 / cosθ.
    #[inline(always)]
    fn seen<R: Real>(&self, cosine: R) -> R {
        let stretched = stretched2(cosine, (cosine, cosine), (self.square, self.square)).sqrt();
        let above = stretched * cosine.lit(3.535) + cosine * cosine.lit(2.181);
        let rest = stretched * cosine.lit(2.276) + cosine * cosine.lit(2.577);
        let below = stretched.sqr() + cosine * rest;
        let shadowed = cosine.lt(stretched * cosine.lit(1.6));
        let floor = cosine.lit(1e-30);
        above.select(shadowed, cosine.one()) / below.select(shadowed, cosine).max(floor)
    }
}

#[cfg(test)]
mod tests;
