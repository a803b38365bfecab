//! Microfacet reflection with the GGX distribution, Smith's masking and shadowing, and multiple-scattering
//! compensation.
//!
//! Formula, parameters, source and cost: [`INFO`], and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: with w = 0 the albedo falls to 0.31 at α = 1 and 0°, with w = 1 it is
//! between 0.995 and 1 for every α and angle (anisotropic surfaces: 0.994 at worst for 0.05/0.16, 0.97 for 0.2/0.6,
//! 0.94 for 0.1/0.9).
//!
//! **Limits** towards α → 0 a perfect mirror. Where both widths are equal the tangent is not read.
//!
//! **Notes** E of the compensation is a series of our own; [`ggx_multiple`](crate::models::ggx_multiple) is that
//! part alone, which may have its own tint. A roughness texture multiplies both widths.

pub use crate::microfacet::LEAST_ALPHA;
use crate::microfacet::{ALPHA, ALPHA_Y, GgxDistribution, MULTISCATTER, Smith};
use crate::{LightTerm, ModelInfo, Side};

/// GGX reflection.
pub type Ggx = Smith<GgxDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "ggx",
    title: "GGX (Walter 2007, Heitz 2014) that keeps its energy",
    formula: "D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), D = 1 / (π αx αy cos⁴θh (1 + tan²θh (cos²φh/αx² + sin²φh/αy²))²), G2 = 1 / (1 + Λo + Λi), Λ = (√(1 + α² tan²θ) − 1) / 2",
    source: "T. S. Trowbridge and K. P. Reitz, Average Irregularity Representation of a Rough Surface for Ray Reflection, 1975; B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007; E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014, equations 86 and 99; C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, 2017",
    params: &[ALPHA, ALPHA_Y, MULTISCATTER],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: true,
    delta: false,
    operations: 83,
    exempt: &[],
};

#[cfg(test)]
mod tests;
