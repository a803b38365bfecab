//! What a surface of Beckmann's slopes sends out after more than one reflection, as a lobe that may have a tint of its own.
//!
//! **Formula** f_cos = (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), with E the directional albedo of single reflections
//! and Eavg its mean over diffuse light.
//! **Parameters** `alpha`, `alpha_y`: as of [`beckmann`](crate::models::beckmann), whose second part this is.
//! **Laws** reciprocal; keeps energy: the albedo is 1−E(wo), to half a percent from below (elongated surfaces: see there).
//! **Limits** towards α → 0 it vanishes. Where both widths are equal tangents are not read.
//! **Source** C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH course, 2017. Light
//! reflected twice has met Fresnel's law twice: the tint is F²avg Eavg / (1 − Favg (1 − Eavg)), for which
//! [`smith_albedo_average`](crate::terms::smith_albedo_average) gives Eavg.
//! **Cost** two quotients, two polynomials.

use crate::microfacet::{BeckmannDistribution, SmithMultiple, ALPHA, ALPHA_Y};
use crate::{LightTerm, ModelInfo, Side};

/// The multiple-scattering compensation of [`beckmann`](crate::models::beckmann).
pub type BeckmannMultiple = SmithMultiple<BeckmannDistribution>;

/// What the model tells about itself.
pub const INFO: ModelInfo = ModelInfo {
    name: "beckmann-multiple",
    title: "Beckmann's slopes, reflected more than once (Kulla and Conty 2017)",
    formula: "(1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg))",
    source: "C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, SIGGRAPH course, 2017",
    params: &[ALPHA, ALPHA_Y],
    term: LightTerm::Specular,
    side: Side::Reflection,
    anisotropic: true,
    delta: false,
    operations: 46,
    exempt: &[],
};
