//! The distributions of microfacet normals that Smith's lobes are written over.
//!
//! A distribution tells its formulas in the form in which they are evaluated per pixel, so that each model's floating-point
//! operations keep their order, and in the textbook form (see [`crate::terms`]) for tables and plots.

use glanz_math::{Real, Vec3};

use super::half_vector::{HalfVector, stretched2};
use super::refracted_half_vector::RefractedHalfVector;
use super::{LEAST_ALPHA, transmission::SmithTransmission};
use crate::models::{
    beckmann, beckmann_multiple, beckmann_transmission, ggx, ggx_multiple, ggx_transmission,
};
use crate::terms::{d_beckmann, d_ggx, exp_of_minus, lambda_beckmann, lambda_ggx};
use crate::{DirectionPair, ModelInfo};

/// A distribution of microfacet normals: a type without size.
pub trait Distribution: Copy + core::fmt::Debug + Default + PartialEq + Send + Sync + 'static {
    /// What the model of its reflection tells about itself.
    const REFLECTION: ModelInfo;
    /// The same of its multiple-scattering compensation.
    const MULTIPLE: ModelInfo;
    /// The same of its rough refraction.
    const TRANSMISSION: ModelInfo;

    /// The constant factor of G2 / cosθo beside [`Distribution::g2`].
    const G2_FACTOR: f64;
    /// Whether the multiple-scattering compensation of isotropic surfaces is tabulated; else it is fitted.
    const TABULATED: bool;

    /// D towards a unit vector above the surface.
    fn d(half: Vec3<f64>, alpha: (f64, f64)) -> f64;

    /// Smith's Λ of a direction above the surface.
    fn lambda(w: Vec3<f64>, alpha: (f64, f64)) -> f64;

    /// The slope, in units of the width, that a fraction `rest` of the facets exceeds.
    fn slope(rest: f64) -> f64;

    /// The inverse of [`Distribution::slope`].
    fn steeper(slope: f64) -> f64;

    /// The pair's factor of the widths; none for distributions that textures cannot widen.
    fn alpha_scale<R: Real>(pair: &DirectionPair<R>) -> Option<R>;

    /// D without 1/(π αx αy). `inverse2` is (1/αx², 1/αy²), `scale2` the square of the factor of the widths.
    fn d_unscaled<R: Real>(
        half: &HalfVector<R>,
        pair: &DirectionPair<R>,
        inverse2: (f64, f64),
        scale2: Option<R>,
    ) -> R;

    /// G2 / cosθo as a numerator and a denominator without [`Distribution::G2_FACTOR`]. `squares` is (αx², αy²).
    fn g2<R: Real>(pair: &DirectionPair<R>, squares: (f64, f64), scale2: Option<R>) -> (R, R);

    /// What [`Distribution::transmitted`] is multiplied with, for α².
    fn transmission_scale(square: f64) -> f64;

    /// D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²) where the facet is seen and lit.
    fn transmitted<R: Real>(
        lobe: &SmithTransmission<Self>,
        half: &RefractedHalfVector<R>,
        pair: &DirectionPair<R>,
    ) -> R;
}

/// Slopes with a normal distribution: P. Beckmann and A. Spizzichino, 1963. See [`d_beckmann`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeckmannDistribution;

/// Trowbridge and Reitz's distribution, 1975, called GGX by Walter and others, 2007. See [`d_ggx`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GgxDistribution;

impl Distribution for BeckmannDistribution {
    const REFLECTION: ModelInfo = beckmann::INFO;
    const MULTIPLE: ModelInfo = beckmann_multiple::INFO;
    const TRANSMISSION: ModelInfo = beckmann_transmission::INFO;
    const G2_FACTOR: f64 = 1.0;
    const TABULATED: bool = false;

    fn d(half: Vec3<f64>, alpha: (f64, f64)) -> f64 {
        d_beckmann(half, alpha)
    }

    fn lambda(w: Vec3<f64>, alpha: (f64, f64)) -> f64 {
        lambda_beckmann(w, alpha)
    }

    fn slope(rest: f64) -> f64 {
        libm::sqrt(-libm::log(rest))
    }

    fn steeper(slope: f64) -> f64 {
        libm::exp(-slope * slope)
    }

    #[inline(always)]
    fn alpha_scale<R: Real>(_pair: &DirectionPair<R>) -> Option<R> {
        None
    }

    #[inline(always)]
    fn d_unscaled<R: Real>(
        half: &HalfVector<R>,
        pair: &DirectionPair<R>,
        inverse2: (f64, f64),
        _scale2: Option<R>,
    ) -> R {
        let inverse = half.up2.one() / half.up2;
        exp_of_minus(half.across2(pair, inverse2) * inverse) * (half.length2 * inverse).sqr()
    }

    /// With Λ = N / (cosθ M), G2 / cosθo has one quotient.
    #[inline(always)]
    fn g2<R: Real>(pair: &DirectionPair<R>, squares: (f64, f64), _scale2: Option<R>) -> (R, R) {
        let (no, mo) = beckmann_lambda(pair.cos_o, stretched2(pair.cos_o, pair.tangent_o, squares));
        let (ni, mi) = beckmann_lambda(pair.cos_i, stretched2(pair.cos_i, pair.tangent_i, squares));
        let (below_o, below_i) = (pair.cos_o * mo, pair.cos_i * mi);
        let denominator = below_o * below_i + no * below_i + ni * below_o;
        (mo * below_i, denominator)
    }

    fn transmission_scale(square: f64) -> f64 {
        1.0 / (glanz_math::PI * square)
    }

