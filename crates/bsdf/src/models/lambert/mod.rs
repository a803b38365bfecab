//! Lambert's law: a perfectly diffuse surface has the same radiance in all directions.
//!
//! Formula, parameters, source and cost: [`Lambert::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves all energy (albedo 1).
//!
//! **Limits** none; real diffuse surfaces are flatter at the limb (Oren–Nayar) and shine when grazed.

use glanz_math::{PI, Real};

use crate::{DirectionPair, LightTerm, Model, ModelInfo, Side};

/// The Lambertian lobe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lambert;

impl Model for Lambert {
    const INFO: ModelInfo = ModelInfo {
        name: "lambert",
        title: "Lambert 1760",
        formula: "cosθi / π",
        source: "J. H. Lambert, Photometria, 1760",
        params: &[],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 2,
        exempt: &[],
    };

    fn from_params(_: &[f64]) -> Self {
        Self
    }

    fn params(&self) -> Vec<f64> {
        Vec::new()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_i.max(pair.cos_i.zero()) * pair.cos_i.lit(1.0 / PI)
    }
}

#[cfg(test)]
mod tests;
