//! Lobes as linearly transformed cosines, by which light from polygons has a closed form.
//!
//! A linear map takes the clamped cosine lobe to one that looks like the given lobe; the inverse map takes the
//! polygon along, and the polygon's form factor is the integral. Source: E. Heitz, J. Dupuy, S. Hill and
//! D. Neubelt, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", SIGGRAPH 2016. The maps
//! are fitted here, for the lobes of the scene, when it is prepared; `tests/lighting` states the error.

use glanz_bsdf::{DirectionPair, LayerWeight, Shape, Side};
use glanz_math::{PI, Vec3};

use super::simplex;
use crate::prepare::data::ltc::{ANGLES, LtcTable};

/// A grid around the middle of the lobe: rings, ever wider, and points on half of each.
#[derive(Clone, Copy)]
struct PolarGrid {
    rings: usize,
    spokes: usize,
}

/// For fitting, which looks at each point a hundred times.
const COARSE: PolarGrid = PolarGrid { rings: 96, spokes: 16 };

/// For integrals of the lobe itself: within 1e-3 for the narrowest.
const FINE: PolarGrid = PolarGrid { rings: 240, spokes: 24 };

/// The least cosine of a view that is fitted; below, the last map is kept.
const GRAZING: f64 = 0.02;

/// A point of the lobe.
struct LobeSample {
    direction: Vec3<f64>,
    /// Its fraction of the integral.
    weight: f64,
    value: f64,
    pair: DirectionPair<f64>,
}

/// Fits the maps of a shape; of one on the other side, mirrored to the viewer's side.
pub(crate) fn fit_table(shape: &Shape) -> LtcTable {
    LtcTable { inverses: crate::parallel::collect(ANGLES, |i| fit(shape, cosine(i))) }
}

fn cosine(i: usize) -> f64 {
    let t = i as f64 / (ANGLES - 1) as f64;
    1.0 - t * t
}

/// The inverse map for a view angle.
fn fit(shape: &Shape, cos_o: f64) -> [f32; 5] {
    let theta = libm::acos(cos_o.max(GRAZING));
    let points = points(shape, theta, COARSE);
    let total: f64 = points.iter().map(|p| p.weight * p.value).sum();
    if total <= 0.0 {
        return [1.0, 0.0, 1.0, 0.0, 1.0];
    }
    let middle = middle(&points);
    let start = spread(&points, middle, total);
    let error = |p: &[f64; 3]| {
        let lobe = FittedLobe::new(middle, p);
        points
            .iter()
            .map(|point| {
                let difference = point.value / total - lobe.density(point.direction);
                // Weighted with the lobe's own size, so that narrow peaks do not count alone.
                point.weight * difference * difference
            })
            .sum::<f64>()
    };
    let best = simplex::minimum(error, start, [0.15, 0.15, 0.05]);
    FittedLobe::new(middle, &best).inverse.map(|value| value as f32)
}

/// The lobe at points around its middle, in the half space of positive y.
fn points(shape: &Shape, theta_o: f64, grid: PolarGrid) -> Vec<LobeSample> {
    let wo = Vec3::from_angles(theta_o, 0.0);
    let below = shape.info().side == Side::Transmission;
    let theta_i = match below {
        true => libm::asin((libm::sin(theta_o) / shape.eta()).min(1.0)),
        false => theta_o,
    };
    let (sin, cos) = libm::sincos(theta_i);
    // An orthonormal frame around the mirrored, or straight, direction.
    let (middle, side) = (Vec3::new(-sin, 0.0, cos), Vec3::new(cos, 0.0, sin));
    let edge = |ring: usize| PI * libm::pow(ring as f64 / grid.rings as f64, 3.0);
    let mut points = Vec::new();
    for ring in 0..grid.rings {
        let (low, high) = (edge(ring), edge(ring + 1));
        let weight = 2.0 * (libm::cos(low) - libm::cos(high)) * PI / grid.spokes as f64;
        for spoke in 0..grid.spokes {
            let (sin_a, cos_a) = libm::sincos(0.5 * (low + high));
            let (sin_p, cos_p) = libm::sincos(PI * (spoke as f64 + 0.5) / grid.spokes as f64);
            let wi = middle * cos_a + side * (sin_a * cos_p) + Vec3::new(0.0, sin_a * sin_p, 0.0);
            if wi.z > 0.0 {
                let light = if below { Vec3::new(wi.x, wi.y, -wi.z) } else { wi };
                let pair = DirectionPair::new(wo, light);
                let value = shape.f_cos(&pair);
                points.push(LobeSample { direction: wi, weight, value, pair });
            }
        }
    }
    points
}

/// The albedo of a lobe under layers for a viewer at an angle of this cosine. [`glanz_bsdf::layered_albedo`] is more
/// exact and takes a hundred times as long.
pub(crate) fn albedo(shape: &Shape, layers: &[LayerWeight], cos_o: f64) -> f64 {
    let theta = libm::acos(cos_o.clamp(1e-3, 1.0));
    let layer = |pair: &DirectionPair<f64>| layers.iter().map(|layer| layer.factor(pair)).product::<f64>();
    points(shape, theta, FINE).iter().map(|p| p.weight * p.value * layer(&p.pair)).sum()
}

