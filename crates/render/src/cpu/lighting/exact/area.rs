//! Surfaces that shine.

use glanz_math::{Frame, PI, Real, Vec3};
use glanz_scene::AreaShape;

use super::ExactPoints;
use super::gather::Gathered;
use super::mixture::Mixture;
use super::points::SquarePoint;
use crate::cpu::lighting::environment::refracted;
use crate::cpu::lighting::light_sum::{LightSum, is_transmitting, layered};
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::shade_material::ShadeLights;
use crate::cpu::lighting::shadow;
use crate::view::lights::{ViewArea, splat};

/// Adds what an area gives.
#[inline(always)]
pub(crate) fn add<R: Real>(
    sum: &mut LightSum<R>,
    lights: &ShadeLights,
    points: &ExactPoints,
    area: &ViewArea,
    row: usize,
) {
    let target = Target::new(area, sum.point.position);
    let mixture = Mixture::new(points, sum, true);
    let mut gathered = Gathered::<R, 1>::new(sum, row, false);
    let in_light = sum.cos_o.lit(mixture.counts.light as f64);
    for point in &points.light[..mixture.counts.light] {
        let Met { wi, distance, density, is_met } = target.point(point);
        let total = density * in_light + mixture.density(wi);
        counted(sum, lights, &mut gathered, (wi, distance), total, is_met);
    }
    for number in 0..mixture.len() {
        let (wi, density, is_one) = mixture.point(number);
        let met = target.met(wi);
        let total = met.density * in_light + density;
        counted(sum, lights, &mut gathered, (wi, met.distance), total, met.is_met & is_one);
    }
    gathered.finish(sum);
    add_mirrored(sum, lights, &target, row);
}

/// Adds a point that stands for the inverse of how dense points are.
#[inline(always)]
fn counted<R: Real>(
    sum: &mut LightSum<R>,
    lights: &ShadeLights,
    gathered: &mut Gathered<R, 1>,
    (wi, distance): (Vec3<R>, R),
    density: R,
    is_met: R::Mask,
) {
    if !R::any(is_met) {
        return;
    }
    let zero = distance.zero();
    let solid = zero.one() / density.max(zero.lit(1e-30));
    let solid = solid.select(is_met & is_lit(sum.point), zero) * visible(sum.point, lights, wi, distance);
    gathered.add(sum, wi, [solid]);
}

/// Where there is a normal.
#[inline(always)]
fn is_lit<R: Real>(point: &ShadingPoint<R>) -> R::Mask {
    let normal = point.normal;
    normal.dot(normal).gt(normal.x.lit(0.25))
}

#[inline(always)]
fn visible<R: Real>(point: &ShadingPoint<R>, lights: &ShadeLights, wi: Vec3<R>, distance: R) -> R {
    match lights.bvh {
        Some(bvh) => shadow::free(bvh, point, wi, Some(distance)),
        None => distance.one(),
    }
}

/// Mirrors and clear boundaries show the light itself.
#[inline(always)]
fn add_mirrored<R: Real>(sum: &mut LightSum<R>, lights: &ShadeLights, target: &Target<R>, row: usize) {
    let material = sum.material;
    for (k, lobe) in material.lobes.iter().enumerate().filter(|(_, lobe)| lobe.shape.info().delta) {
        let (wo, normal, zero) = (sum.point.wo, sum.point.normal, sum.cos_o.zero());
        let ray = match is_transmitting(lobe) {
            true => refracted(wo, normal, sum.cos_o, lobe.shape.eta()),
            false => wo.reflected(normal),
        };
        let met = target.met(ray);
        let shown = zero.one().select(met.is_met & is_lit(sum.point), zero);
        let shown = shown * visible(sum.point, lights, ray, met.distance);
        let pair = sum.typical_pair(lobe);
        sum.add(row, k, layered(lobe, shown, &pair), &pair);
    }
}

/// A light as seen from a point.
struct Target<'a, R> {
    area: &'a ViewArea,
    center: Vec3<R>,
    axes: [Vec3<R>; 3],
    /// Of a sphere: the frame towards it, its squared distance, and 1 − cos of the angle of its rim.
    cone: Option<(Frame<R>, R, R)>,
}

/// Where a direction meets a light.
struct Met<R: Real> {
    wi: Vec3<R>,
    distance: R,
    /// How dense its points are there, per steradian.
    density: R,
    is_met: R::Mask,
}

