//! Lambert's law: a matte surface looks equally bright from everywhere.
//!
//! **Formula** f_cos = cosθi / π, zero below the horizon.
//! **Parameters** none.
//! **Laws** reciprocal; keeps all energy (albedo 1).
//! **Limits** none; real matte surfaces are flatter at the limb (Oren–Nayar) and shine when grazed.
//! **Source** J. H. Lambert, *Photometria*, 1760.
//! **Cost** one product.

use glanz_math::{PI, Real};

use crate::{Model, ModelInfo, DirectionPair, LightTerm, Side};

/// The matte lobe.
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
