//! The emission lobe: light that the surface sends by itself, the same in all directions.
//!
//! Formula, parameters, source and cost: [`Emission::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** none of a BSDF: there is no incident light.
//!
//! **Limits** it lights nothing else; Glanz is about local illumination.
//!
//! **Notes** It is a constant before the pixel loop.

use glanz_math::Real;

use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, Side};

/// The emission lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emission;

impl Model for Emission {
    const INFO: ModelInfo = ModelInfo {
        name: "emission",
        title: "Emission",
        formula: "1, without any light",
        source: "the classic lighting equation",
        params: &[],
        term: LightTerm::Emission,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 0,
        exempt: &[
            (Law::Reciprocity, "there is no incident direction"),
            (Law::Energy, "it sends light without receiving any"),
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
        pair.cos_i.one()
    }
}

#[cfg(test)]
mod tests;
