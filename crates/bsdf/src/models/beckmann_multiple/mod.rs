//! Multiple-scattering compensation of Beckmann's microfacets, as a lobe that may have its own tint.
//!
//! Formula, parameters, source and cost: [`INFO`], and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: the albedo is 1−E(wo), to half a percent from below (anisotropic
//! surfaces: see there).
//!
//! **Limits** towards α → 0 it vanishes. Where both widths are equal the tangent is not read.
//!
//! **Notes** The second part of [`beckmann`](crate::models::beckmann). Light reflected twice has met Fresnel's law
//! twice: the tint is F²avg Eavg / (1 − Favg (1 − Eavg)), for which
//! [`smith_albedo_average`](crate::microfacet::smith_albedo_average) gives Eavg.

use crate::microfacet::{ALPHA, ALPHA_Y, BeckmannDistribution, SmithMultiple};
use crate::{LightTerm, ModelInfo, Side};

/// The multiple-scattering compensation of [`beckmann`](crate::models::beckmann).
pub type BeckmannMultiple = SmithMultiple<BeckmannDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "beckmann-multiple",
    title: "Beckmann's slopes, reflected more than once (Kulla and Conty 2017)",
    formula: "(1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), E the directional albedo of single reflections, Eavg its mean over diffuse light",
    source: "C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH course, 2017",
    params: &[ALPHA, ALPHA_Y],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: true,
    delta: false,
    operations: 46,
    exempt: &[],
};
