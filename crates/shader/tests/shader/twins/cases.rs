//! The parameters and the directions that twins are compared at.

use glanz_bsdf::laws::directions;
use glanz_bsdf::wgsl::Twin;
use glanz_bsdf::{MODELS, ModelInfo, ParamInfo, Shape};
use glanz_math::Vec3;

use super::Place;
use crate::common::Numbers;

/// Shapes of the twin's model, each with the grid of the laws and so many random places.
pub(super) fn cases(twin: &Twin, random: usize) -> impl Iterator<Item = (Shape, Vec<Place>)> {
    let info = MODELS.iter().find(|info| info.name == twin.model).expect("it is in the list");
    parameters(info).into_iter().enumerate().map(move |(i, values)| {
        let set: Vec<_> = info.params.iter().map(|param| param.name).zip(values).collect();
        let shape = Shape::named(info.name, &set).expect("all are in range");
        let places = places(&shape, random, i as u32 + 1);
        (shape, places)
    })
}

/// Sets of parameters: the defaults, all ends of all ranges, some at random, and what models have paths for.
fn parameters(info: &ModelInfo) -> Vec<Vec<f64>> {
    let set = |of: &mut dyn FnMut(usize, &ParamInfo) -> f64| -> Vec<f64> {
        info.params.iter().enumerate().map(|(i, param)| of(i, param)).collect()
    };
    let defaults = set(&mut |_, param| param.default);
    let mut sets = vec![defaults.clone()];
    if defaults.is_empty() {
        return sets;
    }
    for ends in 0..1 << defaults.len() {
        sets.push(set(&mut |i, param| if ends >> i & 1 == 0 { param.min } else { param.max }));
    }
    let mut numbers = Numbers(7);
    for _ in 0..4 {
        sets.push(set(&mut |_, param| param.min + f64::from(numbers.unit()) * (param.max - param.min)));
    }
    let special = special(info.params[0].name);
    sets.extend(special.iter().map(|first| [first, &defaults[first.len()..]].concat()));
    sets
}

/// First parameters that take another path, by the name of the first.
fn special(name: &str) -> &[&[f64]] {
    match name {
        // Products of every kind up to the greatest, powers beyond and between.
        "shininess" => &[
            &[0.25],
            &[1.0],
            &[1.5],
            &[2.0],
            &[3.0],
            &[6.0],
            &[7.0],
            &[11.0],
            &[20.0],
            &[64.0],
            &[100.0],
            &[127.0],
            &[128.0],
            &[128.5],
            &[129.0],
            &[1e4],
        ],
        // Widths that differ, hardly do, and do in double precision alone.
        "alpha" => {
            &[&[0.05, 0.16], &[0.6, 0.2], &[0.9, 1e-4], &[0.3, 0.3], &[0.2, 0.2 + 1e-7], &[0.2, 0.2 + 1e-12]]
        }
        "m" => &[&[0.1, 0.4, 0.3], &[0.3, 0.3, 1e-9]],
        _ => &[],
    }
}

fn places(shape: &Shape, random: usize, seed: u32) -> Vec<Place> {
    let grid = directions(shape).into_iter();
    let grid = grid.map(|[wo, wi]| Place { wo: in_f32(wo), wi: in_f32(wi), alpha_scale: 1.0 });
    let mut numbers = Numbers(seed);
    grid.chain(std::iter::repeat_with(|| random_place(&mut numbers)).take(random)).collect()
}

/// A random place: anywhere, near the horizon, near the mirror direction, near opposite, along the normal, or where |wo + wi|²
/// begins to be taken from the vectors.
pub(super) fn random_place(numbers: &mut Numbers) -> Place {
    let (origin, up) = (Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
    let (wo, wi) = (near(numbers, origin, 1.0), near(numbers, origin, 1.0));
    let little = 10_f64.powf(-8.0 * f64::from(numbers.unit()));
    let low = |v: Vec3<f64>| Vec3::new(v.x, v.y, v.z * little).normalized();
    let above = Vec3::new(wo.x, wo.y, wo.z.abs());
    let (wo, wi) = match numbers.below(7) {
        0 => (wo, wi),
        1 => (low(wo), wi),
        2 => (low(wo), low(wi)),
        3 => (above, near(numbers, above.reflected(up), little)),
        4 => (wo, near(numbers, -wo, little)),
        5 => (wo, near(numbers, wo * -0.875 + across(wo, wi) * 0.234_375_f64.sqrt(), little)),
        _ => (near(numbers, up, little), near(numbers, up, little)),
    };
    let alpha_scale = if numbers.below(2) == 0 { 1.0 } else { numbers.unit() };
    Place { wo: in_f32(wo), wi: in_f32(wi), alpha_scale }
}

/// The unit vector across `w` in the plane of both.
fn across(w: Vec3<f64>, other: Vec3<f64>) -> Vec3<f64> {
    (other - w * w.dot(other)).normalized()
}

/// A unit vector at a distance from another one.
fn near(numbers: &mut Numbers, center: Vec3<f64>, distance: f64) -> Vec3<f64> {
    let mut signed = || distance * (2.0 * f64::from(numbers.unit()) - 1.0);
    (center + Vec3::new(signed(), signed(), signed())).normalized()
}

fn in_f32(v: Vec3<f64>) -> Vec3<f32> {
    Vec3::new(v.x as f32, v.y as f32, v.z as f32)
}
