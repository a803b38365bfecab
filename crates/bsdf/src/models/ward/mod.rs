//! Ward's highlight: a Gaussian of the slope, with one width along the grain of a surface and one across it.
//!
//! **Formula** f_cos = cosθi · e / (4π αx αy √(cosθi cosθo)), e = exp(−[(hx/αx)² + (hy/αy)²] / hz²).
//! **Parameters** `alpha`: αx, the width along the tangent, a slope, 0.001 … 1, default 0.2; `alpha_y`: αy,
//! the width across it, 0 … 1, default 0, which means "as `alpha`" (values below 0.001 count as 0.001).
//! **Laws** reciprocal. Energy: lost where the view is flat, for the albedo of a narrow highlight is cosθo
//! (αx = αy = 0.2 returns 0.895 at 0°, 0.638 at 45°, 0.459 at 60°, 0.269 at 75°, 0.182 at 85°): at the mirror
//! direction f_cos is the same for every angle, while the solid angle of the highlight shrinks with cosθ.
//! Within a quarter of a degree of the horizon f_cos grows like 1/√cosθo and the highlight, which no longer
//! narrows, returns more than arrives (2.1 at 89.99°).
//! **Limits** α → 0 is a mirror of reflectance cosθ. Ward states the formula for widths up to about 0.2.
//! **Source** G. J. Ward, "Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992, the elliptical
//! Gaussian, in the form of Walter 2005 with H = wi + wo not normalised. Where both cosines multiply to less
//! than 1e-30 that is used for them.
//! **Cost** a division, a square root and an exponential.

use glanz_math::{Real, Vec3};

use crate::terms::{ALPHA, ALPHA_Y, Widths, above, height_squared};
use crate::{Law, Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Ward's highlight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ward {
    widths: Widths,
}

impl Model for Ward {
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

    fn from_params(values: &[f64]) -> Self {
        Self { widths: Widths::from_params(values) }
    }

    fn params(&self) -> Vec<f64> {
        self.widths.params()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let height = height_squared(pair);
        let root = (pair.cos_i * pair.cos_o).max(pair.cos_i.lit(1e-30)).sqrt();
        // One division gives both reciprocals.
        let both = pair.cos_i.one() / (height * root);
        let lobe = self.widths.highlight_with(pair, both * root);
        let value = pair.cos_i * (both * height) * lobe.gauss * both.lit(0.25 * self.widths.height);
        above(pair, value)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(self.widths.distribution(half))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(self.widths.in_place_of_g(self.f_cos(pair), pair))
    }
}

#[cfg(test)]
mod tests;
