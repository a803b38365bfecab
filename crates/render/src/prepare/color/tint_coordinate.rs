//! Which coordinate the tint of a lobe has, and what the tint is there.

use glanz_bsdf::{LightTerm, Side};
use glanz_scene::{Lobe, Tint};

use crate::prepare::color::interfaces;
use crate::prepare::color::quadrature::{Sampling, Surface};
use crate::prepare::data::tint_coordinate::{TintCoordinate, cosine_inside, longest};

/// The coordinate of a lobe. Light that comes back diffusely meets no facet: for it, tints by Fresnel's law
/// are taken at normal incidence.
pub(crate) fn coordinate_of(lobe: &Lobe) -> TintCoordinate {
    let mirrors = lobe.shape.info().term == LightTerm::Specular;
    match &lobe.absorption {
        _ if mirrors && lobe.tint.depends_on_angle() => TintCoordinate::HalfAngle,
        Some(coat) => TintCoordinate::CoatPath { eta: coat.eta },
        None => TintCoordinate::None,
    }
}

/// The length of the path through the coat at a coordinate, in thicknesses. Behind facets it is that of
/// light that is mirrored, where such lobes have nearly all of theirs.
fn path(coordinate: TintCoordinate, at: f64, eta: f64) -> f64 {
    match coordinate {
        TintCoordinate::None => 2.0,
        TintCoordinate::HalfAngle => 2.0 / cosine_inside(at, eta).max(1e-3),
        TintCoordinate::CoatPath { eta } => 2.0 + at * (longest(eta) - 2.0),
    }
}

/// A lobe's tint at the nodes of a colour mode, at a coordinate.
pub(crate) fn surface(sampling: &Sampling, lobe: &Lobe, coordinate: TintCoordinate, at: f64) -> Surface {
    let cosine = if coordinate == TintCoordinate::HalfAngle { at } else { 1.0 };
    if let (Tint::Coated(boundary), Some(coat)) = (&lobe.tint, &lobe.absorption) {
        let left = interfaces::left(&coat.depth, path(coordinate, at, coat.eta));
        return sampling.coated(boundary, cosine, &left);
    }
    let mut surface = sampling.surface(&lobe.tint, cosine);
    if lobe.shape.info().side == Side::Transmission && lobe.tint.depends_on_angle() {
        surface = surface.complement();
    }
    match &lobe.absorption {
        Some(coat) => surface.dimmed(&sampling.left_by(&coat.depth, path(coordinate, at, coat.eta))),
        None => surface,
    }
}
