//! On which one number of the angles a tint depends.

use glanz_bsdf::{DirectionPair, LightTerm, Shape, Side};
use glanz_math::Real;
use glanz_scene::Lobe;

use crate::prepare::color::interfaces::cosine_inside;
use crate::prepare::color::quadrature::{Sampling, Surface};

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
    /// The coordinate of a lobe. Light that comes back diffusely meets no facet: for it, tints by Fresnel's law
    /// are taken at normal incidence.
    pub(crate) fn of(lobe: &Lobe) -> Self {
        let mirrors = lobe.shape.info().term == LightTerm::Specular;
        match &lobe.absorption {
            _ if mirrors && lobe.tint.depends_on_angle() => Self::HalfAngle,
            Some(coat) => Self::CoatPath { eta: coat.eta },
            None => Self::None,
        }
    }

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

    /// The length of the path through the coat at a coordinate, in thicknesses. Behind facets it is that of
    /// light that is mirrored, where such lobes have nearly all of theirs.
    fn path(self, at: f64, eta: f64) -> f64 {
        match self {
            Self::None => 2.0,
            Self::HalfAngle => 2.0 / cosine_inside(at, eta).max(1e-3),
            Self::CoatPath { eta } => 2.0 + at * (longest(eta) - 2.0),
        }
    }
}

/// The path of light that grazes the coat both ways, in thicknesses.
fn longest(eta: f64) -> f64 {
    2.0 / cosine_inside(0.0, eta).max(1e-3)
}

/// A lobe's tint at the nodes of a colour mode, at a coordinate.
pub(crate) fn surface(sampling: &Sampling, lobe: &Lobe, coordinate: TintCoordinate, at: f64) -> Surface {
    let cosine = if coordinate == TintCoordinate::HalfAngle { at } else { 1.0 };
    let mut surface = sampling.surface(&lobe.tint, cosine);
    if lobe.shape.info().side == Side::Transmission && lobe.tint.depends_on_angle() {
        surface = surface.complement();
    }
    match &lobe.absorption {
        Some(coat) => surface.dimmed(&sampling.left_by(&coat.depth, coordinate.path(at, coat.eta))),
        None => surface,
    }
}
