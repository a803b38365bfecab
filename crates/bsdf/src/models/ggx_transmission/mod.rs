//! Refraction by a rough boundary with GGX slopes.
//!
//! Formula, parameters, source and cost: [`INFO`], and docs/MODELS.md.
//!
//! **Laws** reciprocal as refraction is, f(wo, wi) / η_o² = f(wi, wo) / η_i²; energy: η² times the albedo stays
//! below 1. Radiance that arrives from a denser medium is spread, so that the albedo of a smooth boundary is 1/η²;
//! what is written for light particles leaves that factor out.
//!
//! **Limits** towards α → 0 perfect refraction. Light that is reflected within the rough surface is lost.
//!
//! **Notes** Radiance is meant, so that the paper's formula for light particles has a further factor of η².
//! Fresnel's F is the tint. At η = 1 nothing is refracted and the lobe has no width: values nearer to 1 than 0.01
//! count as 0.01 off. A roughness texture multiplies α.

use crate::microfacet::{ALPHA, GgxDistribution, SmithTransmission};
use crate::models::refraction::ETA;
use crate::{LightTerm, ModelInfo, Side};

/// Refraction by GGX slopes.
pub type GgxTransmission = SmithTransmission<GgxDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "ggx-transmission",
    title: "Rough refraction, GGX slopes (Walter 2007)",
    formula: "D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²), h along ±(wo + η wi) so that it points up, D = 1 / (π α² cos⁴θh (1 + tan²θh/α²)²), G1 = 2 / (1 + √(1 + α² tan²θ))",
    source: "B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007, equations 16, 21 and 23 to 34",
    params: &[ALPHA, ETA],
    term: LightTerm::Specular,
    side: Side::Transmission,
    anisotropic: false,
    delta: false,
    operations: 47,
    exempt: &[],
};
