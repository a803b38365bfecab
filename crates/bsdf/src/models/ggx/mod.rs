//! The microfacet reflection of today's renderers: GGX slopes, Smith's shadowing, the energy of further reflections.
//!
//! **Formula** f_cos = D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)),
//! D = 1 / (π αx αy cos⁴θh (1 + tan²θh (cos²φh/αx² + sin²φh/αy²))²), G2 = 1 / (1 + Λo + Λi),
//! Λ = (√(1 + α² tan²θ) − 1) / 2.
//! **Parameters** `alpha`: the width along the tangent, a pure number, 0.001 … 1, default 0.2. `alpha_y`: the width
//! along the bitangent, the same; 0, the default, means as `alpha`. `multiscatter`: the weight w, 0 … 1, default 1.
//! A roughness texture multiplies both widths.
//! **Laws** reciprocal; keeps energy: with w = 0 the albedo falls to 0.31 at α = 1 and 0°, with w = 1 it is between
//! 0.995 and 1 for every α and angle (elongated surfaces: 0.994 at worst for 0.05/0.16, 0.97 for 0.2/0.6, 0.94 for
//! 0.1/0.9).
//! **Limits** towards α → 0 a perfect mirror. Where both widths are equal tangents are not read.
//! **Source** T. S. Trowbridge and K. P. Reitz 1975; B. Walter and others, Microfacet Models for Refraction through
//! Rough Surfaces, 2007; E. Heitz, Understanding the Masking-Shadowing Function, 2014, equations 86 and 99; C. Kulla and
//! A. Conty, Revisiting Physically Based Shading at Imageworks, 2017, with a series of our own for E (see
//! [`ggx_multiple`](crate::models::ggx_multiple) for that part alone, which may have a tint of its own).
//! **Cost** two square roots, two quotients; two more quotients and twelve products for the second part.

use glanz_math::{PI, Real, Vec3};

use crate::terms::{Distribution, Half, MultiScatter, facets, stretched2};
use crate::{Model, ModelInfo, DirectionPair, ParamInfo, LightTerm, Side};

/// The least width: its square must stay well above 6e-8, to which `f32` rounds cosines.
pub const LEAST_ALPHA: f64 = 0.001;

/// The width of a distribution of slopes.
pub const ALPHA: ParamInfo = ParamInfo {
    name: "alpha",
    symbol: "α",
    doc: "width of the distribution of slopes, along the tangent: greater is rougher",
    min: LEAST_ALPHA,
    max: 1.0,
    default: 0.2,
};

/// The width along the bitangent.
pub const ALPHA_Y: ParamInfo = ParamInfo {
    name: "alpha_y",
    symbol: "αy",
    doc: "width along the bitangent; 0 means as alpha",
    min: 0.0,
    max: 1.0,
    default: 0.0,
};

/// The weight of what more than one reflection sends out.
pub const MULTISCATTER: ParamInfo = ParamInfo {
    name: "multiscatter",
    symbol: "w",
    doc: "weight of the energy of further reflections: 1 loses nothing, 0 is the single reflection alone",
    min: 0.0,
    max: 1.0,
    default: 1.0,
};

/// Both widths, as `alpha_y` is meant.
pub(crate) fn widths(alpha: f64, alpha_y: f64) -> (f64, f64) {
    (alpha, if alpha_y == 0.0 { alpha } else { alpha_y.max(LEAST_ALPHA) })
}

/// GGX reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ggx {
    /// The width along the tangent.
    pub alpha: f64,
    /// The width along the bitangent; 0 means as `alpha`.
    pub alpha_y: f64,
    /// The weight of the energy of further reflections.
    pub multiscatter: f64,
    /// (αx², αy²) and their inverses.
    squares: (f64, f64),
    inverse2: (f64, f64),
    /// 1 / (2π αx αy).
    scale: f64,
    /// The factor that makes the lesser width the least allowed.
    least_widening: f64,
    compensation: MultiScatter,
}

impl Model for Ggx {
    const INFO: ModelInfo = ModelInfo {
        name: "ggx",
        title: "GGX (Walter 2007, Heitz 2014) that keeps its energy",
        formula: "D · G2 / (4 cosθo) + w (1−E(wo)) (1−E(wi)) cosθi / (π (1−Eavg)), D = 1 / (π α² (cos²θh + sin²θh/α²)²)",
        source: "B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces, 2007; E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014; C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks, 2017",
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
            scale: 0.5 / (PI * x * y),
            least_widening: LEAST_ALPHA / x.min(y),
            compensation: MultiScatter::new(Distribution::Ggx, (x, y), multiscatter),
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
            value = value + self.compensation.f_cos(pair, Some(pair.alpha_scale));
        }
        value.select(zero.lt(pair.cos_o) & zero.lt(pair.cos_i), zero)
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(facets::distribution(Distribution::Ggx, half, widths(self.alpha, self.alpha_y)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(facets::shadowing(Distribution::Ggx, pair, widths(self.alpha, self.alpha_y)))
    }
}

impl Ggx {
    /// D · G2 / (4 cosθo) for light and viewer above.
    ///
    /// D is q² w² / (π αx αy) with q = |H|² / ((Hx/αx)² + (Hy/αy)² + w² Hz²), where w widens; G2 / (4 cosθo cosθi) is
    /// 1 / (2 (cosθi Lo + cosθo Li)) with L = √(cos² + w² α² sin²).
    #[inline(always)]
    fn single<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = Half::new(pair);
        let w2 = pair.alpha_scale.max(half.up2.lit(self.least_widening)).sqr();
        let q = half.length2 / (half.across2(pair, self.inverse2) + half.up2 * w2);
        let lo = (pair.cos_o.sqr() + w2 * stretched2(pair.cos_o, pair.tangent_o, self.squares)).sqrt();
        let li = (pair.cos_i.sqr() + w2 * stretched2(pair.cos_i, pair.tangent_i, self.squares)).sqrt();
        let shared = (pair.cos_i * lo + pair.cos_o * li).max(w2.lit(1e-30));
        q.sqr() * w2 * w2.lit(self.scale) * pair.cos_i / shared
    }
}

#[cfg(test)]
mod tests;
