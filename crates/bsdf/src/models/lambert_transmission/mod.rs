//! A thin sheet that scatters light from behind evenly: a leaf, a lampshade.
//!
//! **Formula** f_cos = max(−cosθi, 0) / π.
//! **Parameters** none.
//! **Laws** reciprocal; keeps energy: all light from the other side leaves, in all directions alike.
//! **Limits** none.
//! **Source** J. H. Lambert, Photometria, 1760, for the light that passes; the refracted component "on the other side"
//! of the local lighting equation.
//! **Cost** one product.

use glanz_math::{PI, Real};

use crate::{Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Lambert's law for light from behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LambertTransmission;

impl Model for LambertTransmission {
    const INFO: ModelInfo = ModelInfo {
        name: "lambert-transmission",
        title: "Lambert's law for light from behind",
        formula: "max(−cosθi, 0) / π",
        source: "J. H. Lambert, Photometria, 1760",
        params: &[],
        term: LightTerm::Diffuse,
        side: Side::Transmission,
        anisotropic: false,
        delta: false,
        operations: 3,
        exempt: &[],
    };

    fn from_params(_values: &[f64]) -> Self {
        Self
    }

    fn params(&self) -> Vec<f64> {
        Vec::new()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let value = -pair.cos_i * zero.lit(1.0 / PI);
        value.select(pair.cos_i.lt(zero) & zero.lt(pair.cos_o), zero)
    }
}

#[cfg(test)]
mod tests;
