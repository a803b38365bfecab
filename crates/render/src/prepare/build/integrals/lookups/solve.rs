//! Levenberg and Marquardt's method for the lookups of one view.

use glanz_math::simd::Simd;
use glanz_math::{Lanes, PI, Real, Vec3};

use super::points::{Points, ROWS, Row, sum};
use super::scale::{Form, Scale};
use crate::prepare::data::{EnvironmentChain, Lookup};

/// Steps from a neighbour's result, from a guess, and from the best of the guesses.
const STEPS: [usize; 3] = [8, 20, 25];

/// How much a result is held to the neighbour that it comes from.
const HELD: f64 = 0.006;

/// How much the sum of all amounts counts.
const WHOLE: f64 = 3.0;

/// The least amount of a lookup.
const LEAST: f64 = 1e-5;

/// A step that makes less than this fraction better is the last.
const GAIN: f64 = 2e-3;

/// The lookups of one view: slopes of half vectors, or of directions about the lobe's middle, place, amount.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub lookups: Vec<[f64; 4]>,
    /// The amount of the clamped cosine, of lobes that take one.
    pub cosine: Option<f64>,
}

/// The kernel of a place: 1 / R², and the inverse of its integral.
#[derive(Clone, Copy)]
struct Kernel {
    inverse: f32,
    height: f32,
}

/// The fit of one view.
pub(super) struct Fit<'a> {
    points: &'a Points,
    scale: &'a Scale,
    count: usize,
    kernels: Vec<Kernel>,
    /// Derivatives, by unknown: all slopes along x, along y, places, amounts, and the cosine's.
    columns: Vec<Vec<Row>>,
    residual: Vec<Row>,
    /// The square of the weighted lobe.
    whole: f64,
    /// The least place of a lookup.
    least: f64,
}

/// The place of a width in the chain.
pub(super) fn place_of(width: f64) -> f64 {
    let place = 2.0 * libm::log2(width / EnvironmentChain::NARROWEST);
    place.clamp(0.01, EnvironmentChain::LAST as f64 - 0.1)
}

fn kernel(place: usize) -> Kernel {
    let width = EnvironmentChain::width(place as f64);
    let squared = 10.0 * width * width;
    let least = (1.0 - 4.0 / squared).max(0.0);
    Kernel { inverse: (1.0 / squared) as f32, height: (4.0 / (PI * squared * (1.0 - least.powi(4)))) as f32 }
}

impl<'a> Fit<'a> {
    pub(super) fn new(points: &'a Points, scale: &'a Scale, count: usize) -> Self {
        let unknowns = 4 * count + usize::from(scale.takes_cosine);
        let width = match scale.form {
            Form::Half if scale.slope < 0.8 => 0.5 * scale.axes[0].min(scale.axes[1]) * points.wo.z.max(0.15),
            _ => 0.05 * scale.slope,
        };
        let least = 2.0 * libm::log2(width / EnvironmentChain::NARROWEST);
        let weighted: Vec<Row> = points.weights.iter().zip(&points.values).map(|(w, v)| product(w, v)).collect();
        Self {
            points,
            scale,
            count,
            kernels: (0..=EnvironmentChain::LAST).map(kernel).collect(),
            columns: vec![vec![[0.0; 16]; ROWS]; unknowns],
            residual: vec![[0.0; 16]; ROWS],
            whole: sum(&weighted, &weighted),
            least: least.clamp(0.001, EnvironmentChain::LAST as f64 - 2.0),
        }
    }

    /// From a neighbour's result.
    pub(super) fn from(&mut self, start: &Solution) -> Solution {
        self.solve(start, STEPS[0], HELD, 1e-3).0
    }

    /// From the best of guesses.
    pub(super) fn from_guesses(&mut self, guesses: Vec<Solution>) -> Solution {
        let tried = guesses.into_iter().map(|guess| self.solve(&guess, STEPS[1], 0.0, 1e-2));
        let best = tried.min_by(|a, b| a.1.total_cmp(&b.1));
        match best {
            Some((best, _)) => self.solve(&best, STEPS[2], 0.0, 1e-3).0,
            None => Solution {
                lookups: vec![[0.0, 0.0, self.least, 1.0 / self.count as f64]; self.count],
                cosine: self.scale.takes_cosine.then_some(0.0),
            },
        }
    }

