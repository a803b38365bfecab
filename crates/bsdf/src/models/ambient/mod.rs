//! The ambient lobe: the same value whatever the geometry.
//!
//! Formula, parameters, source and cost: [`Ambient::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** none of a BSDF: ambient light has no direction. It hides what the other models leave dark.
//!
//! **Limits** the shape of an object is invisible in it.
//!
//! **Notes** f_cos is such that ambient light 1 (π inside Glanz) on an ambient tint of 1 gives 1. It is a constant
//! before the pixel loop.

use glanz_math::{PI, Real};

use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, Side};

/// The ambient lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ambient;

impl Model for Ambient {
    const INFO: ModelInfo = ModelInfo {
        name: "ambient",
        title: "Ambient term",
        formula: "1 / π",
        source: "the classic lighting equation, I = Ia·ka",
        params: &[],
        term: LightTerm::Ambient,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 0,
        exempt: &[
            (Law::Reciprocity, "ambient light has no direction to exchange"),
            (Law::Energy, "no cosine: over the hemisphere it would count twice"),
        ],
    };

    fn from_params(_: &[f64]) -> Self {
        Self
    }

    fn params(&self) -> Vec<f64> {
        Vec::new()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_i.lit(1.0 / PI)
    }
}

#[cfg(test)]
mod tests;
