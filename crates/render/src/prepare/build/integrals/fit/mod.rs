//! Lobes as sums of parts that have an integral: lookups in the chain of an environment, and linearly transformed
//! cosines, which are exact over polygons; fitted view by view.
//!
//! Each view begins with the result of its neighbour, the first with the best of a few guesses. What is made small
//! is the error of the mass of patches that grow with their distance from the middle: light from one window errs as much
//! wherever it is.

mod guess;
mod lookups;
mod ltc;
mod points;
mod scale;
mod solve;

use glanz_bsdf::{DirectionPair, LightTerm, Shape, Side};
use glanz_math::{PI, Vec3};

use crate::prepare::data::view_nodes::{FLATTEST, VIEWS};
use crate::prepare::data::{LobeLookups, Lookup, LtcTable, ViewNodes};
use lookups::LookupFit;
use ltc::LtcFit;
use points::Points;
use scale::Scale;
use solve::{Problem, views};

/// Lobes narrower than this, in slopes, are seen as their middle.
const NARROWEST: f64 = 0.002;

/// Views, and what is half-way between them.
const HALVES: usize = 2 * VIEWS - 1;

/// Azimuths of a lobe with a grain, of one quarter.
const AZIMUTHS: usize = 7;

/// Lookups of a round lobe, and the most of one with a grain.
const COUNT: usize = 8;
const MOST: usize = 16;

/// Lookups of a round lobe of which the fewer leave more than this.
const MORE: usize = 10;
const MORE_FROM: f64 = 0.004;

/// Lobes of which two transformed cosines leave more than this take three.
const THREE_FROM: f64 = 0.006;

/// A lobe at points for all views.
pub(crate) struct Views {
    scale: Scale,
    nodes: ViewNodes,
    is_anisotropic: bool,
    /// By azimuth and view, half-way between the views too.
    points: Vec<Points>,
}

impl Views {
    /// Of a shape that has a width.
    pub(crate) fn of(shape: &Shape, term: LightTerm) -> Self {
        let scale = Scale::of(shape, term);
        let is_anisotropic = shape.is_anisotropic() && !is_round(shape);
        let quarters = if !is_anisotropic || is_symmetric(shape) { 1 } else { 4 };
        let azimuths = if is_anisotropic { (AZIMUTHS - 1) * quarters + 1 } else { 1 };
        let nodes = ViewNodes { azimuths, quarters };
        let points = (0..azimuths * HALVES).map(|i| {
            let phi = (i / HALVES) as f64 * 0.5 * PI / (AZIMUTHS - 1) as f64;
            Points::of(shape, &scale, Vec3::from_angles(half_angle(i % HALVES), phi))
        });
        let points = points.collect();
        Self { scale, nodes, is_anisotropic, points }
    }

    /// The lobe as lookups.
    pub(crate) fn lookups(&self) -> LobeLookups {
        if self.scale.slope < NARROWEST {
            let middle = Lookup { direction: [0.0, 0.0, 1.0], place: 0.0, amount: 1.0 };
            let nodes = ViewNodes { azimuths: 1, quarters: 1 };
            return LobeLookups {
                count: 1,
                nodes,
                lookups: vec![middle; VIEWS],
                cosine: Vec::new(),
                wide: false,
            };
        }
        let grain = if self.is_anisotropic { self.scale.grain() } else { 1.0 };
        let count = ((COUNT as f64 * libm::sqrt(grain)) as usize).clamp(COUNT, MOST);
        let (lookups, cost) = self.lookups_of(count);
        if cost < MORE_FROM || self.is_anisotropic { lookups } else { self.lookups_of(MORE).0 }
    }

    /// So many lookups of each view, and what they leave of the lobe.
    fn lookups_of(&self, count: usize) -> (LobeLookups, f64) {
        let (mut lookups, mut cosine) = (Vec::new(), Vec::new());
        let cost = self.each(
            |points| LookupFit::new(points, &self.scale, count),
            |fit, x| {
                let (own, rest) = fit.normalized(x);
                lookups.extend(own);
                cosine.extend(rest);
            },
        );
        (LobeLookups { count, nodes: self.nodes, lookups, cosine, wide: self.scale.wide }, cost)
    }