    fn solve(&mut self, start: &Solution, steps: usize, held: f64, mut damping: f64) -> (Solution, f64) {
        let n = self.count;
        let mut x = self.unknowns(start);
        let first = x.clone();
        let (scales, most) = self.scales(&x);
        let norm = libm::sqrt(self.whole);
        let priors = |x: &[f64]| {
            let whole = WHOLE * norm * (x[3 * n..].iter().sum::<f64>() - 1.0);
            let held = x.iter().zip(&first).zip(&scales).map(|((x, first), scale)| {
                let off = held * norm * (x - first) / scale;
                off * off
            });
            whole * whole + held.sum::<f64>()
        };
        let mut cost = super::evaluate(self, &x) + priors(&x);
        for _ in 0..steps {
            let (mut products, mut slope) = super::products(self);
            let size = x.len();
            let whole = WHOLE * WHOLE * self.whole;
            let off = x[3 * n..].iter().sum::<f64>() - 1.0;
            for i in 0..size {
                if i >= 3 * n {
                    slope[i] += whole * off;
                    for j in 3 * n..size {
                        products[i * size + j] += whole;
                    }
                }
                let own = held * held * self.whole / (scales[i] * scales[i]);
                products[i * size + i] += own;
                slope[i] += own * (x[i] - first[i]);
            }
            let before = cost;
            let mut found = false;
            for _ in 0..4 {
                let Some(step) = solved(&products, &slope, damping) else { break };
                let mut next = x.clone();
                for ((next, step), most) in next.iter_mut().zip(step).zip(&most) {
                    *next -= step.clamp(-most, *most);
                }
                self.bound(&mut next);
                let own = super::evaluate(self, &next) + priors(&next);
                if own < cost {
                    (x, cost, found) = (next, own, true);
                    break;
                }
                damping = (6.0 * damping).max(1e-4);
            }
            if !found {
                break;
            }
            damping = (damping / 6.0).max(1e-6);
            if before - cost < GAIN * before {
                break;
            }
        }
        (self.solution(&x), cost)
    }

    fn unknowns(&self, start: &Solution) -> Vec<f64> {
        let mut x: Vec<f64> = (0..4).flat_map(|i| start.lookups.iter().map(move |lookup| lookup[i])).collect();
        x.extend(start.cosine);
        self.bound(&mut x);
        x
    }

    fn solution(&self, x: &[f64]) -> Solution {
        let n = self.count;
        let lookups = (0..n).map(|j| [x[j], x[n + j], x[2 * n + j], x[3 * n + j]]).collect();
        Solution { lookups, cosine: x.get(4 * n).copied() }
    }

    /// Keeps places and amounts where they make sense.
    fn bound(&self, x: &mut [f64]) {
        let (places, amounts) = x[2 * self.count..].split_at_mut(self.count);
        for place in places {
            *place = place.clamp(self.least, EnvironmentChain::LAST as f64 - 1e-3);
        }
        for amount in amounts {
            *amount = amount.max(LEAST);
        }
    }

    /// What counts as much of each unknown, and the most that one step changes it.
    fn scales(&self, x: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.count;
        let width = |j: usize| {
            let half = if self.scale.form == Form::Half { 0.5 } else { 1.0 };
            half * EnvironmentChain::width(x[2 * n + j])
        };
        let amount = 1.0 / n as f64;
        let scales = (0..2 * n).map(|i| width(i % n)).chain((0..n).map(|_| 2.0));
        let most = (0..2 * n).map(|i| 2.0 * width(i % n) + 0.02).chain((0..n).map(|_| 2.0));
        let rest = x.len() - 3 * n;
        (
            scales.chain((0..rest).map(|_| amount)).collect(),
            most.chain((0..rest).map(|_| 3.0 * amount)).collect(),
        )
    }

    /// The direction of a lookup by its slopes, and how it changes with both.
    fn direction(&self, [x, y]: [f64; 2]) -> [Vec3<f64>; 3] {
        let h = Vec3::new(x, y, 1.0);
        let units = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
        let squared = h.dot(h);
        if self.scale.form == Form::Half {
            let wo = self.points.wo;
            let cos_o = h.dot(wo);
            let slope = |unit: Vec3<f64>, slope: f64| {
                h * (2.0 * unit.dot(wo) / squared) + unit * (2.0 * cos_o / squared)
                    - h * (4.0 * cos_o * slope / (squared * squared))
            };
            return [h * (2.0 * cos_o / squared) - wo, slope(units[0], x), slope(units[1], y)];
        }
        let inverse = 1.0 / libm::sqrt(squared);
        let [a, b, c] = self.points.axes;
        let turned = |v: Vec3<f64>| a * v.x + b * v.y + c * v.z;
        let slope = |unit: Vec3<f64>, slope: f64| turned(unit * inverse - h * (slope * inverse.powi(3)));
        [turned(h * inverse), slope(units[0], x), slope(units[1], y)]
    }

