//! Ward's highlight in Dür's normalisation, with less loss at grazing views.
//!
//! Formula, parameters, source and cost: [`WardDur::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal. Energy: kept well up to about 75° (αx = αy = 0.2 returns 0.928 at 0°, 0.917 at 60°, 0.889
//! at 75°), but f_cos grows like 1/cosθo, so that grazing views get more than arrives (1.13 at 85°, 3.4 at 89°).
//!
//! **Limits** α → 0 is a perfect mirror of reflectance 1 away from the horizon.
//!
//! **Notes** The factor 1/(cosθi cosθo) in place of its square root. Where both cosines multiply to less than 1e-30
//! that is used for them.

use glanz_math::Real;

use crate::terms::{ALPHA, ALPHA_Y, WardFactor, WardLobe, Widths};
use crate::{DirectionPair, Law, LightTerm, ModelInfo, Side};

/// Ward's highlight with Dür's factor.
pub type WardDur = WardLobe<Dur2006>;

/// The factor 1/(cosθi cosθo) of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dur2006;

impl WardFactor for Dur2006 {
    const INFO: ModelInfo = ModelInfo {
        name: "ward-dur",
        title: "Ward–Dür 2006",
        formula: "cosθi · exp(−[(hx/αx)² + (hy/αy)²] / hz²) / (4π αx αy cosθi cosθo)",
        source: "A. Dür, An Improved Normalization for the Ward Reflectance Model, JGT 11(1), 2006",
        params: &[ALPHA, ALPHA_Y],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        operations: 41,
        exempt: &[(Law::Energy, "f_cos grows like 1/cosθo: a grazing view gets more than arrives")],
    };

    #[inline(always)]
    fn f_cos<R: Real>(widths: &Widths, pair: &DirectionPair<R>) -> R {
        let product = (pair.cos_i * pair.cos_o).max(pair.cos_i.lit(1e-30));
        let lobe = widths.highlight(pair);
        pair.cos_i / product * lobe.gauss * product.lit(0.25 * widths.height)
    }
}

#[cfg(test)]
mod tests;