/// The mean direction of a lobe for a viewer at an angle of this cosine, on the side of the lobe's light and away
/// from the viewer: the sine of its angle from the normal over the viewer's, and its cosine. 1 and `cos_o` are the
/// mirrored direction.
pub(crate) fn mean_direction(shape: &Shape, cos_o: f64) -> [f64; 2] {
    let theta = libm::acos(cos_o.clamp(GRAZING, 0.9999));
    let [sin, cos] = middle(&points(shape, theta, COARSE));
    [-sin / libm::sin(theta), cos]
}

/// The mean direction, as sine and cosine of its angle from the normal towards +x.
fn middle(points: &[LobeSample]) -> [f64; 2] {
    let (mut x, mut z) = (0.0, 0.0);
    for point in points {
        x += point.weight * point.value * point.direction.x;
        z += point.weight * point.value * point.direction.z;
    }
    let length = libm::sqrt(x * x + z * z);
    if length > 0.0 { [x / length, z / length] } else { [0.0, 1.0] }
}

/// A first guess: the logarithms of the widths in and across the plane, from the mean squares of the slopes.
fn spread(points: &[LobeSample], [sin, cos]: [f64; 2], total: f64) -> [f64; 3] {
    let (mut across, mut along) = (0.0, 0.0);
    for LobeSample { direction: d, weight, value, .. } in points {
        let (x, z) = (d.x * cos - d.z * sin, d.x * sin + d.z * cos);
        let fraction = weight * value / total;
        // The cosine lobe itself has mean squares of a quarter.
        along += fraction * x * x / (z * z + x * x);
        across += fraction * d.y * d.y / (z * z + d.y * d.y);
    }
    let width = |mean: f64| 0.5 * libm::log((mean / (0.5 - mean).max(0.05)).max(1e-9));
    [width(along), width(across), 0.0]
}

/// A transformed cosine.
struct FittedLobe {
    inverse: [f64; 5],
    determinant: f64,
}

impl FittedLobe {
    /// Of widths e^p0 and e^p1 and a skew p2, about a middle.
    fn new([sin, cos]: [f64; 2], p: &[f64; 3]) -> Self {
        let (x, y, skew) = (libm::exp(p[0]), libm::exp(p[1]), p[2]);
        // The map is R · [[x, 0, skew], [0, y, 0], [0, 0, 1]], R turning z to the middle.
        // Its inverse: first R back, then the inverse of the upper triangle.
        let inverse = [(cos - skew * sin) / x, (-sin - skew * cos) / x, 1.0 / y, sin, cos];
        Self { inverse, determinant: 1.0 / (x * y) }
    }

    /// Its density in 1/sr, of integral 1.
    fn density(&self, d: Vec3<f64>) -> f64 {
        let [a, b, c, e, f] = self.inverse;
        let w = Vec3::new(a * d.x + b * d.z, c * d.y, e * d.x + f * d.z);
        let squared = w.dot(w);
        w.z.max(0.0) * self.determinant / (PI * squared * squared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cosine_is_fitted_by_itself() {
        let lambert = Shape::named("lambert", &[]).expect("lambert exists");
        let fitted = fit_table(&lambert);
        for cos_o in [1.0f32, 0.5, 0.1] {
            let [a, b, c, d, e] = fitted.at(cos_o);
            let scale = 1.0 / e;
            for (got, expected) in [(a, 1.0), (b, 0.0), (c, 1.0), (d, 0.0)] {
                assert!((got * scale - expected).abs() < 2e-3, "{cos_o}: {:?}", [a, b, c, d, e]);
            }
        }
    }

    /// ∫ |difference| of a lobe that is nearly a Gaussian, as Phong's is, and the nearest transformed cosine, whose
    /// tails are longer.
    const GAUSSIAN: f64 = 0.4;

    #[test]
    fn narrow_lobes_keep_their_density() {
        let shape = Shape::named("phong-normalized", &[("shininess", 200.0)]).expect("the model exists");
        for cos_o in [1.0, 0.7, 0.4] {
            let theta = libm::acos(cos_o);
            let points = points(&shape, theta, COARSE);
            let total: f64 = points.iter().map(|p| p.weight * p.value).sum();
            let map = fit_table(&shape).at(cos_o);
            let [x, _, y, ..] = map;
            let lobe = FittedLobe { inverse: map, determinant: x * y };
            let volume: f64 = points.iter().map(|p| p.weight * lobe.density(p.direction)).sum();
            let off: f64 = points
                .iter()
                .map(|p| p.weight * (p.value / total - lobe.density(p.direction) / volume).abs())
                .sum();
            assert!(off < GAUSSIAN, "{cos_o}: half of {off} is in the wrong place");
        }
    }
}
