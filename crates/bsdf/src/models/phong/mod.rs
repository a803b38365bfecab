//! Phong's highlight as he published it: a power of the cosine between mirrored light and viewer.
//!
//! Formula, parameters, source and cost: [`Phong::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** not reciprocal, since f carries 1/cosθi of the light only. Along the normal its albedo is 2/(n+1), so
//! it conserves energy for n >= 1; for n < 1 it does not. Whatever n is, light from one direction near the horizon
//! is returned 1/cosθi too strong.
//!
//! **Limits** n = 0 is constant, 1/π; n = 1 has the albedo (1 + cosθo)/2; n → ∞ is a mirror that returns nothing.
//!
//! **Notes** The model has no cosine of its own: its BSDF is f = (R·wo)ⁿ / (π cosθi), which grows without bound
//! towards grazing light. The factor 1/π is such that a unit light (π inside Glanz) and a unit tint give the
//! classic (R·V)ⁿ.

use glanz_math::{Exponent, PI, Real};

use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The exponent of the Phong and Blinn–Phong lobes, as files and command line name it.
pub(crate) const SHININESS: ParamInfo = ParamInfo {
    name: "shininess",
    symbol: "n",
    doc: "exponent of the cosine: the greater, the smaller the highlight",
    min: 0.0,
    max: 1e5,
    default: 32.0,
};

/// The classic Phong lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// The exponent n.
    shininess: Exponent,
}

impl Model for Phong {
    const INFO: ModelInfo = ModelInfo {
        name: "phong",
        title: "Phong 1975",
        formula: "max(R·wo, 0)ⁿ / π where cosθi > 0",
        source: "B. T. Phong, Illumination for Computer Generated Pictures, CACM 18(6), 1975",
        params: &[SHININESS],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 11,
        exempt: &[
            (Law::Reciprocity, "f = (R·wo)ⁿ / (π cosθi) divides by the cosine of the light alone"),
            (Law::Energy, "for n < 1 the albedo seen along the normal is 2/(n+1), more than 1"),
        ],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { shininess: Exponent::new(values[0]) }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.shininess.n()]
    }

    fn numbers(&self) -> Vec<f32> {
        self.shininess.numbers().to_vec()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        // Below 0 it counts as 0.
        let cosine = pair.cos_mirror();
        // A shortcut that changes no bit.
        if !R::any(zero.lit(self.shininess.dark_up_to()).lt(cosine)) {
            return zero;
        }
        let value = cosine.power(&self.shininess) * zero.lit(1.0 / PI);
        value.select(zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests;
