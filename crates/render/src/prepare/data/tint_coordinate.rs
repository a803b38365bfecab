//! The coordinate of an angle-dependent tint: none, half-angle cosine, or path through the coat.

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Real;

/// The coordinate, 0 … 1, along which a lobe's tint is a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TintCoordinate {
    /// None: the tint is one number per channel.
    None,
    /// The cosine at which light meets the facet that sends it on ([`Shape::tint_cosine`]).
    HalfAngle,
    /// The way in and out through an absorbing coat of this index of refraction: 0 for the shortest.
    CoatPath {
        /// The coat's index of refraction.
        eta: f64,
    },
}

impl TintCoordinate {
    /// The coordinate of two directions.
    #[inline(always)]
    pub fn at<R: Real>(&self, shape: &Shape, pair: &DirectionPair<R>) -> R {
        match self {
            Self::None => pair.cos_o.one(),
            Self::HalfAngle => shape.tint_cosine(pair),
            Self::CoatPath { eta } => {
                let way = |cosine: R| {
                    let sin2 = (cosine.one() - cosine.sqr()) * cosine.lit(1.0 / (eta * eta));
                    (cosine.one() - sin2).max(cosine.lit(1e-6)).rsqrt()
                };
                let excess = way(pair.cos_o) + way(pair.cos_i) - pair.cos_o.lit(2.0);
                (excess * pair.cos_o.lit(1.0 / (longest(*eta) - 2.0))).clamp(0.0, 1.0)
            }
        }
    }
}

/// The path of light that grazes the coat both ways, in thicknesses.
pub(crate) fn longest(eta: f64) -> f64 {
    2.0 / cosine_inside(0.0, eta).max(1e-3)
}

/// The cosine of the refracted ray.
pub(crate) fn cosine_inside(cosine: f64, eta: f64) -> f64 {
    let sin2 = (1.0 - cosine * cosine) / (eta * eta);
    libm::sqrt((1.0 - sin2).max(0.0))
}
