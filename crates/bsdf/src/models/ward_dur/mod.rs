//! Ward's highlight as Dür mended it, so that flat views lose less.
//!
//! **Formula** f_cos = e / (4π αx αy cosθo), e = exp(−[(hx/αx)² + (hy/αy)²] / hz²), where cosθi > 0.
//! **Parameters** `alpha`, `alpha_y`: as of Ward's model.
//! **Laws** reciprocal. Energy: kept well up to about 75° (αx = αy = 0.2 returns 0.928 at 0°, 0.917 at 60°,
//! 0.889 at 75°), but f_cos grows like 1/cosθo, so that grazing views get more than arrives (1.13 at 85°, 3.4
//! at 89°).
//! **Limits** α → 0 is a perfect mirror of reflectance 1 away from the horizon.
//! **Source** A. Dür, "An Improved Normalization for the Ward Reflectance Model", Journal of Graphics Tools
//! 11(1), 2006: the factor 1/(cosθi cosθo) in place of its square root. Where both cosines multiply to less
//! than 1e-30 that is used for them.
//! **Cost** two divisions and an exponential.

use glanz_math::{Real, Vec3};

use crate::terms::{ALPHA, ALPHA_Y, Widths, above};
use crate::{Law, Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Ward's highlight with Dür's factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WardDur {
    widths: Widths,
}

impl Model for WardDur {
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

    fn from_params(values: &[f64]) -> Self {
        Self { widths: Widths::from_params(values) }
    }

    fn params(&self) -> Vec<f64> {
        self.widths.params()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let product = (pair.cos_i * pair.cos_o).max(pair.cos_i.lit(1e-30));
        let lobe = self.widths.highlight(pair);
        let value = pair.cos_i / product * lobe.gauss * product.lit(0.25 * self.widths.height);
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