    #[inline(always)]
    fn transmitted<R: Real>(
        lobe: &SmithTransmission<Self>,
        half: &RefractedHalfVector<R>,
        pair: &DirectionPair<R>,
    ) -> R {
        let zero = pair.cos_o.zero();
        let inverse = zero.one() / half.up2.max(zero.lit(1e-12));
        let tan2 = (half.length2 - half.up2) * inverse;
        // D has |H|⁴ above, (wo·h)(wi·h) / (wo·h + η wi·h)² has it below.
        let d = exp_of_minus(tan2 * zero.lit(1.0 / lobe.square())) * inverse.sqr() * zero.lit(lobe.scale());
        let down = -pair.cos_i;
        let g1_o = beckmann_g1_over_cosine(pair.cos_o, lobe.square());
        d * half.product * g1_o * (beckmann_g1_over_cosine(down, lobe.square()) * down)
    }
}

/// Λ as N and M of N / (cosθ M), for α² sin²θ.
#[inline(always)]
fn beckmann_lambda<R: Real>(cosine: R, stretched2: R) -> (R, R) {
    let stretched = stretched2.sqrt();
    let both = cosine * stretched;
    let above = stretched2 - both * both.lit(1.259) + cosine.sqr() * both.lit(0.396);
    let shadowed = cosine.lt(stretched * both.lit(1.6));
    (above.select(shadowed, both.zero()), stretched * both.lit(3.535) + cosine * both.lit(2.181))
}

/// G1 / cosθ.
#[inline(always)]
fn beckmann_g1_over_cosine<R: Real>(cosine: R, square: f64) -> R {
    let stretched = stretched2(cosine, (cosine, cosine), (square, square)).sqrt();
    let above = stretched * cosine.lit(3.535) + cosine * cosine.lit(2.181);
    let rest = stretched * cosine.lit(2.276) + cosine * cosine.lit(2.577);
    let below = stretched.sqr() + cosine * rest;
    let shadowed = cosine.lt(stretched * cosine.lit(1.6));
    let floor = cosine.lit(1e-30);
    above.select(shadowed, cosine.one()) / below.select(shadowed, cosine).max(floor)
}

impl Distribution for GgxDistribution {
    const REFLECTION: ModelInfo = ggx::INFO;
    const MULTIPLE: ModelInfo = ggx_multiple::INFO;
    const TRANSMISSION: ModelInfo = ggx_transmission::INFO;
    const G2_FACTOR: f64 = 2.0;
    const TABULATED: bool = true;

    fn d(half: Vec3<f64>, alpha: (f64, f64)) -> f64 {
        d_ggx(half, alpha)
    }

    fn lambda(w: Vec3<f64>, alpha: (f64, f64)) -> f64 {
        lambda_ggx(w, alpha)
    }

    fn slope(rest: f64) -> f64 {
        libm::sqrt(1.0 / rest - 1.0)
    }

    fn steeper(slope: f64) -> f64 {
        1.0 / (1.0 + slope * slope)
    }

    #[inline(always)]
    fn alpha_scale<R: Real>(pair: &DirectionPair<R>) -> Option<R> {
        Some(pair.alpha_scale)
    }

    /// q² w² with q = |H|² / ((Hx/αx)² + (Hy/αy)² + w² Hz²), where w widens.
    #[inline(always)]
    fn d_unscaled<R: Real>(
        half: &HalfVector<R>,
        pair: &DirectionPair<R>,
        inverse2: (f64, f64),
        scale2: Option<R>,
    ) -> R {
        let w2 = scale2.unwrap_or(half.up2.one());
        let q = half.length2 / (half.across2(pair, inverse2) + half.up2 * w2);
        q.sqr() * w2
    }

    /// G2 / (4 cosθo cosθi) is 1 / (2 (cosθi Lo + cosθo Li)) with L = √(cos² + w² α² sin²).
    #[inline(always)]
    fn g2<R: Real>(pair: &DirectionPair<R>, squares: (f64, f64), scale2: Option<R>) -> (R, R) {
        let w2 = scale2.unwrap_or(pair.cos_o.one());
        let lo = (pair.cos_o.sqr() + w2 * stretched2(pair.cos_o, pair.tangent_o, squares)).sqrt();
        let li = (pair.cos_i.sqr() + w2 * stretched2(pair.cos_i, pair.tangent_i, squares)).sqrt();
        (pair.cos_i, pair.cos_i * lo + pair.cos_o * li)
    }

    fn transmission_scale(_square: f64) -> f64 {
        4.0 / glanz_math::PI
    }

    /// With q = 1 / (|H|² − Hz² + w² α² Hz²), D (wo·h)(wi·h) / (wo·h + η wi·h)² is w² α² q² |wo·H| |wi·H| / π, where w
    /// widens.
    #[inline(always)]
    fn transmitted<R: Real>(
        lobe: &SmithTransmission<Self>,
        half: &RefractedHalfVector<R>,
        pair: &DirectionPair<R>,
    ) -> R {
        let zero = pair.cos_o.zero();
        let w = pair.alpha_scale.max(zero.lit(LEAST_ALPHA / lobe.alpha()));
        let width2 = w.sqr() * zero.lit(lobe.square());
        let q = zero.one() / ((half.length2 - half.up2) + width2 * half.up2).max(zero.lit(1e-15));
        // 2 cosθ / (cosθ + √(cos²θ + α² sin²θ)) is G1.
        let down = -pair.cos_i;
        let masked = ggx_g1_denominator(pair.cos_o, width2) * ggx_g1_denominator(down, width2);
        q.sqr() * width2 * half.product * down * zero.lit(lobe.scale()) / masked
    }
}

/// cosθ + √(cos²θ + α² sin²θ).
#[inline(always)]
fn ggx_g1_denominator<R: Real>(cosine: R, width2: R) -> R {
    let sin2 = (cosine.one() - cosine.sqr()).max(cosine.zero());
    cosine + (cosine.sqr() + width2 * sin2).sqrt()
}
