//! Microfacet reflection with Beckmann's distribution, Smith's masking and shadowing, and multiple-scattering
//! compensation.
//!
//! Formula, parameters, source and cost: [`INFO`], and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: with w = 1 the albedo is between 0.995 and 1 for every α and angle
//! (anisotropic surfaces: 0.994 at worst for 0.05/0.16, 0.97 for 0.2/0.6, 0.89 for 0.1/0.9).
//!
//! **Limits** towards α → 0 a perfect mirror. Where both widths are equal the tangent is not read.
//!
//! **Notes** Walter's rational Λ stands for the exact one with erf (within 0.35 %); E of the compensation is a
//! series of our own.

use crate::microfacet::{ALPHA, ALPHA_Y, BeckmannDistribution, MULTISCATTER, Smith};
use crate::{LightTerm, ModelInfo, Side};

/// Reflection by Beckmann's slopes.
pub type Beckmann = Smith<BeckmannDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "beckmann",
    title: "Beckmann with Smith's shadowing (Walter 2007, Heitz 2014) that keeps its energy",
    formula: "D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), D = exp(−tan²θh (cos²φh/αx² + sin²φh/αy²)) / (π αx αy cos⁴θh), G2 = 1 / (1 + Λo + Λi), Λ = (1 − 1.259 a + 0.396 a²) / (3.535 a + 2.181 a²) for a = 1/(α tanθ) < 1.6, else 0",
    source: "P. Beckmann and A. Spizzichino, The Scattering of Electromagnetic Waves from Rough Surfaces, 1963; B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007 (rational Λ); E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014, equations 77 and 99; C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, 2017",
    params: &[ALPHA, ALPHA_Y, MULTISCATTER],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: true,
    delta: false,
    operations: 125,
    exempt: &[],
};
