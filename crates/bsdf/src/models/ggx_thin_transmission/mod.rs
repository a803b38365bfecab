//! Transmission through a thin rough sheet: the light mirrored to the viewer's side, then GGX.
//!
//! Formula, parameters, source and cost: [`GgxThinTransmission::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: the albedo is that of a single reflection by [`ggx`](crate::models::ggx).
//!
//! **Limits** towards α → 0 light passes as if there were no sheet: a thin sheet does not bend it.
//!
//! **Notes** A roughness texture multiplies α.

use glanz_math::{Real, Vec3};

use crate::microfacet::ALPHA;
use crate::models::ggx::Ggx;
use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// GGX transmission through a thin sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GgxThinTransmission {
    /// The width of the distribution.
    alpha: f64,
    reflection: Ggx,
}

impl Model for GgxThinTransmission {
    const INFO: ModelInfo = ModelInfo {
        name: "ggx-thin-transmission",
        title: "GGX through a thin sheet (glTF)",
        formula: "D · G2 / (4 cosθo) with the light mirrored at the sheet",
        source: "Khronos Group, glTF extension KHR_materials_transmission, 2021, section Implementation notes",
        params: &[ALPHA],
        term: LightTerm::Specular,
        side: Side::Transmission,
        anisotropic: false,
        delta: false,
        operations: 43,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { alpha: values[0], reflection: Ggx::from_params(&[values[0], 0.0, 0.0]) }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        self.reflection.f_cos(&pair.mirrored())
    }

    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.mirrored().cos_view_half()
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        self.reflection.distribution(half)
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        self.reflection.shadowing(pair)
    }
}

#[cfg(test)]
mod tests;