    /// The lobe as linearly transformed cosines.
    pub(crate) fn ltc(&self) -> LtcTable {
        let (table, cost) = self.ltc_of(2);
        if cost < THREE_FROM { table } else { self.ltc_of(3).0 }
    }

    fn ltc_of(&self, count: usize) -> (LtcTable, f64) {
        let mut components = Vec::new();
        let cost = self.each(
            |points| LtcFit::new(points, &self.scale, count, self.is_anisotropic),
            |fit, x| components.extend(fit.components(x)),
        );
        (LtcTable { count, nodes: self.nodes, components }, cost)
    }

    /// Fits all views of one azimuth after the other, and gives what was found in their order. Returns the mean of what is
    /// left, in parts of the lobe, both squared.
    fn each<'a, P: Problem>(
        &'a self,
        make: impl Fn(&'a Points) -> P,
        mut give: impl FnMut(&P, &[f64]),
    ) -> f64 {
        let mut before: Option<Vec<Vec<f64>>> = None;
        let mut left = 0.0;
        for points in self.points.chunks(HALVES) {
            let mut nodes: Vec<P> = points.iter().step_by(2).map(&make).collect();
            let mut between: Vec<P> = points[1..].iter().step_by(2).map(&make).collect();
            let (found, own) = views(&mut nodes, &mut between, before.as_deref());
            for (problem, x) in nodes.iter().zip(&found) {
                give(problem, x);
            }
            left += own;
            before = Some(found);
        }
        left / self.nodes.azimuths as f64
    }
}

/// The angle of a view, or half-way between two.
fn half_angle(i: usize) -> f64 {
    FLATTEST * i as f64 / (HALVES - 1) as f64
}

/// Whether a lobe is the same for all azimuths of the viewer: tried at a few pairs.
pub(crate) fn is_round(shape: &Shape) -> bool {
    let below = if shape.info().side == Side::Transmission { -1.0 } else { 1.0 };
    let tried = [(0.3, 0.4, 2.0), (0.9, 0.8, -1.2), (1.2, 1.1, 0.4), (0.6, 0.2, 1.0)];
    tried.into_iter().all(|(theta_o, theta_i, phi)| {
        let value = |turn: f64| {
            let (o, i) = (Vec3::from_angles(theta_o, turn), Vec3::from_angles(theta_i, phi + turn));
            shape.f_cos(&DirectionPair::new(o, Vec3::new(i.x, i.y, i.z * below)))
        };
        let own = value(0.0);
        [0.3, 1.1, 1.57].into_iter().all(|turn| (value(turn) - own).abs() <= 1e-9 * own.abs().max(1e-9))
    })
}

/// Whether a lobe is the same on both sides of both of its axes: tried at a few pairs.
fn is_symmetric(shape: &Shape) -> bool {
    let below = if shape.info().side == Side::Transmission { -1.0 } else { 1.0 };
    let tried = [(0.3, 0.4, 0.5, 2.0), (0.9, 1.9, 0.8, -1.2), (1.2, 3.0, 1.1, 0.4), (0.6, -2.0, 0.2, 1.0)];
    tried.into_iter().all(|(theta_o, phi_o, theta_i, phi_i)| {
        let value = |x: f64, y: f64| {
            let (o, i) = (Vec3::from_angles(theta_o, phi_o), Vec3::from_angles(theta_i, phi_i));
            let turned = |v: Vec3<f64>, side: f64| Vec3::new(v.x * x, v.y * y, v.z * side);
            shape.f_cos(&DirectionPair::new(turned(o, 1.0), turned(i, below)))
        };
        let (own, scale) = (value(1.0, 1.0), 1e-9);
        [value(-1.0, 1.0), value(1.0, -1.0)]
            .iter()
            .all(|other| (other - own).abs() <= scale * own.abs().max(1e-9))
    })
}
