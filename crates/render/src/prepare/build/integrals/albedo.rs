//! The albedo of a lobe under its layers.

use glanz_bsdf::{DirectionPair, LayerWeight, Shape, Side};
use glanz_math::simd::Simd;
use glanz_math::{Chebyshev, Lanes, PI, Real, SimdLevel, Vec3, at_level};

use crate::prepare::data::Albedo;

/// Terms over the cosine.
const TERMS: usize = 16;

/// Rings around the middle of the lobe, ever wider, and points on each: within 1e-3 for the narrowest.
const RINGS: usize = 240;
const SPOKES: usize = 48;

/// Azimuths from the x axis to the y axis, of lobes with a grain.
const AZIMUTHS: usize = 5;

/// The albedo of a lobe; of a perfect mirror what the layers above leave in its one direction is not part of it.
pub(crate) fn albedo(shape: &Shape, layers: &[LayerWeight]) -> Albedo {
    if shape.info().delta {
        return Albedo::constant();
    }
    let has_grain = shape.is_anisotropic() || layers.iter().any(LayerWeight::is_anisotropic);
    if !has_grain {
        let mean = Chebyshev::interpolate(TERMS, |cosine| at(shape, layers, cosine, 0.0));
        return Albedo { mean, waves: Vec::new() };
    }
    let azimuth = |i: usize| 0.5 * PI * i as f64 / (AZIMUTHS - 1) as f64;
    let nodes: Vec<f64> = glanz_math::chebyshev_nodes(TERMS).collect();
    let of_node = |i: usize| (0..AZIMUTHS).map(|k| at(shape, layers, nodes[i], azimuth(k))).collect();
    let values: Vec<Vec<f64>> = crate::parallel::collect(TERMS, of_node);
    // The trapezoidal rule over even waves.
    let wave = |order: usize| {
        let part = |values: &Vec<f64>| {
            let term = |k: usize| {
                let end = if k == 0 || k == AZIMUTHS - 1 { 0.5 } else { 1.0 };
                end * values[k] * libm::cos(2.0 * order as f64 * azimuth(k))
            };
            let both = if order == 0 { 1.0 } else { 2.0 };
            both * (0..AZIMUTHS).map(term).sum::<f64>() / (AZIMUTHS - 1) as f64
        };
        let parts: Vec<f64> = values.iter().map(part).collect();
        Chebyshev::interpolate(TERMS, |cosine| {
            nodes.iter().position(|node| *node == cosine).map_or(0.0, |place| parts[place])
        })
    };
    Albedo { mean: wave(0), waves: vec![wave(1), wave(2)] }
}

/// For a viewer at an angle of this cosine. [`glanz_bsdf::layered_albedo`] is more exact and takes a thousand times as
/// long.
fn at(shape: &Shape, layers: &[LayerWeight], cos_o: f64, azimuth: f64) -> f64 {
    let theta = libm::acos(cos_o.clamp(1e-3, 1.0));
    at_level!(SimdLevel::best(), simd => sum(simd, shape, layers, theta, azimuth))
}

#[inline(always)]
fn sum<S: Simd>(simd: S, shape: &Shape, layers: &[LayerWeight], theta_o: f64, azimuth: f64) -> f64 {
    let splat = |value: f64| Lanes::splat(simd, value as f32);
    let vector = |v: Vec3<f64>| Vec3::new(splat(v.x), splat(v.y), splat(v.z));
    let below = shape.info().side == Side::Transmission;
    let theta_i = match below {
        true => libm::asin((libm::sin(theta_o) / shape.eta()).min(1.0)),
        false => theta_o,
    };
    let (sin, cos) = libm::sincos(theta_i);
    let (sin_a, cos_a) = libm::sincos(azimuth);
    let turned = |x: f64, y: f64, z: f64| Vec3::new(x * cos_a - y * sin_a, x * sin_a + y * cos_a, z);
    let wo = vector(turned(libm::sin(theta_o), 0.0, libm::cos(theta_o)));
    // An orthonormal frame around the mirrored, or straight, direction.
    let middle = vector(turned(-sin, 0.0, cos));
    let (up, side) = (vector(turned(cos, 0.0, sin)), vector(turned(0.0, 1.0, 0.0)));
    let zero = splat(0.0);
    let flip = if below { splat(-1.0) } else { splat(1.0) };
    let edge = |ring: usize| PI * libm::pow(ring as f64 / RINGS as f64, 3.0);
    let turns: Vec<([f32; 16], [f32; 16])> = (0..SPOKES / 16)
        .map(|row| {
            let turn = |i: usize| 2.0 * PI * ((16 * row + i) as f64 + 0.5) / SPOKES as f64;
            let part = |f: fn(f64) -> f64| core::array::from_fn(|i| f(turn(i)) as f32);
            (part(libm::cos), part(libm::sin))
        })
        .collect();
    let mut total = 0.0;
    for ring in 0..RINGS {
        let (low, high) = (edge(ring), edge(ring + 1));
        let weight = 2.0 * (libm::cos(low) - libm::cos(high)) * PI / SPOKES as f64;
        let (sin_r, cos_r) = libm::sincos(0.5 * (low + high));
        let mut values = zero;
        for (cos_t, sin_t) in &turns {
            let (cos_t, sin_t) = (Lanes::load(simd, cos_t), Lanes::load(simd, sin_t));
            let round = splat(sin_r);
            let wi = middle * splat(cos_r) + up * (round * cos_t) + side * (round * sin_t);
            let above = zero.lt(wi.z);
            let pair = DirectionPair::new(wo, Vec3::new(wi.x, wi.y, wi.z * flip));
            let mut value = shape.f_cos(&pair);
            for layer in layers {
                value = value * layer.factor(&pair);
            }
            values = values + value.select(above, zero);
        }
        let mut row = [0.0; 16];
        values.store(&mut row);
        total += weight * row.iter().map(|value| f64::from(*value)).sum::<f64>();
    }
    total
}
