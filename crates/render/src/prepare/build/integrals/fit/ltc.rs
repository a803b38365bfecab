//! Linearly transformed cosines, as the parts of a lobe.
//!
//! A linear map takes the clamped cosine lobe to one that looks like the given lobe; the inverse map takes a polygon along,
//! and the polygon's form factor is the integral. Source: E. Heitz, J. Dupuy, S. Hill and D. Neubelt, "Real-Time
//! Polygonal-Light Shading with Linearly Transformed Cosines", SIGGRAPH 2016. Here several are added; `tests/lighting` states
//! the error. Maps of lobes with a grain need not be symmetric, but nothing asks for them: between views they go over into each
//! other badly.

use glanz_math::simd::Simd;
use glanz_math::{Lanes, PI, Real, SimdLevel, Vec3, at_level};

use super::points::{Points, ROWS, Row, product, sum};
use super::scale::Scale;
use super::solve::{Problem, System, added};
use crate::prepare::data::LtcComponent;

/// Entries of a map, and those of one that is the same on both sides of the plane of view.
const ENTRIES: usize = 9;
const SYMMETRIC: [bool; ENTRIES] = [true, false, true, false, true, false, true, false, true];

/// The fit of one view. The unknowns of each component are the entries of its inverse map, and its amount.
pub(super) struct LtcFit<'a> {
    points: &'a Points,
    count: usize,
    /// The directions of points in the frame of the mirrored direction.
    directions: [Vec<Row>; 3],
    /// The weights; 0 below the horizon, where polygons are cut.
    weights: Vec<Row>,
    /// The solid angles over the weights.
    solid: Vec<Row>,
    /// The entries that are unknown.
    entries: Vec<usize>,
    system: System,
}

impl<'a> LtcFit<'a> {
    pub(super) fn new(points: &'a Points, scale: &Scale, count: usize, is_anisotropic: bool) -> Self {
        let frame = scale.mirrored_frame(points.wo);
        let turned = frame.map(|axis| rotated(points, axis));
        let above =
            |weight: &Row, z: &Row| core::array::from_fn(|i| if z[i] > 0.0 { weight[i] } else { 0.0 });
        let weights: Vec<Row> =
            points.weights.iter().zip(&points.directions[2]).map(|(w, z)| above(w, z)).collect();
        let ratio = |solid: &Row, weight: &Row| {
            core::array::from_fn(|i| if weight[i] > 0.0 { solid[i] / weight[i] } else { 0.0 })
        };
        let solid = points.solid.iter().zip(&weights).map(|(s, w)| ratio(s, w)).collect();
        let entries: Vec<usize> = (0..ENTRIES).filter(|i| is_anisotropic || SYMMETRIC[*i]).collect();
        let system = System::new(points, count * (entries.len() + 1));
        Self { points, count, directions: turned, weights, solid, entries, system }
    }

    fn per_component(&self) -> usize {
        self.entries.len() + 1
    }

    /// The inverse map of a component, and its amount.
    fn component(&self, x: &[f64], number: usize) -> ([f64; ENTRIES], f64) {
        let own = &x[number * self.per_component()..(number + 1) * self.per_component()];
        let mut map = [0.0; ENTRIES];
        for (entry, value) in self.entries.iter().zip(own) {
            map[*entry] = *value;
        }
        (map, own[self.entries.len()])
    }

    /// What is kept of a solution.
    pub(super) fn components(&self, x: &[f64]) -> Vec<LtcComponent> {
        let component = |number: usize| {
            let (map, amount) = self.component(x, number);
            let scale = third_row(&map);
            LtcComponent { inverse: map.map(|entry| (entry / scale) as f32), amount: amount as f32 }
        };
        (0..self.count).map(component).collect()
    }

