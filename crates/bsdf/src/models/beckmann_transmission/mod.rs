//! Refraction by a rough boundary with Beckmann's slopes.
//!
//! Formula, parameters, source and cost: [`INFO`], and docs/MODELS.md.
//!
//! **Laws** reciprocal as refraction is, f(wo, wi) / η_o² = f(wi, wo) / η_i²; energy: η² times the albedo stays
//! below 1, but for 0.3 % at grazing angles, where the rational G1 is too great. Radiance that arrives from a
//! denser medium is spread, so that the albedo of a smooth boundary is 1/η²; what is written for light particles
//! leaves that factor out.
//!
//! **Limits** towards α → 0 perfect refraction. Light that is reflected within the rough surface is lost.
//!
//! **Notes** Radiance is meant, so that the paper's formula for light particles has a further factor of η².
//! Fresnel's F is the tint. At η = 1 nothing is refracted and the lobe has no width: values nearer to 1 than 0.01
//! count as 0.01 off.

use crate::microfacet::{ALPHA, BeckmannDistribution, SmithTransmission};
use crate::models::refraction::ETA;
use crate::{Law, LightTerm, ModelInfo, Side};

/// Refraction by Beckmann's slopes.
pub type BeckmannTransmission = SmithTransmission<BeckmannDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "beckmann-transmission",
    title: "Rough refraction, Beckmann's slopes (Walter 2007)",
    formula: "D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²), h along ±(wo + η wi) so that it points up, D = exp(−tan²θh/α²) / (π α² cos⁴θh), G1 = (3.535 a + 2.181 a²) / (1 + 2.276 a + 2.577 a²) for a = 1/(α tanθ) < 1.6, else 1",
    source: "B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007, equations 16, 21 and 23 to 34",
    params: &[ALPHA, ETA],
    term: LightTerm::Specular,
    side: Side::Transmission,
    anisotropic: false,
    delta: false,
    operations: 89,
    exempt: &[(
        Law::Energy,
        "Walter's rational form of G1 is up to 0.35 % too great: the albedo comes to 1.003 at 89°",
    )],
};
