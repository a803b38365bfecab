//! Blinn's highlight: a power of the cosine between normal and half vector.
//!
//! Formula, parameters, source and cost: [`BlinnPhong::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** not reciprocal, as Phong's: f = f_cos / cosθi. Along the normal the albedo is 8/(n+2) · (1 −
//! 2^(−(n+2)/2)), which is above 1 for n < 5.38; it falls towards grazing views.
//!
//! **Limits** n = 0 is constant, 1/π. An exponent of 4n resembles a Phong highlight of exponent n near its centre,
//! seen along the normal; towards grazing angles it stays narrow across the plane of incidence, where Phong's stays
//! round.

use glanz_math::{Exponent, PI, Real};

use crate::models::phong::SHININESS;
use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, Side};

/// Blinn's highlight: a power of the cosine between normal and half vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong {
    /// The exponent n.
    shininess: Exponent,
}

impl Model for BlinnPhong {
    const INFO: ModelInfo = ModelInfo {
        name: "blinn-phong",
        title: "Blinn–Phong 1977",
        formula: "max(n·h, 0)ⁿ / π where cosθi > 0",
        source: "J. F. Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977",
        params: &[SHININESS],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 14,
        exempt: &[
            (Law::Reciprocity, "f = (n·h)ⁿ / (π cosθi) divides by the cosine of the light alone"),
            (
                Law::Energy,
                "for n < 5.38 the albedo seen along the normal, 8/(n+2)·(1 − 2^(−(n+2)/2)), is more than 1",
            ),
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
        // Rounding may leave more than 1 for the mirror direction near the horizon, which a power of 10⁵ makes infinite.
        let cosine = pair.cos_half().min(zero.one());
        let value = cosine.power(&self.shininess) * zero.lit(1.0 / PI);
        value.select(zero.lt(pair.cos_i), zero)
    }
}

#[cfg(test)]
mod tests;
