//! Lookups in the chain of an environment, as the parts of a lobe.

use glanz_math::simd::Simd;
use glanz_math::{Lanes, PI, Real, SimdLevel, Vec3, at_level};

use super::guess;
use super::points::{Points, ROWS, Row};
use super::scale::{Form, Scale};
use super::solve::{Problem, System, added};
use crate::prepare::data::{EnvironmentChain, Lookup};

/// The least amount of a lookup.
const LEAST: f64 = 1e-5;

/// The most of a lobe that is the cosine: the lookups beside it must have something to hold on to.
const MOST_COSINE: f64 = 0.7;

/// The kernel of a place: 1 / R², and the inverse of its integral.
#[derive(Clone, Copy)]
struct Kernel {
    inverse: f32,
    height: f32,
}

/// The fit of one view. The unknowns are all slopes along x, along y (of half vectors, or of directions about the lobe's
/// middle), places, amounts, and the amount of the clamped cosine of lobes that take one.
pub(super) struct LookupFit<'a> {
    points: &'a Points,
    scale: &'a Scale,
    count: usize,
    kernels: Vec<Kernel>,
    system: System,
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

impl<'a> LookupFit<'a> {
    pub(super) fn new(points: &'a Points, scale: &'a Scale, count: usize) -> Self {
        let width = match scale.form {
            Form::Half if scale.slope < 0.8 => 0.5 * scale.axes[0].min(scale.axes[1]) * points.wo.z.max(0.15),
            _ => 0.05 * scale.slope,
        };
        let least = 2.0 * libm::log2(width / EnvironmentChain::NARROWEST);
        Self {
            points,
            scale,
            count,
            kernels: (0..=EnvironmentChain::LAST).map(kernel).collect(),
            system: System::new(points, 4 * count + usize::from(scale.takes_cosine)),
            least: least.clamp(0.001, EnvironmentChain::LAST as f64 - 2.0),
        }
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
    fn evaluate_with<S: Simd>(&mut self, simd: S, x: &[f64]) -> f64 {
        let n = self.count;
        let splat = |value: f64| Lanes::splat(simd, value as f32);
        let vector = |v: Vec3<f64>| [splat(v.x), splat(v.y), splat(v.z)];
        let zero = Lanes::splat(simd, 0.0);
        for row in &mut self.system.residual {
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
            let kernels =
                [low, high].map(|kernel| [kernel.inverse, kernel.height].map(|v| Lanes::splat(simd, v)));
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
                store(&mut self.system.columns[j][k], slope * towards(&along));
                store(&mut self.system.columns[n + j][k], slope * towards(&across));
                store(&mut self.system.columns[2 * n + j][k], (high - low) * steps * weight * amount);
                store(&mut self.system.columns[3 * n + j][k], value);
                let sum = Lanes::load(simd, &self.system.residual[k]) + value * amount;
                store(&mut self.system.residual[k], sum);
            }
        }
        if let Some(column) = self.system.columns.get_mut(4 * n) {
            let amount = splat(x[4 * n]);
            for k in 0..ROWS {
                let up = Lanes::load(simd, &pz[k]).max(zero) * splat(1.0 / PI);
                let value = up * Lanes::load(simd, &self.points.weights[k]);
                value.store(&mut column[k]);
                (Lanes::load(simd, &self.system.residual[k]) + value * amount)
                    .store(&mut self.system.residual[k]);
            }
        }
        let mut total = zero;
        for k in 0..ROWS {
            let weight = Lanes::load(simd, &self.points.weights[k]);
            let off = Lanes::load(simd, &self.system.residual[k])
                - weight * Lanes::load(simd, &self.points.values[k]);
            off.store(&mut self.system.residual[k]);
            total = total + off * off;
        }
        added(total)
    }
}

impl Problem for LookupFit<'_> {
    fn system(&self) -> &System {
        &self.system
    }

    fn evaluate(&mut self, x: &[f64]) -> f64 {
        at_level!(SimdLevel::best(), simd => self.evaluate_with(simd, x))
    }

    fn bound(&self, x: &mut [f64]) {
        let (places, amounts) = x[2 * self.count..].split_at_mut(self.count);
        for place in places {
            *place = place.clamp(self.least, EnvironmentChain::LAST as f64 - 1e-3);
        }
        for amount in amounts {
            *amount = amount.max(LEAST);
        }
        if let Some(cosine) = x.get_mut(4 * self.count) {
            *cosine = cosine.min(MOST_COSINE);
        }
    }

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

    fn excess(&self, x: &[f64]) -> (f64, Vec<f64>) {
        let rates = (0..x.len()).map(|i| if i < 3 * self.count { 0.0 } else { 1.0 }).collect();
        (x[3 * self.count..].iter().sum::<f64>() - 1.0, rates)
    }

    fn guesses(&self) -> Vec<Vec<f64>> {
        guess::guesses(self.points, self.scale, self.count)
    }
}

impl LookupFit<'_> {
    /// The lookups with amounts of sum 1 and directions in the frame of the mirrored direction; and the cosine's amount.
    pub(super) fn normalized(&self, x: &[f64]) -> (Vec<Lookup>, Option<f32>) {
        let n = self.count;
        let total: f64 = x[3 * n..].iter().sum();
        let [up, across, middle] = self.scale.mirrored_frame(self.points.wo);
        let lookup = |j: usize| {
            let [d, ..] = self.direction([x[j], x[n + j]]);
            Lookup {
                direction: [d.dot(up), d.dot(across), d.dot(middle)].map(|value| value as f32),
                place: x[2 * n + j] as f32,
                amount: (x[3 * n + j] / total) as f32,
            }
        };
        ((0..n).map(lookup).collect(), x.get(4 * n).map(|amount| (amount / total) as f32))
    }
}
