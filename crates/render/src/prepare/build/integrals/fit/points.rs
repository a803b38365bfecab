//! A lobe at points that crowd where it is.

use std::sync::LazyLock;

use glanz_bsdf::{DirectionPair, Shape, Side};
use glanz_math::simd::Simd;
use glanz_math::{GaussLegendre, Lanes, PI, Real, SimdLevel, Vec3, at_level};

use super::scale::{Form, Scale};

/// Points from the middle outwards, and around: a whole number of rows of 16.
const OUT: usize = 24;
const AROUND: usize = 28;
pub(super) const ROWS: usize = OUT * AROUND / 16;

/// Where points are on the way out.
static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(OUT));

/// A row of 16 points.
pub(super) type Row = [f32; 16];

/// A lobe at points.
pub(super) struct Points {
    pub wo: Vec3<f64>,
    /// The frame of directions that are not about half vectors: its z axis is the middle.
    pub axes: [Vec3<f64>; 3],
    /// Unit vectors; of light that passes, mirrored up.
    pub directions: [Vec<Row>; 3],
    /// The square root of what a difference at a point counts.
    pub weights: Vec<Row>,
    /// The solid angle of each.
    pub solid: Vec<Row>,
    /// The lobe over its integral.
    pub values: Vec<Row>,
}

impl Points {
    pub(super) fn of(shape: &Shape, scale: &Scale, wo: Vec3<f64>) -> Self {
        let axes = axes(middle(scale, wo));
        let (mut directions, mut solid, mut weights) = (Vec::new(), Vec::new(), Vec::new());
        place(scale, wo, &axes, |direction, own, spread| {
            directions.push(direction);
            solid.push(own as f32);
            weights.push(libm::sqrt(own * spread) as f32);
        });
        let rows = |values: &[f32]| -> Vec<Row> { values.as_chunks::<16>().0.to_vec() };
        let part =
            |f: fn(&Vec3<f64>) -> f64| rows(&directions.iter().map(|d| f(d) as f32).collect::<Vec<_>>());
        let directions = [part(|d| d.x), part(|d| d.y), part(|d| d.z)];
        let (solid, weights) = (rows(&solid), rows(&weights));
        let mut values = at_level!(SimdLevel::best(), simd => values(simd, shape, wo, &directions));
        let total: f64 = sum(&solid, &values);
        if total > 0.0 && total.is_finite() {
            values
                .as_flattened_mut()
                .iter_mut()
                .for_each(|value| *value = (f64::from(*value) / total) as f32);
        } else {
            values.as_flattened_mut().fill(0.0);
        }
        Self { wo, axes, directions, weights, solid, values }
    }
}

/// The products.
pub(super) fn product(a: &Row, b: &Row) -> Row {
    core::array::from_fn(|i| a[i] * b[i])
}

/// Σ of the products.
pub(super) fn sum(a: &[Row], b: &[Row]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
}

#[inline(always)]
fn values<S: Simd>(simd: S, shape: &Shape, wo: Vec3<f64>, [x, y, z]: &[Vec<Row>; 3]) -> Vec<Row> {
    let one = Lanes::splat(simd, 1.0);
    let zero = Lanes::splat(simd, 0.0);
    let splat = |value: f64| Lanes::splat(simd, value as f32);
    let wo = Vec3::new(splat(wo.x), splat(wo.y), splat(wo.z));
    let side = if shape.info().side == Side::Transmission { splat(-1.0) } else { one };
    let mut rows = Vec::with_capacity(ROWS);
    for ((x, y), z) in x.iter().zip(y).zip(z) {
        let up = Lanes::load(simd, z);
        let wi = Vec3::new(Lanes::load(simd, x), Lanes::load(simd, y), up * side);
        let value = shape.f_cos(&DirectionPair::new(wo, wi));
        let mut row = [0.0; 16];
        value.max(zero).select(zero.lt(up), zero).store(&mut row);
        rows.push(row);
    }
    rows
}

/// The middle of a lobe, on the viewer's side.
pub(super) fn middle(scale: &Scale, wo: Vec3<f64>) -> Vec3<f64> {
    match scale.form {
        Form::Half | Form::Mirrored => Vec3::new(-wo.x, -wo.y, wo.z),
        Form::Normal => Vec3::new(0.0, 0.0, 1.0),
        Form::Refracted => {
            let (x, y) = (-wo.x / scale.eta, -wo.y / scale.eta);
            let flat = x * x + y * y;
            match flat < 1.0 {
                true => Vec3::new(x, y, libm::sqrt(1.0 - flat)),
                false => Vec3::new(x, y, 1e-3).normalized(),
            }
        }
    }
}

/// A frame about a direction.
fn axes(z: Vec3<f64>) -> [Vec3<f64>; 3] {
    let x = Vec3::new(0.0, 1.0, 0.0).cross(z);
    let x = if x.dot(x) > 1e-12 { x.normalized() } else { Vec3::new(1.0, 0.0, 0.0) };
    [x, z.cross(x), z]
}

/// Gives each point: its direction, its solid angle, and the solid angle of the patch around it over that of a half
/// vector.
fn place(scale: &Scale, wo: Vec3<f64>, axes: &[Vec3<f64>; 3], mut give: impl FnMut(Vec3<f64>, f64, f64)) {
    let half = scale.form == Form::Half;
    let own = if half { scale.slope } else { 2.0 * scale.slope };
    let core = 0.7 * own;
    let most = if half { 0.5 * PI + libm::acos(wo.z.min(1.0)) } else { PI };
    let reach = libm::asinh(most / core);
    let stretch = scale.axes.map(|axis| axis / scale.slope);
    for (u, weight) in RULE.nodes.iter().zip(&RULE.weights).map(|(u, weight)| (0.5 + 0.5 * u, 0.5 * weight)) {
        let theta = core * libm::sinh(reach * u);
        let ring =
            libm::sin(theta) * core * reach * libm::cosh(reach * u) * weight * 2.0 * PI / AROUND as f64;
        for around in 0..AROUND {
            let (sin, cos) = libm::sincos((around as f64 + 0.5) / AROUND as f64 * 2.0 * PI);
            let round = libm::sin(theta);
            let d = Vec3::new(round * cos * stretch[0], round * sin * stretch[1], libm::cos(theta));
            let length = libm::sqrt(d.dot(d));
            let (d, mut jacobian) = (d * (1.0 / length), stretch[0] * stretch[1] / length.powi(3));
            let wi = match half {
                true => {
                    let cos_o = d.dot(wo);
                    jacobian *= 4.0 * cos_o.max(0.0);
                    d * (2.0 * cos_o) - wo
                }
                false => axes[0] * d.x + axes[1] * d.y + axes[2] * d.z,
            };
            let spread = jacobian * (0.25 * own * own + theta * theta);
            give(wi, (ring * jacobian).max(0.0), spread.max(0.0));
        }
    }
}
