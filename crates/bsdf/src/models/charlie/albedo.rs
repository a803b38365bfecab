//! The directional albedo of the sheen, by which the layers below are scaled.

use glanz_math::{GaussLegendre, PI, Real, Vec3};

use serde::{Deserialize, Serialize};

use super::Charlie;
use crate::{DirectionPair, Model};

/// Terms of the series: enough for an error of 0.003 (see [`Albedo`]).
const TERMS: usize = 13;

/// The cosine of the flattest view that is told apart, 89.9°. Closer to the horizon the fit of Λ makes the
/// albedo rise once more, which no cloth does.
const FLATTEST: f64 = 0.002;

/// Points of the quadrature per direction.
const POINTS: usize = 32;

/// The directional albedo E(cosθ) of a sheen, as a series in √cosθ: what glTF's scaling of the base wants.
///
/// Made by quadrature for one α, in about 13 × 1024 values of the lobe; then twelve products for a view. Off
/// by 0.003 at most from 0.001 (narrow, where it comes to 4) to 1 (0.0003). Cosines below 0.002 count as
/// that. It is more than 1 where the lobe breaks the law of energy, for α below 0.07 near the horizon: a
/// layer below must then get nothing, and not less.
///
/// ```
/// use glanz_bsdf::models::charlie::Albedo;
///
/// // The sheen of velvet grows towards the limb.
/// let sheen = Albedo::new(0.25);
/// let (facing, limb): (f64, f64) = (sheen.at(1.0), sheen.at(0.5));
/// assert!((facing - 0.027).abs() < 3e-3 && (limb - 0.188).abs() < 3e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Albedo {
    /// Of the Chebyshev polynomials in √cosθ, from the flattest view to the normal.
    series: [f64; TERMS],
}

impl Albedo {
    /// The albedo of the sheen of width `alpha`, 0.001 … 1 (clipped).
    pub fn new(alpha: f64) -> Self {
        let [range] = Charlie::INFO.params else { unreachable!("a sheen has one parameter") };
        let sheen = Charlie::from_params(&[alpha.clamp(range.min, range.max)]);
        let flattest = libm::sqrt(FLATTEST);
        let angle = |node: usize| PI * (node as f64 + 0.5) / TERMS as f64;
        let values: [f64; TERMS] = core::array::from_fn(|node| {
            let root = flattest + (1.0 - flattest) * 0.5 * (1.0 + libm::cos(angle(node)));
            integral(&sheen, root * root)
        });
        let series = core::array::from_fn(|term| {
            let wave = |(node, value): (usize, &f64)| value * libm::cos(term as f64 * angle(node));
            let factor = if term == 0 { 1.0 } else { 2.0 };
            factor / TERMS as f64 * values.iter().enumerate().map(wave).sum::<f64>()
        });
        Self { series }
    }

    /// The albedo with these coefficients, from [`Self::series`].
    pub const fn from_series(series: [f64; TERMS]) -> Self {
        Self { series }
    }

    /// The coefficients of its series, of degree 0 first.
    pub const fn series(&self) -> &[f64; TERMS] {
        &self.series
    }

    /// E for a direction `cosine` off the normal, 0 … 1.
    #[inline(always)]
    pub fn at<R: Real>(&self, cosine: R) -> R {
        let flattest = libm::sqrt(FLATTEST);
        let root = cosine.clamp(FLATTEST, 1.0).sqrt();
        // Clenshaw's recurrence in twice the polynomials' argument.
        let twice =
            root * root.lit(4.0 / (1.0 - flattest)) - root.lit(2.0 * (1.0 + flattest) / (1.0 - flattest));
        let (mut sum, mut before) = (root.zero(), root.zero());
        for coefficient in self.series[1..].iter().rev() {
            (sum, before) = (twice * sum - before + root.lit(*coefficient), sum);
        }
        (twice * root.lit(0.5) * sum - before + root.lit(self.series[0])).max(root.zero())
    }
}

/// ∫ f_cos dωi for the view angle whose cosine is `cos_o`, with more points near the horizon.
fn integral(sheen: &Charlie, cos_o: f64) -> f64 {
    let rule = GaussLegendre::new(POINTS);
    let wo = Vec3::new(libm::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o);
    rule.integrate(0.0, 1.0, |root| {
        let cos_i = root * root;
        let sin_i = libm::sqrt(1.0 - cos_i * cos_i);
        let ring = rule.integrate(0.0, PI, |phi| {
            let wi = Vec3::new(sin_i * libm::cos(phi), sin_i * libm::sin(phi), cos_i);
            sheen.f_cos(&DirectionPair::new(wo, wi))
        });
        // Both halves of the circle, and dcosθ = 2 root droot.
        4.0 * root * ring
    })
}
