//! The ways in which points are put that do not depend on the light: in the lobes, and over the hemisphere.

use glanz_math::{Frame, PI, Real, Vec3};

use super::points::SquarePoint;
use super::proposal::PointProposal;
use super::{Counts, ExactPoints};
use crate::cpu::lighting::light_sum::LightSum;

/// What is proposed at a point of a surface.
pub(super) struct Mixture<'a, R> {
    points: &'a ExactPoints,
    pub counts: Counts,
    /// The frame of the lobes: x, y and the normal.
    axes: [Vec3<R>; 3],
    lobes: Vec<PointProposal<R>>,
    /// Whether light can come from below, too.
    both_sides: bool,
}

impl<'a, R: Real> Mixture<'a, R> {
    #[inline(always)]
    pub(super) fn new(points: &'a ExactPoints, sum: &LightSum<R>, in_light: bool) -> Self {
        let material = sum.material;
        let (wo, normal, cos_o) = (sum.point.wo, sum.point.normal, sum.cos_o);
        let [x, y] = match sum.axes {
            Some(axes) => axes,
            None => {
                let around = Frame::around(normal);
                [around.t, around.b]
            }
        };
        // A view that is lifted to the least cosine stays a unit vector.
        let flat = [x.dot(wo), y.dot(wo)];
        let (one, squared) = (cos_o.one(), flat[0].sqr() + flat[1].sqr());
        let shrink = ((one - cos_o.sqr()).max(one.zero()) / squared.max(one.lit(1e-20))).sqrt().min(one);
        let wo = Vec3::new(flat[0] * shrink, flat[1] * shrink, cos_o.min(one));
        let mut lobes = Vec::with_capacity(material.proposals.len());
        for proposal in &material.proposals {
            let width = sum.width(&material.lobes[proposal.lobe]);
            lobes.push(proposal.at(wo, width));
        }
        let both_sides = material.transmits;
        let counts = points.counts(in_light, if both_sides { 2 } else { 1 });
        Self { points, counts, axes: [x, y, normal], lobes, both_sides }
    }

    /// How dense points of all ways are around a direction in the world.
    #[inline(always)]
    pub(super) fn density(&self, wi: Vec3<R>) -> R {
        let [x, y, z] = self.axes;
        self.density_of(Vec3::new(x.dot(wi), y.dot(wi), z.dot(wi)))
    }

    #[inline(always)]
    fn density_of(&self, local: Vec3<R>) -> R {
        let zero = local.z.zero();
        let cosine = if self.both_sides { local.z.abs() } else { local.z.max(zero) };
        let mut sum = cosine * zero.lit(self.counts.hemisphere as f64 / PI);
        for lobe in &self.lobes {
            sum = sum + lobe.density(local) * zero.lit(self.counts.lobe as f64);
        }
        sum
    }

    /// How many points of these ways there are.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        let sides = if self.both_sides { 2 } else { 1 };
        self.lobes.len() * self.counts.lobe + sides * self.counts.hemisphere
    }

    /// One of them: its direction in the world, how dense all ways are there, and where it is one.
    #[inline(always)]
    pub(super) fn point(&self, number: usize) -> (Vec3<R>, R, R::Mask) {
        let of_lobes = self.lobes.len() * self.counts.lobe;
        let (local, is_one) = match number < of_lobes {
            true => {
                let point = &self.points.lobe[number % self.counts.lobe];
                self.lobes[number / self.counts.lobe].direction(point.v, point.turn)
            }
            false => {
                let number = number - of_lobes;
                let sign = if number < self.counts.hemisphere { 1.0 } else { -1.0 };
                let local =
                    self.of_hemisphere(&self.points.hemisphere[number % self.counts.hemisphere], sign);
                (local, local.z.zero().lt(local.z.abs()))
            }
        };
        let [x, y, z] = self.axes;
        let wi = x * local.x + y * local.y + z * local.z;
        (wi, self.density_of(local), is_one)
    }

    /// As dense as the cosine.
    #[inline(always)]
    fn of_hemisphere(&self, point: &SquarePoint, sign: f64) -> Vec3<R> {
        let like = self.axes[2].x;
        let (radius, [cos, sin]) = (libm::sqrt(point.v), point.turn);
        Vec3::new(like.lit(radius * cos), like.lit(radius * sin), like.lit(sign * libm::sqrt(1.0 - point.v)))
    }
}