    /// The sum of the squares of all weighted differences; leaves them and their derivatives.
    #[inline(always)]
    pub(super) fn evaluate<S: Simd>(&mut self, simd: S, x: &[f64]) -> f64 {
        let n = self.count;
        let splat = |value: f64| Lanes::splat(simd, value as f32);
        let vector = |v: Vec3<f64>| [splat(v.x), splat(v.y), splat(v.z)];
        let zero = Lanes::splat(simd, 0.0);
        for row in &mut self.residual {
            *row = [0.0; 16];
        }
        let [px, py, pz] = &self.points.directions;
        for j in 0..n {
            let [d, along, across] = self.direction([x[j], x[n + j]]).map(vector);
            let (place, amount) = (x[2 * n + j], splat(x[3 * n + j]));
            let ([low, high], t) = EnvironmentChain::between(place as f32, self.scale.wide);
            let steps = Lanes::splat(simd, 1.0 / (high - low) as f32);
            let t = Lanes::splat(simd, t);
            let [low, high] = [low, high].map(|place| self.kernels[place]);
            let kernels = [low, high].map(|kernel| [kernel.inverse, kernel.height].map(|v| Lanes::splat(simd, v)));
            let two = Lanes::splat(simd, 2.0);
            let three = Lanes::splat(simd, 3.0);
            for k in 0..ROWS {
                let w = [Lanes::load(simd, &px[k]), Lanes::load(simd, &py[k]), Lanes::load(simd, &pz[k])];
                let off = [w[0] - d[0], w[1] - d[1], w[2] - d[2]];
                let squared = off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
                let weight = Lanes::load(simd, &self.points.weights[k]);
                let [[a_inverse, a_height], [b_inverse, b_height]] = kernels;
                let a = (Lanes::splat(simd, 1.0) - squared * a_inverse).max(zero);
                let b = (Lanes::splat(simd, 1.0) - squared * b_inverse).max(zero);
                let (a2, b2) = (a * a * a_height, b * b * b_height);
                let (low, high) = (a2 * a, b2 * b);
                let value = low + (high - low) * t;
                let (a1, b1) = (a2 * a_inverse, b2 * b_inverse);
                let slope = (a1 + (b1 - a1) * t) * two * three * weight * amount;
                let value = value * weight;
                let store = |row: &mut Row, value: Lanes<S>| value.store(row);
                let towards = |v: &[Lanes<S>; 3]| w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
                store(&mut self.columns[j][k], slope * towards(&along));
                store(&mut self.columns[n + j][k], slope * towards(&across));
                store(&mut self.columns[2 * n + j][k], (high - low) * steps * weight * amount);
                store(&mut self.columns[3 * n + j][k], value);
                let sum = Lanes::load(simd, &self.residual[k]) + value * amount;
                store(&mut self.residual[k], sum);
            }
        }
        if let Some(column) = self.columns.get_mut(4 * n) {
            let amount = splat(x[4 * n]);
            for k in 0..ROWS {
                let up = Lanes::load(simd, &pz[k]).max(zero) * splat(1.0 / PI);
                let value = up * Lanes::load(simd, &self.points.weights[k]);
                value.store(&mut column[k]);
                (Lanes::load(simd, &self.residual[k]) + value * amount).store(&mut self.residual[k]);
            }
        }
        let mut total = zero;
        for k in 0..ROWS {
            let weight = Lanes::load(simd, &self.points.weights[k]);
            let off = Lanes::load(simd, &self.residual[k]) - weight * Lanes::load(simd, &self.points.values[k]);
            off.store(&mut self.residual[k]);
            total = total + off * off;
        }
        added(total)
    }

