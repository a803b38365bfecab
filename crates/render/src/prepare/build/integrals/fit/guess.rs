//! Where a fit begins that has no neighbour.

use glanz_math::{PI, Vec3};

use super::lookups::place_of;
use super::points::Points;
use super::scale::{Form, Scale};

/// A guess: of each lookup the angle from the normal against the viewer, the one out of that plane, and the standard
/// deviation.
type Guess = Vec<[f64; 3]>;

/// The mass of a point, and where it is.
struct Mass {
    psi: f64,
    beta: f64,
    mass: f64,
    direction: Vec3<f64>,
}

/// Equal parts of the lobe along its longest axis, the same narrower and to both sides of it, and rings about the middle.
pub(super) fn guesses(points: &Points, scale: &Scale, count: usize) -> Vec<Vec<f64>> {
    let masses = masses(points);
    if masses.is_empty() {
        // Where nothing is reflected, anything stands for it.
        let middle = vec![[0.0, 0.0, 0.5]; count];
        return vec![solution(points, scale, &middle)];
    }
    let along = along(&masses, count, scale.grain() == 1.0);
    let beside: Guess =
        along.1.iter().map(|[psi, beta, width]| [*psi, *beta, width * libm::exp2(-0.35)]).collect();
    let beside =
        beside.into_iter().zip(&along.0).map(|(g, offset)| [g[0], g[1] + 2.0 * offset, g[2]]).collect();
    let all = [along.1, beside, rings(&masses, count)];
    all.into_iter().map(|guess| solution(points, scale, &guess)).collect()
}

fn masses(points: &Points) -> Vec<Mass> {
    let [x, y, z] = &points.directions;
    let (x, y, z) = (x.as_flattened(), y.as_flattened(), z.as_flattened());
    let (solid, values) = (points.solid.as_flattened(), points.values.as_flattened());
    let mass = |i: usize| {
        let direction = Vec3::new(f64::from(x[i]), f64::from(y[i]), f64::from(z[i]));
        Mass {
            psi: libm::atan2(-direction.x, direction.z),
            beta: libm::asin(direction.y.clamp(-1.0, 1.0)),
            mass: f64::from(solid[i]) * f64::from(values[i]),
            direction,
        }
    };
    (0..x.len()).map(mass).filter(|mass| mass.mass > 0.0).collect()
}

/// The value below which a fraction of the mass is.
fn quantile(masses: &[Mass], fraction: f64, value: impl Fn(&Mass) -> f64) -> f64 {
    let mut sorted: Vec<(f64, f64)> = masses.iter().map(|mass| (value(mass), mass.mass)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = sorted.iter().map(|(_, mass)| mass).sum();
    let (mut sum, mut before) = (0.0, None);
    for (value, mass) in &sorted {
        let after = sum + mass;
        if after >= fraction * total {
            let Some(before) = before else { return *value };
            let t = (fraction * total - sum) / mass;
            return before + (value - before) * t;
        }
        (sum, before) = (after, Some(*value));
    }
    before.unwrap_or(0.0)
}

/// Lookups at equal parts of the mass along the longest axis; with how far each is moved to its side.
fn along(masses: &[Mass], count: usize, is_round: bool) -> (Vec<f64>, Guess) {
    let psi = quantile(masses, 0.5, |m| m.psi);
    let (beta, axis) = if is_round { (0.0, (1.0, 0.0)) } else { longest(masses, psi) };
    let (ax, ay) = axis;
    let u = |m: &Mass| (m.psi - psi) * ax + (m.beta - beta) * ay;
    let across = quantile(masses, 0.5, |m| ((m.beta - beta) * ax - (m.psi - psi) * ay).abs()) / 0.67;
    let (mut offsets, mut guess) = (Vec::new(), Vec::new());
    for j in 0..count {
        let at = |q: f64| quantile(masses, (q / count as f64).clamp(0.02, 0.98), u);
        let x = at(j as f64 + 0.5);
        let width = (0.5 * (at(j as f64 + 1.0) - at(j as f64))).max(0.9 * across).clamp(2e-3, 0.7);
        let offset = 0.35 * across * if j % 2 == 1 { 1.0 } else { -1.0 };
        offsets.push(offset);
        guess.push([psi + ax * x, beta + ay * x + offset, width]);
    }
    (offsets, guess)
}

/// The middle out of the plane of view, and the axis along which a lobe is longest.
fn longest(masses: &[Mass], psi: f64) -> (f64, (f64, f64)) {
    let beta = quantile(masses, 0.5, |m| m.beta);
    let offset = |m: &Mass| (m.psi - psi, m.beta - beta);
    let near = 2.0 * quantile(masses, 0.6, |m| libm::hypot(offset(m).0, offset(m).1));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for m in masses {
        let (x, y) = offset(m);
        if libm::hypot(x, y) < near {
            xx += m.mass * x * x;
            xy += m.mass * x * y;
            yy += m.mass * y * y;
        }
    }
    let turn = 0.5 * libm::atan2(2.0 * xy, xx - yy);
    let (sin, cos) = libm::sincos(turn);
    (beta, (cos, sin))
}

/// Lookups about the middle, as wide as parts of the mass are away from it.
fn rings(masses: &[Mass], count: usize) -> Guess {
    let sum = masses.iter().fold(Vec3::new(0.0, 0.0, 0.0), |sum, m| sum + m.direction * m.mass);
    let middle = if sum.dot(sum) > 1e-20 { sum.normalized() } else { Vec3::new(0.0, 0.0, 1.0) };
    let psi = libm::atan2(-middle.x, middle.z);
    let beta = libm::asin(middle.y.clamp(-1.0, 1.0));
    let ring = |j: usize| {
        let part = (j as f64 + 0.5) / count as f64 * 0.93 + 0.02;
        let distance = quantile(masses, part, |m| libm::acos(m.direction.dot(middle).clamp(-1.0, 1.0)));
        let width = (distance / 1.3).clamp(2e-3, 0.75);
        let (sin, cos) = libm::sincos(2.4 * j as f64);
        [psi + 0.3 * width * cos, beta + 0.3 * width * sin, width]
    };
    (0..count).map(ring).collect()
}

/// The unknowns of a guess.
fn solution(points: &Points, scale: &Scale, guess: &Guess) -> Vec<f64> {
    let amount = 1.0 / guess.len() as f64;
    let lookup = |[psi, beta, width]: &[f64; 3]| {
        let (sin, cos) = libm::sincos(*psi);
        let (sin_b, cos_b) = libm::sincos(beta.clamp(-0.5 * PI, 0.5 * PI));
        let direction = Vec3::new(-sin * cos_b, sin_b, cos * cos_b);
        let slopes = match scale.form {
            Form::Half => {
                let half = (direction + points.wo).normalized();
                let up = half.z.abs().max(0.05) * if half.z < 0.0 { -1.0 } else { 1.0 };
                [half.x / up, half.y / up]
            }
            _ => {
                let [x, y, z] = points.axes;
                let up = direction.dot(z).max(0.2);
                [direction.dot(x) / up, direction.dot(y) / up]
            }
        };
        [slopes[0], slopes[1], place_of(*width), amount]
    };
    let lookups: Vec<[f64; 4]> = guess.iter().map(lookup).collect();
    let unknowns = (0..4).flat_map(|i| lookups.iter().map(move |lookup| lookup[i]));
    unknowns.chain(scale.takes_cosine.then_some(0.0)).collect()
}
