//! Cook and Torrance's reflection of 1982: V-grooves of mirrors, with Beckmann's slopes of one or two widths.
//!
//! Formula, parameters, source and cost: [`CookTorrance::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy, whatever the slopes: 1 − albedo is what falls into the grooves.
//!
//! **Limits** towards m → 0 a perfect mirror of albedo 1 at every angle. Near m = 1 a tenth is lost at 0°.
//!
//! **Notes** In the paper, and in texts that follow its first printing, D is 1/(4 m² cos⁴θh) times the exponential
//! and R_s = F D G / (π (n·wi)(n·wo)): that is π/4 times this D, in a quotient with π in place of 4, which comes to
//! the same reflectance; written as R_s = F D G it lacks the quotient. Here D is the density whose facets cover the
//! surface, ∫ D cosθh dω = 1. Fresnel's F is the tint. A second slope is the paper's sum over several m, for
//! roughness on two scales.

use glanz_math::{PI, Real, Vec3};

use crate::microfacet::{BeckmannDistribution, HalfVector, d_above};
use crate::terms::{exp_of_minus, g_v_cavity};
use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The root mean square slope.
pub const M: ParamInfo = ParamInfo {
    name: "m",
    symbol: "m",
    doc: "root mean square slope of the facets: greater is rougher",
    // Rounding of the cosines in f32, 6e-8, must stay well below m².
    min: 0.001,
    max: 1.0,
    default: 0.2,
};

/// Cook and Torrance's reflection with Beckmann's distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CookTorrance {
    /// The slope m.
    m: f64,
    /// The second slope.
    m2: f64,
    /// The weight of the second slope.
    weight2: f64,
    /// weight / (π m²) and 1/m² of each slope.
    terms: [(f64, f64); 2],
}

impl Model for CookTorrance {
    const INFO: ModelInfo = ModelInfo {
        name: "cook-torrance",
        title: "Cook–Torrance 1982, Beckmann's slopes",
        formula: "D · G / (4 cosθo), D = (1−w) D(m) + w D(m₂), D(m) = exp(−tan²θh/m²) / (π m² cos⁴θh), G = min(1, 2 (n·h)(n·wo)/(wo·h), 2 (n·h)(n·wi)/(wo·h))",
        source: "R. L. Cook and K. E. Torrance, A Reflectance Model for Computer Graphics, ACM Transactions on Graphics 1(1), 1982, equations 2 to 5",
        params: &[
            M,
            ParamInfo { name: "m2", symbol: "m₂", doc: "a second slope of the facets", default: 0.5, ..M },
            ParamInfo {
                name: "weight2",
                symbol: "w",
                doc: "weight of the second slope; the first has the rest",
                min: 0.0,
                max: 1.0,
                default: 0.0,
            },
        ],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 43,
        exempt: &[(
            Law::Precision,
            "tan²θh is formed as 1/cos²θh − 1, of which f32 keeps 6e-8: for m below 0.002 flat views are off by up to 6 %",
        )],
    };

    fn from_params(values: &[f64]) -> Self {
        let (m, m2, weight2) = (values[0], values[1], values[2]);
        let term = |m: f64, weight: f64| (weight / (PI * m * m), 1.0 / (m * m));
        Self { m, m2, weight2, terms: [term(m, 1.0 - weight2), term(m2, weight2)] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.m, self.m2, self.weight2]
    }

    fn numbers(&self) -> Vec<f32> {
        let [(scale, steep), (scale2, steep2)] = self.terms;
        [scale, steep, scale2, steep2, self.weight2].map(|number| number as f32).to_vec()
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = HalfVector::new(pair);
        let inverse = half.up2.one() / half.up2;
        let ratio = half.length2 * inverse;
        let tan2 = ratio - ratio.one();
        let mut d = term(tan2, self.terms[0]);
        if self.weight2 > 0.0 {
            d = d + term(tan2, self.terms[1]);
        }
        d * ratio.sqr() * groove(pair, half.length2)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        let term = |m: f64| d_above::<BeckmannDistribution>(half, (m, m));
        Some((1.0 - self.weight2) * term(self.m) + self.weight2 * term(self.m2))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(g_v_cavity(pair.cos_half(), pair.cos_o, pair.cos_i, pair.cos_view_half()))
    }
}

/// The part of D of one slope, without 1/cos⁴θh.
#[inline(always)]
fn term<R: Real>(tan2: R, (scale, steep): (f64, f64)) -> R {
    exp_of_minus(tan2 * tan2.lit(steep)) * tan2.lit(scale)
}

/// G / (4 cosθo) of the V-grooves, 0 where light or viewer is below: (n·h)/(wo·h) is 2 n·H / |H|².
#[inline(always)]
pub(crate) fn groove<R: Real>(pair: &DirectionPair<R>, length2: R) -> R {
    let zero = pair.cos_o.zero();
    let least = pair.cos_o.min(pair.cos_i);
    // The masked and shadowed fraction of a groove, over cosθo, and at most that of a facet alone.
    let edge = (pair.cos_o + pair.cos_i) * least / length2;
    let factor = edge.min(zero.lit(0.25)) / pair.cos_o.max(zero.lit(1e-30));
    factor.select(zero.lt(least), zero)
}

#[cfg(test)]
mod tests;
