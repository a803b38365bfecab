//! Sheen: the haze at the limb of cloth, from fibres that stand up from the surface.
//!
//! Formula, parameters, source and cost: [`Charlie::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal. Energy: smooth sheens break it. For α below 0.07 views within a few degrees of the horizon
//! get more than arrives (α = 0.01 returns 1.29 at 88°); from 0.07 to 1 the albedo stays below 1 down to 89.9°. E
//! at α = 0.25: 0.027 at 0°, 0.188 at 60°, 0.592 at 85°.
//!
//! **Limits** α → 0 is dark but for a thin line at the limb; α = 1 is a soft haze.
//!
//! **Notes** a … e come from the table of the paper for α = 0 and 1, mixed by (1 − α)², without the softening of
//! the terminator. It is the form that the Khronos extension KHR_materials_sheen gives first; its implementation
//! notes are not normative and allow Ashikhmin's visibility 1/(4 (cosθi + cosθo − cosθi cosθo)) instead, of which
//! they say that it does not conserve energy. glTF's `sheenRoughnessFactor` is √α. [`Albedo`] is what glTF's
//! scaling of the layers below needs.

mod albedo;

use glanz_math::{PI, Real, Vec3};

pub use albedo::Albedo;

use crate::terms::{above, d_charlie, smith_g2};
use crate::{DirectionPair, Law, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// a, b, c, d, e of l for α = 1 and for α = 0.
const FIT: [[f64; 2]; 5] =
    [[21.5473, 25.3245], [3.82987, 3.32435], [0.19823, 0.16801], [-1.97760, -1.27393], [-4.32054, -4.85967]];

/// The sheen of cloth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charlie {
    alpha: f64,
    /// a, b, c, d, e.
    fit: [f64; 5],
    /// 2 l(½).
    twice_middle: f64,
}

impl Model for Charlie {
    const INFO: ModelInfo = ModelInfo {
        name: "charlie",
        title: "Charlie sheen 2017",
        formula: "cosθi · D / (4 cosθi cosθo (1 + Λ(cosθo) + Λ(cosθi))), D = (2 + 1/α) sinθh^(1/α) / (2π), Λ(c) = exp(l(c)) for c < ½, else exp(2 l(½) − l(1 − c)), l(x) = a/(1 + b xᶜ) + d x + e",
        source: "A. Conty Estevez and C. Kulla, Production Friendly Microfacet Sheen BRDF, SIGGRAPH course 2017",
        params: &[ParamInfo {
            name: "alpha",
            symbol: "α",
            doc: "how far the fibres lean from the normal; the square of glTF's sheen roughness",
            min: 1e-3,
            max: 1.0,
            default: 0.25,
        }],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 221,
        exempt: &[(
            Law::Energy,
            "for α below 0.07 views within a few degrees of the horizon get more than arrives",
        )],
    };

    fn from_params(values: &[f64]) -> Self {
        let alpha = values[0];
        let towards_0 = (1.0 - alpha) * (1.0 - alpha);
        let fit = FIT.map(|[at_1, at_0]| at_1 + (at_0 - at_1) * towards_0);
        Self { alpha, fit, twice_middle: 2.0 * exponent(&fit, 0.5) }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let one = zero.one();
        let (cos_i, cos_o) = (pair.cos_i.max(zero), pair.cos_o.max(zero));
        // |H|², and what of it is not along the normal.
        let length2 = pair.half2.max(zero.lit(1e-12));
        let flat2 = (length2 - (cos_i + cos_o).sqr()).max(zero);
        let power = (flat2 / length2).min(one).pow(zero.lit(0.5 / self.alpha));
        let shadow = one + self.lambda(cos_o) + self.lambda(cos_i);
        let height = zero.lit((2.0 + 1.0 / self.alpha) / (8.0 * PI));
        above(pair, power * height / (shadow * cos_o.max(zero.lit(1e-20))))
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        let across = (half.x * half.x + half.y * half.y).sqrt();
        Some(if half.z > 0.0 { d_charlie(across.min(1.0), self.alpha) } else { 0.0 })
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(smith_g2(self.lambda(pair.cos_o), self.lambda(pair.cos_i)))
    }
}

impl Charlie {
    /// Smith's Λ of the fibres.
    #[inline(always)]
    fn lambda<R: Real>(&self, cosine: R) -> R {
        let rest = cosine.one() - cosine;
        let l = exponent(&self.fit, cosine.min(rest).max(cosine.zero()));
        l.select(cosine.lt(rest), cosine.lit(self.twice_middle) - l).exp()
    }
}

/// l(x).
#[inline(always)]
fn exponent<R: Real>(fit: &[f64; 5], x: R) -> R {
    let [a, b, c, d, e] = fit.map(|number| x.lit(number));
    a / (x.one() + b * x.pow(c)) + d * x + e
}

#[cfg(test)]
mod tests;
