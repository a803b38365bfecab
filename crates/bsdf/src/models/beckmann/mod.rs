//! Microfacets with Beckmann's slopes and Smith's shadowing, with the energy of further reflections.
//!
//! **Formula** f_cos = D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)),
//! D = exp(−tan²θh (cos²φh/αx² + sin²φh/αy²)) / (π αx αy cos⁴θh), G2 = 1 / (1 + Λo + Λi),
//! Λ = (1 − 1.259 a + 0.396 a²) / (3.535 a + 2.181 a²) for a = 1/(α tanθ) < 1.6, else 0.
//! **Parameters** `alpha`, `alpha_y`: the widths along tangent and bitangent, root mean square slopes times √2, pure
//! numbers, 0.001 … 1, default 0.2; `alpha_y` 0, the default, means as `alpha`. `multiscatter`: the weight w, 0 … 1,
//! default 1.
//! **Laws** reciprocal; keeps energy: with w = 1 the albedo is between 0.995 and 1 for every α and angle
//! (elongated surfaces: 0.994 at worst for 0.05/0.16, 0.97 for 0.2/0.6, 0.89 for 0.1/0.9).
//! **Limits** towards α → 0 a perfect mirror. Where both widths are equal tangents are not read.
//! **Source** P. Beckmann and A. Spizzichino 1963; B. Walter and others, Microfacet Models for Refraction through Rough
//! Surfaces, 2007, whose rational Λ stands for the exact one with erf (within 0.35 %); E. Heitz, Understanding the
//! Masking-Shadowing Function, 2014, equations 77 and 99; C. Kulla and A. Conty 2017 for the second part, with a series
//! of our own for E.
//! **Cost** one exponential, two square roots, two quotients; two more quotients for the second part.

use crate::microfacet::{BeckmannDistribution, Smith, ALPHA, ALPHA_Y, MULTISCATTER};
use crate::{LightTerm, ModelInfo, Side};

/// Reflection by Beckmann's slopes.
pub type Beckmann = Smith<BeckmannDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "beckmann",
    title: "Beckmann with Smith's shadowing (Walter 2007, Heitz 2014) that keeps its energy",
    formula: "D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), D = exp(−tan²θh/α²) / (π α² cos⁴θh)",
    source: "P. Beckmann and A. Spizzichino, The Scattering of Electromagnetic Waves from Rough Surfaces, 1963; E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014; C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, 2017",
    params: &[ALPHA, ALPHA_Y, MULTISCATTER],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: true,
    delta: false,
    operations: 127,
    exempt: &[],
};