    #[inline(always)]
    fn evaluate_with<S: Simd>(&mut self, simd: S, x: &[f64]) -> f64 {
        let splat = |value: f64| Lanes::splat(simd, value as f32);
        let (zero, one, four) = (splat(0.0), splat(1.0), splat(4.0));
        for row in &mut self.system.residual {
            *row = [0.0; 16];
        }
        let per = self.per_component();
        for number in 0..self.count {
            let (map, amount) = self.component(x, number);
            let cofactors = cofactors(&map);
            let determinant = map[0] * cofactors[0] + map[1] * cofactors[1] + map[2] * cofactors[2];
            let lost = cofactors.map(|c| splat(c / determinant));
            let (scale, amount) = (splat(determinant.abs() / PI), splat(amount));
            let mut rows = [zero; ENTRIES];
            for (row, entry) in rows.iter_mut().zip(map) {
                *row = splat(entry);
            }
            for k in 0..ROWS {
                let [x, y, z] = &self.directions;
                let d = [Lanes::load(simd, &x[k]), Lanes::load(simd, &y[k]), Lanes::load(simd, &z[k])];
                let w0 = rows[0] * d[0] + rows[1] * d[1] + rows[2] * d[2];
                let w1 = rows[3] * d[0] + rows[4] * d[1] + rows[5] * d[2];
                let w2 = rows[6] * d[0] + rows[7] * d[1] + rows[8] * d[2];
                let up = w2.max(zero);
                let squared = w0 * w0 + w1 * w1 + w2 * w2;
                let inverse = one / squared.max(splat(1e-30));
                let weight = Lanes::load(simd, &self.weights[k]);
                let scaled = scale * inverse * inverse * weight;
                let value = up * scaled;
                let pull = zero - value * inverse * four;
                let lift = one.select(zero.lt(w2), zero) * scaled;
                let slopes = [w0 * pull, w1 * pull, w2 * pull + lift];
                for (column, entry) in self.entries.iter().enumerate() {
                    let slope = slopes[entry / 3] * d[entry % 3] + value * lost[*entry];
                    (slope * amount).store(&mut self.system.columns[number * per + column][k]);
                }
                value.store(&mut self.system.columns[number * per + per - 1][k]);
                (Lanes::load(simd, &self.system.residual[k]) + value * amount)
                    .store(&mut self.system.residual[k]);
            }
        }
        let mut total = zero;
        for k in 0..ROWS {
            let lobe = Lanes::load(simd, &self.weights[k]) * Lanes::load(simd, &self.points.values[k]);
            let off = Lanes::load(simd, &self.system.residual[k]) - lobe;
            off.store(&mut self.system.residual[k]);
            total = total + off * off;
        }
        added(total)
    }
}

