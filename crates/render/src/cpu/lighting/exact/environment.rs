//! Light from all around.

use glanz_math::{Real, Vec3};

use super::ExactPoints;
use super::brightness::Brightness;
use super::gather::Gathered;
use super::mixture::Mixture;
use crate::cpu::lighting::environment::{Around, add_lobe, is_seen_through, refracted};
use crate::cpu::lighting::light_sum::{LightSum, is_transmitting};
use crate::cpu::lighting::shade_material::ShadeLights;
use crate::cpu::lighting::shadow;
use crate::view::lights::turned;

/// Adds what an environment gives.
#[inline(always)]
pub(crate) fn add<R: Real>(
    sum: &mut LightSum<R>,
    lights: &ShadeLights,
    points: &ExactPoints,
    around: Around,
) {
    let brightness = points.brightness(around.number);
    let mixture = Mixture::new(points, sum, brightness.is_some());
    let mut gathered = Gathered::<R, 3>::new(sum, around.row, true);
    let like = sum.cos_o;
    let in_light = like.lit(mixture.counts.light as f64);
    for point in brightness.iter().flat_map(|brightness| &brightness.points[..mixture.counts.light]) {
        let wi = from_map(like, around.to_map, point.direction);
        let total = in_light * like.lit(point.density) + mixture.density(wi);
        let [r, g, b] = point.amounts.map(f64::from);
        let amounts = [like.lit(r), like.lit(g), like.lit(b)];
        counted(sum, lights, &mut gathered, wi, (amounts, total), like.zero().lt(like.one()));
    }
    for number in 0..mixture.len() {
        let (wi, density, is_one) = mixture.point(number);
        let (amounts, own) = seen(around, brightness, wi);
        counted(sum, lights, &mut gathered, wi, (amounts, in_light * own + density), is_one);
    }
    gathered.finish(sum);
    add_mirrored(sum, lights, around);
}

/// Mirrors and clear boundaries show the environment itself.
#[inline(always)]
fn add_mirrored<R: Real>(sum: &mut LightSum<R>, lights: &ShadeLights, around: Around) {
    let material = sum.material;
    for (k, lobe) in material.lobes.iter().enumerate() {
        if !lobe.shape.info().delta || is_seen_through(material, lobe) {
            continue;
        }
        let (wo, normal) = (sum.point.wo, sum.point.normal);
        let ray = match is_transmitting(lobe) {
            true => refracted(wo, normal, sum.cos_o, lobe.shape.eta()),
            false => wo.reflected(normal),
        };
        let free = lights.bvh.map(|bvh| shadow::free(bvh, sum.point, ray, None));
        add_lobe(sum, around, k, free);
    }
}

/// Adds a point that stands for the inverse of how dense points are.
#[inline(always)]
fn counted<R: Real>(
    sum: &mut LightSum<R>,
    lights: &ShadeLights,
    gathered: &mut Gathered<R, 3>,
    wi: Vec3<R>,
    (amounts, density): ([R; 3], R),
    is_one: R::Mask,
) {
    let (zero, normal) = (density.zero(), sum.point.normal);
    // Without a normal there is no surface to light.
    let is_lit = normal.dot(normal).gt(zero.lit(0.25));
    let mut solid = zero.one() / density.max(zero.lit(1e-30));
    solid = solid.select(is_one & is_lit, zero);
    if let Some(arrives) = sum.arrives {
        solid = solid * arrives;
    }
    if let Some(bvh) = lights.bvh {
        solid = solid * shadow::free(bvh, sum.point, wi, None);
    }
    let [r, g, b] = amounts;
    gathered.add(sum, wi, [r * solid, g * solid, b * solid]);
}

/// The environment in a direction, and how dense its points are there.
#[inline(never)]
fn seen<R: Real>(around: Around, brightness: Option<&Brightness>, wi: Vec3<R>) -> ([R; 3], R) {
    wi.x.at_own_level(
        #[inline(always)]
        || {
            let direction = turned(around.to_map, wi);
            let amounts = match &around.environment.map {
                Some(map) => map.at(direction),
                None => [wi.x.one(); 3],
            };
            (amounts, brightness.map_or(wi.x.zero(), |brightness| brightness.density(direction)))
        },
    )
}

/// From an environment's own directions to the world's.
#[inline(always)]
fn from_map<R: Real>(like: R, to_map: &[[f32; 3]; 3], [x, y, z]: [f64; 3]) -> Vec3<R> {
    let along = |axis: usize| {
        let [a, b, c] = [0, 1, 2].map(|row: usize| f64::from(to_map[row][axis]));
        a * x + b * y + c * z
    };
    Vec3::new(like.lit(along(0)), like.lit(along(1)), like.lit(along(2)))
}
