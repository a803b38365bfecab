//! Microfacets with Beckmann's slopes and Smith's shadowing, with the energy of further reflections.
//!
//! **Formula** f_cos = D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)),
//! D = exp(−tan²θh (cos²φh/αx² + sin²φh/αy²)) / (π αx αy cos⁴θh), G2 = 1 / (1 + Λo + Λi),
//! Λ = (1 − 1.259 a + 0.396 a²) / (3.535 a + 2.181 a²) for a = 1/(α tanθ) < 1.6, else 0.
//! **Parameters** `alpha`, `alpha_y`: the widths along tangent and bitangent, root mean square slopes times √2, pure
//! numbers, 0.001 … 1, default 0.2; `alpha_y` 0, the default, means as `alpha`. `multiscatter`: the weight w, 0 … 1,
//! default 1.
//! **Laws** reciprocal; keeps energy: with w = 1 the albedo is between 0.995 and 1 for every α and angle
//! (elongated surfaces: 0.994 at worst for 0.05/0.16, 0.97 for 0.2/0.6, 0.89 for 0.1/0.9).
//! **Limits** towards α → 0 a perfect mirror. Where both widths are equal tangents are not read.
//! **Source** P. Beckmann and A. Spizzichino 1963; B. Walter and others, Microfacet Models for Refraction through Rough
//! Surfaces, 2007, whose rational Λ stands for the exact one with erf (within 0.35 %); E. Heitz, Understanding the
//! Masking-Shadowing Function, 2014, equations 77 and 99; C. Kulla and A. Conty 2017 for the second part, with a series
//! of our own for E.
//! **Cost** one exponential, two square roots, two quotients; two more quotients for the second part.

use glanz_math::{PI, Real, Vec3};

use crate::models::ggx::{ALPHA, ALPHA_Y, MULTISCATTER, widths};
use crate::terms::{Distribution, Half, MultiScatter, exp_of_minus, facets, stretched2};
use crate::{Model, ModelInfo, DirectionPair, LightTerm, Side};

/// Reflection by Beckmann's slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beckmann {
    /// The width along the tangent.
    pub alpha: f64,
    /// The width along the bitangent; 0 means as `alpha`.
    pub alpha_y: f64,
    /// The weight of the energy of further reflections.
    pub multiscatter: f64,
    /// (αx², αy²) and their inverses.
    squares: (f64, f64),
    inverse2: (f64, f64),
    /// 1 / (4π αx αy).
    scale: f64,
    compensation: MultiScatter,
}

impl Model for Beckmann {
    const INFO: ModelInfo = ModelInfo {
        name: "beckmann",
        title: "Beckmann with Smith's shadowing (Walter 2007, Heitz 2014) that keeps its energy",
        formula: "D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), D = exp(−tan²θh/α²) / (π α² cos⁴θh)",
        source: "P. Beckmann and A. Spizzichino, The Scattering of Electromagnetic Waves from Rough Surfaces, 1963; E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014; C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, 2017",
        params: &[ALPHA, ALPHA_Y, MULTISCATTER],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (alpha, alpha_y, multiscatter) = (values[0], values[1], values[2]);
        let (x, y) = widths(alpha, alpha_y);
        Self {
            alpha,
            alpha_y,
            multiscatter,
            squares: (x * x, y * y),
            inverse2: (1.0 / (x * x), 1.0 / (y * y)),
            scale: 0.25 / (PI * x * y),
            compensation: MultiScatter::new(Distribution::Beckmann, (x, y), multiscatter),
        }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha, self.alpha_y, self.multiscatter]
    }

    fn is_anisotropic(&self) -> bool {
        let (x, y) = widths(self.alpha, self.alpha_y);
        x != y
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_o.zero();
        let mut value = self.single(pair);
        if self.multiscatter > 0.0 {
            value = value + self.compensation.f_cos(pair, None);
        }
        value.select(zero.lt(pair.cos_o) & zero.lt(pair.cos_i), zero)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(facets::distribution(Distribution::Beckmann, half, widths(self.alpha, self.alpha_y)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(facets::shadowing(Distribution::Beckmann, pair, widths(self.alpha, self.alpha_y)))
    }
}

impl Beckmann {
    /// D · G2 / (4 cosθo) for light and viewer above. With Λ = N / (cosθ M), G2 / cosθo has one quotient.
    #[inline(always)]
    fn single<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = Half::new(pair);
        let inverse = half.up2.one() / half.up2;
        let d = exp_of_minus(half.across2(pair, self.inverse2) * inverse) * (half.length2 * inverse).sqr();
        let (no, mo) = lambda(pair.cos_o, stretched2(pair.cos_o, pair.tangent_o, self.squares));
        let (ni, mi) = lambda(pair.cos_i, stretched2(pair.cos_i, pair.tangent_i, self.squares));
        let (below_o, below_i) = (pair.cos_o * mo, pair.cos_i * mi);
        let shared = below_o * below_i + no * below_i + ni * below_o;
        d * d.lit(self.scale) * (mo * below_i) / shared.max(d.lit(1e-30))
    }
}

/// Λ as N and M of N / (cosθ M), for α² sin²θ.
#[inline(always)]
fn lambda<R: Real>(cosine: R, stretched2: R) -> (R, R) {
    let stretched = stretched2.sqrt();
    let both = cosine * stretched;
    let above = stretched2 - both * both.lit(1.259) + cosine.sqr() * both.lit(0.396);
    let shadowed = cosine.lt(stretched * both.lit(1.6));
    (above.select(shadowed, both.zero()), stretched * both.lit(3.535) + cosine * both.lit(2.181))
}

#[cfg(test)]
mod tests;