impl Problem for LtcFit<'_> {
    fn system(&self) -> &System {
        &self.system
    }

    fn evaluate(&mut self, x: &[f64]) -> f64 {
        at_level!(SimdLevel::best(), simd => self.evaluate_with(simd, x))
    }

    /// Maps times a factor are the same lobe.
    fn bound(&self, x: &mut [f64]) {
        let entries = self.entries.len();
        for own in x.chunks_mut(self.per_component()) {
            let mut map = [0.0; ENTRIES];
            for (entry, value) in self.entries.iter().zip(own.iter()) {
                map[*entry] = *value;
            }
            let scale = third_row(&map);
            own[..entries].iter_mut().for_each(|value| *value /= scale);
            own[entries] = own[entries].clamp(-2.0, 3.0);
        }
    }

    fn scales(&self, x: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut scales = Vec::with_capacity(x.len());
        for own in x.chunks(self.per_component()) {
            let mut size = [0.0f64; 3];
            for (entry, value) in self.entries.iter().zip(own) {
                size[entry / 3] += value * value;
            }
            scales.extend(self.entries.iter().map(|entry| libm::sqrt(size[entry / 3]).max(0.1)));
            scales.push(1.0);
        }
        let most = scales.iter().map(|scale| 0.5 * scale).collect();
        (scales, most)
    }

    fn excess(&self, _: &[f64]) -> (f64, Vec<f64>) {
        let off: f64 = sum(&self.solid, &self.system.residual);
        let rates = self.system.columns.iter().map(|column| sum(&self.solid, column));
        (off, rates.collect())
    }

    /// Cosines of the lobe's own spread about its mean direction, some narrower and some wider.
    fn guesses(&self) -> Vec<Vec<f64>> {
        let [x, y, z] = &self.directions;
        let mass: Vec<Row> =
            self.points.solid.iter().zip(&self.points.values).map(|(s, v)| product(s, v)).collect();
        let middle = Vec3::new(sum(&mass, x), sum(&mass, y), sum(&mass, z));
        let middle = if middle.dot(middle) > 1e-12 { middle.normalized() } else { Vec3::new(0.0, 0.0, 1.0) };
        let up = Vec3::new(1.0, 0.0, 0.0) - middle * middle.x;
        let up = if up.dot(up) > 1e-6 { up.normalized() } else { Vec3::new(0.0, 0.0, 1.0) };
        let across = middle.cross(up);
        let slopes = |axis: Vec3<f64>| {
            let mut total = 0.0;
            let all = x.as_flattened().iter().zip(y.as_flattened()).zip(z.as_flattened());
            for (((x, y), z), mass) in all.zip(mass.as_flattened()) {
                let d = Vec3::new(f64::from(*x), f64::from(*y), f64::from(*z));
                let (along, forward) = (d.dot(axis), d.dot(middle));
                total += f64::from(*mass) * along * along / (along * along + forward * forward).max(1e-12);
            }
            // The cosine lobe itself has mean squares of a quarter.
            libm::sqrt((total / (0.5 - total).max(0.05)).max(1e-9))
        };
        let (along, side) = (slopes(up), slopes(across));
        let of = |parts: &[(f64, f64)]| {
            let component = |(factor, amount): &(f64, f64)| {
                let rows = [up * (1.0 / (along * factor)), across * (1.0 / (side * factor)), middle];
                let map = rows.map(|row| [row.x, row.y, row.z]);
                let map = map.as_flattened().to_vec();
                let own: Vec<f64> = self.entries.iter().map(|entry| map[*entry]).collect();
                own.into_iter().chain([*amount]).collect::<Vec<f64>>()
            };
            parts.iter().flat_map(component).collect::<Vec<f64>>()
        };
        match self.count {
            1 => vec![of(&[(1.0, 1.0)])],
            2 => vec![
                of(&[(0.7, 0.6), (1.5, 0.4)]),
                of(&[(0.4, 0.5), (1.0, 0.5)]),
                // The tails of both cancel each other.
                of(&[(1.2, 1.5), (2.08, -0.5)]),
            ],
            _ => vec![
                of(&[(0.4, 0.3), (0.8, 0.4), (1.5, 0.3)]),
                of(&[(0.6, 0.4), (1.4, 1.0), (2.4, -0.4)]),
                of(&[(1.4, 2.6), (2.0, -2.1), (2.6, 0.5)]),
            ],
        }
    }
}

/// The length of the third row, by which a map is scaled.
fn third_row(map: &[f64; ENTRIES]) -> f64 {
    libm::sqrt(map[6] * map[6] + map[7] * map[7] + map[8] * map[8]).max(1e-12)
}

/// The cofactors of a matrix: its determinant's derivatives.
fn cofactors(m: &[f64; ENTRIES]) -> [f64; ENTRIES] {
    [
        m[4] * m[8] - m[5] * m[7],
        m[5] * m[6] - m[3] * m[8],
        m[3] * m[7] - m[4] * m[6],
        m[2] * m[7] - m[1] * m[8],
        m[0] * m[8] - m[2] * m[6],
        m[1] * m[6] - m[0] * m[7],
        m[1] * m[5] - m[2] * m[4],
        m[2] * m[3] - m[0] * m[5],
        m[0] * m[4] - m[1] * m[3],
    ]
}

/// The points' coordinates along an axis.
fn rotated(points: &Points, axis: Vec3<f64>) -> Vec<Row> {
    let [x, y, z] = &points.directions;
    let axis = [axis.x, axis.y, axis.z].map(|value| value as f32);
    let row = |k: usize| core::array::from_fn(|i| x[k][i] * axis[0] + y[k][i] * axis[1] + z[k][i] * axis[2]);
    (0..ROWS).map(row).collect()
}