impl<'a, R: Real> Target<'a, R> {
    #[inline(always)]
    fn new(area: &'a ViewArea, position: Vec3<R>) -> Self {
        let zero = position.x.zero();
        let center = splat(zero, &area.center) - position;
        let [a, b, c] = &area.axes;
        let axes = [splat(zero, a), splat(zero, b), splat(zero, c)];
        let cone = match area.form {
            AreaShape::Sphere { radius } => {
                // From within a sphere it is half of all that there is.
                let squared = center.dot(center).max(zero.lit(radius * radius * 1.000_001));
                let sine2 = zero.lit(radius * radius) / squared;
                let low = sine2 / (zero.one() + (zero.one() - sine2).max(zero).sqrt());
                let towards = center * center.dot(center).max(zero.lit(1e-30)).rsqrt();
                Some((Frame::around(towards), squared, low))
            }
            _ => None,
        };
        Self { area, center, axes, cone }
    }

    /// A point of the light.
    #[inline(always)]
    fn point(&self, point: &SquarePoint) -> Met<R> {
        let zero = self.center.x.zero();
        let (x, y) = match self.area.form {
            AreaShape::Rectangle { width, height } => (width * (point.u - 0.5), height * (point.v - 0.5)),
            AreaShape::Disk { radius } => {
                let off = radius * libm::sqrt(point.v);
                (off * point.turn[0], off * point.turn[1])
            }
            AreaShape::Sphere { .. } => return self.of_cone(point),
        };
        let to = self.center + self.axes[0] * zero.lit(x) + self.axes[1] * zero.lit(y);
        let squared = to.dot(to).max(zero.lit(1e-30));
        let inverse = squared.rsqrt();
        self.flat(to * inverse, squared, squared * inverse)
    }

    /// A point of the cone under which a sphere is seen.
    #[inline(always)]
    fn of_cone(&self, point: &SquarePoint) -> Met<R> {
        let (frame, squared, low) = self.cone.as_ref().expect("a sphere has a cone");
        let one = squared.one();
        let down = *low * one.lit(point.v);
        let (sine, cosine) = ((down * (one + one - down)).max(one.zero()).sqrt(), one - down);
        let [cos, sin] = point.turn;
        let wi = frame.t * sine * one.lit(cos) + frame.b * sine * one.lit(sin) + frame.n * cosine;
        let distance = self.to_sphere(squared.sqrt() * cosine, *squared * sine.sqr());
        Met { wi, distance, density: Self::of_low(*low), is_met: one.zero().lt(one) }
    }

    /// How far it is to the front of the sphere, by how far it is to where the ray is nearest to its centre.
    #[inline(always)]
    fn to_sphere(&self, nearest: R, off2: R) -> R {
        let AreaShape::Sphere { radius } = self.area.form else { return nearest };
        (nearest - (nearest.lit(radius * radius) - off2).max(nearest.zero()).sqrt()).max(nearest.zero())
    }

    /// How dense points of a cone are.
    #[inline(always)]
    fn of_low(low: R) -> R {
        low.one() / (low * low.lit(2.0 * PI)).max(low.lit(1e-30))
    }

    /// What a direction meets.
    #[inline(always)]
    fn met(&self, wi: Vec3<R>) -> Met<R> {
        let zero = wi.x.zero();
        if let (AreaShape::Sphere { radius }, Some((_, _, low))) = (self.area.form, &self.cone) {
            let nearest = self.center.dot(wi);
            let off = self.center.cross(wi);
            let off2 = off.dot(off);
            let is_met = off2.lt(zero.lit(radius * radius)) & zero.lt(nearest);
            return Met { wi, distance: self.to_sphere(nearest, off2), density: Self::of_low(*low), is_met };
        }
        let slope = self.axes[2].dot(wi);
        let slope = slope.select(slope.abs().gt(zero.lit(1e-20)), zero.lit(1e-20));
        let distance = self.axes[2].dot(self.center) / slope;
        let from_center = wi * distance - self.center;
        let (x, y) = (self.axes[0].dot(from_center), self.axes[1].dot(from_center));
        let inside = match self.area.form {
            AreaShape::Rectangle { width, height } => {
                x.abs().lt(zero.lit(0.5 * width)) & y.abs().lt(zero.lit(0.5 * height))
            }
            AreaShape::Disk { radius } | AreaShape::Sphere { radius } => {
                (x.sqr() + y.sqr()).lt(zero.lit(radius * radius))
            }
        };
        let met = self.flat(wi, distance.sqr(), distance);
        Met { is_met: met.is_met & inside & zero.lt(distance), ..met }
    }

    /// A point of a flat light.
    #[inline(always)]
    fn flat(&self, wi: Vec3<R>, squared: R, distance: R) -> Met<R> {
        let zero = wi.x.zero();
        let facing = wi.dot(self.axes[2]);
        let density = squared / (facing.abs().max(zero.lit(1e-20)) * zero.lit(self.area.form.area()));
        let faces = facing.lt(zero);
        let is_met = if self.area.two_sided { zero.lt(facing.abs()) } else { faces };
        Met { wi, distance, density, is_met }
    }
}
