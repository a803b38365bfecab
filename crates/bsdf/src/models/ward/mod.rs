//! Ward's highlight: a Gaussian of the slope, with one width along the tangent and one along the bitangent.
//!
//! Formula, parameters, source and cost: [`Ward::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal. Energy: lost where the view is flat, for the albedo of a narrow highlight is cosθo (αx = αy
//! = 0.2 returns 0.895 at 0°, 0.638 at 45°, 0.459 at 60°, 0.269 at 75°, 0.182 at 85°): at the mirror direction
//! f_cos is the same for every angle, while the solid angle of the highlight shrinks with cosθ. Within a quarter of
//! a degree of the horizon f_cos grows like 1/√cosθo and the highlight, which no longer narrows, reflects more than
//! arrives (2.1 at 89.99°).
//!
//! **Limits** α → 0 is a mirror of reflectance cosθ. Ward states the formula for widths up to about 0.2.
//!
//! **Notes** In the form of B. Walter, Notes on the Ward BRDF, 2005, with H = wi + wo not normalised. Where both
//! cosines multiply to less than 1e-30 that is used for them. Values of αy below 0.001 count as 0.001.

use glanz_math::Real;

use crate::terms::{ALPHA, ALPHA_Y, WardFactor, WardLobe, Widths, height_squared};
use crate::{DirectionPair, Law, LightTerm, ModelInfo, Side};

/// Ward's highlight.
pub type Ward = WardLobe<Ward1992>;

/// The factor 1/√(cosθi cosθo) of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ward1992;

impl WardFactor for Ward1992 {
    const INFO: ModelInfo = ModelInfo {
        name: "ward",
        title: "Ward 1992",
        formula: "cosθi · exp(−[(hx/αx)² + (hy/αy)²] / hz²) / (4π αx αy √(cosθi cosθo))",
        source: "G. J. Ward, Measuring and Modeling Anisotropic Reflection, SIGGRAPH 1992",
        params: &[ALPHA, ALPHA_Y],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        operations: 45,
        exempt: &[(
            Law::Energy,
            "f_cos grows like 1/√cosθo: views within a quarter of a degree of the horizon get more than arrives",
        )],
    };

    #[inline(always)]
    fn f_cos<R: Real>(widths: &Widths, pair: &DirectionPair<R>) -> R {
        let height = height_squared(pair);
        let root = (pair.cos_i * pair.cos_o).max(pair.cos_i.lit(1e-30)).sqrt();
        // One division gives both reciprocals.
        let both = pair.cos_i.one() / (height * root);
        let lobe = widths.highlight_with(pair, both * root);
        pair.cos_i * (both * height) * lobe.gauss * both.lit(0.25 * widths.height)
    }
}

#[cfg(test)]
mod tests;