    /// The products of all pairs of derivatives, and of each with the differences.
    #[inline(always)]
    pub(super) fn products<S: Simd>(&self, simd: S) -> (Vec<f64>, Vec<f64>) {
        const BLOCK: usize = 4;
        let size = self.columns.len();
        let (mut products, mut slope) = (vec![0.0; size * size], vec![0.0; size]);
        for i in 0..size {
            let own = &self.columns[i];
            let mut sum = Lanes::splat(simd, 0.0);
            for (a, b) in own.iter().zip(&self.residual) {
                sum = sum + Lanes::load(simd, a) * Lanes::load(simd, b);
            }
            slope[i] = added(sum);
            for first in (0..=i).step_by(BLOCK) {
                let others: [&[Row]; BLOCK] =
                    [0, 1, 2, 3].map(|b: usize| self.columns[(first + b).min(i)].as_slice());
                let mut sums = [Lanes::splat(simd, 0.0); BLOCK];
                for k in 0..ROWS {
                    let own = Lanes::load(simd, &own[k]);
                    sums[0] = sums[0] + own * Lanes::load(simd, &others[0][k]);
                    sums[1] = sums[1] + own * Lanes::load(simd, &others[1][k]);
                    sums[2] = sums[2] + own * Lanes::load(simd, &others[2][k]);
                    sums[3] = sums[3] + own * Lanes::load(simd, &others[3][k]);
                }
                for (b, sum) in sums.into_iter().enumerate() {
                    let j = (first + b).min(i);
                    let sum = added(sum);
                    products[i * size + j] = sum;
                    products[j * size + i] = sum;
                }
            }
        }
        (products, slope)
    }
}

fn product(a: &Row, b: &Row) -> Row {
    core::array::from_fn(|i| a[i] * b[i])
}

/// The sum over the lanes.
#[inline(always)]
fn added<S: Simd>(lanes: Lanes<S>) -> f64 {
    let mut row = [0.0; 16];
    lanes.store(&mut row);
    let mut sum = 0.0;
    for value in row {
        sum += f64::from(value);
    }
    sum
}

/// The step of a damped system, by Cholesky's method; none where it has none.
fn solved(products: &[f64], slope: &[f64], damping: f64) -> Option<Vec<f64>> {
    let n = slope.len();
    let mut lower = products.to_vec();
    for i in 0..n {
        lower[i * n + i] += damping * products[i * n + i] + 1e-12;
    }
    for i in 0..n {
        for j in 0..=i {
            let (row_i, row_j) = (&lower[i * n..i * n + j], &lower[j * n..j * n + j]);
            let sum: f64 = lower[i * n + j] - row_i.iter().zip(row_j).map(|(a, b)| a * b).sum::<f64>();
            if i == j {
                if !(sum > 0.0 && sum.is_finite()) {
                    return None;
                }
                lower[i * n + i] = libm::sqrt(sum);
            } else {
                lower[i * n + j] = sum / lower[j * n + j];
            }
        }
    }
    let mut x = slope.to_vec();
    for i in 0..n {
        let known: f64 = (0..i).map(|j| lower[i * n + j] * x[j]).sum();
        x[i] = (x[i] - known) / lower[i * n + i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| lower[j * n + i] * x[j]).sum();
        x[i] = (x[i] - known) / lower[i * n + i];
    }
    Some(x)
}

impl Fit<'_> {
    /// The lookups with amounts of sum 1 and directions in the frame of the mirrored direction; and the cosine's amount.
    pub(super) fn normalized(&self, solution: &Solution) -> (Vec<Lookup>, Option<f32>) {
        let total: f64 =
            solution.lookups.iter().map(|lookup| lookup[3]).sum::<f64>() + solution.cosine.unwrap_or(0.0);
        let [up, across, middle] = mirrored_frame(self.scale, self.points.wo);
        let lookup = |&[x, y, place, amount]: &[f64; 4]| {
            let [d, ..] = self.direction([x, y]);
            Lookup {
                direction: [d.dot(up), d.dot(across), d.dot(middle)].map(|value| value as f32),
                place: place as f32,
                amount: (amount / total) as f32,
            }
        };
        (
            solution.lookups.iter().map(lookup).collect(),
            solution.cosine.map(|amount| (amount / total) as f32),
        )
    }
}

/// The frame that directions are kept in: see [`Lookup::direction`].
fn mirrored_frame(scale: &Scale, wo: Vec3<f64>) -> [Vec3<f64>; 3] {
    let sine = libm::hypot(wo.x, wo.y);
    let towards = match sine > 1e-9 {
        true => Vec3::new(wo.x / sine, wo.y / sine, 0.0),
        false => Vec3::new(1.0, 0.0, 0.0),
    };
    let (sin, cos) = match scale.form {
        Form::Refracted => {
            let sin = (sine / scale.eta).min(1.0);
            (sin, libm::sqrt(1.0 - sin * sin))
        }
        _ => (sine, wo.z),
    };
    let normal = Vec3::new(0.0, 0.0, 1.0);
    [towards * cos + normal * sin, Vec3::new(-towards.y, towards.x, 0.0), normal * cos - towards * sin]
}
