//! Levenberg and Marquardt's method, for the sum of the parts that stand for a lobe at one view.

use glanz_math::simd::Simd;
use glanz_math::{Lanes, SimdLevel, at_level};

use super::points::{Points, ROWS, Row, product, sum};

/// Steps from a neighbour's result, from a guess, and from the best of the guesses.
const STEPS: [usize; 3] = [8, 20, 25];

/// How much a result is held to the neighbour that it comes from.
const HELD: f64 = 0.006;

/// How much the sum of all parts counts.
const WHOLE: f64 = 3.0;

/// A step that makes less than this fraction better is the last.
const GAIN: f64 = 2e-3;

/// Derivatives and differences at all points.
pub(super) struct System {
    /// By unknown.
    pub columns: Vec<Vec<Row>>,
    pub residual: Vec<Row>,
    /// The square of the weighted lobe.
    pub whole: f64,
}

impl System {
    pub(super) fn new(points: &Points, unknowns: usize) -> Self {
        let weighted: Vec<Row> =
            points.weights.iter().zip(&points.values).map(|(w, v)| product(w, v)).collect();
        Self {
            columns: vec![vec![[0.0; 16]; ROWS]; unknowns],
            residual: vec![[0.0; 16]; ROWS],
            whole: sum(&weighted, &weighted),
        }
    }
}

/// Parts whose sum shall be a lobe.
pub(super) trait Problem {
    fn system(&self) -> &System;
    /// The sum of the squares of all weighted differences; leaves them and their derivatives.
    fn evaluate(&mut self, x: &[f64]) -> f64;
    /// Keeps unknowns where they make sense.
    fn bound(&self, x: &mut [f64]);
    /// What counts as much of each unknown, and the most that one step changes it.
    fn scales(&self, x: &[f64]) -> (Vec<f64>, Vec<f64>);
    /// The integral of the sum less 1, and its derivatives. After `evaluate`.
    fn excess(&self, x: &[f64]) -> (f64, Vec<f64>);
    /// Where to begin without a neighbour.
    fn guesses(&self) -> Vec<Vec<f64>>;
}

/// The unknowns of all views. Each begins with its neighbour's, so that they go over into each other: from the flattest
/// view, and from the steepest; what leaves less, half-way between the views too, is taken. `before` are those of a
/// neighbouring azimuth. Gives the mean of what is left, in parts of the lobe, both squared.
pub(super) fn views<P: Problem>(
    nodes: &mut [P],
    between: &mut [P],
    before: Option<&[Vec<f64>]>,
) -> (Vec<Vec<f64>>, f64) {
    let chain = |nodes: &mut [P], order: &mut dyn Iterator<Item = usize>| {
        let mut found: Vec<Vec<f64>> = vec![Vec::new(); nodes.len()];
        let mut last: Option<usize> = None;
        for i in order {
            let start = before.map(|before| &before[i]).or(last.map(|last| &found[last]));
            found[i] = match start.cloned() {
                Some(start) => solve(&mut nodes[i], &start, STEPS[0], HELD, 1e-3).0,
                None => from_guesses(&mut nodes[i]),
            };
            last = Some(i);
        }
        found
    };
    let count = nodes.len();
    let down = chain(nodes, &mut (0..count).rev());
    let left = left(nodes, between, &down);
    if before.is_some() {
        return (down, left);
    }
    let up = chain(nodes, &mut (0..count));
    let other = self::left(nodes, between, &up);
    if other < left { (up, other) } else { (down, left) }
}

/// The mean of what is left at all views and half-way between them.
fn left<P: Problem>(nodes: &mut [P], between: &mut [P], found: &[Vec<f64>]) -> f64 {
    let of = |problem: &mut P, x: &[f64]| problem.evaluate(x) / problem.system().whole.max(f64::MIN_POSITIVE);
    let mut sum: f64 = nodes.iter_mut().zip(found).map(|(problem, x)| of(problem, x)).sum();
    for (problem, pair) in between.iter_mut().zip(found.windows(2)) {
        let x: Vec<f64> = pair[0].iter().zip(&pair[1]).map(|(a, b)| 0.5 * (a + b)).collect();
        sum += of(problem, &x);
    }
    sum / (nodes.len() + between.len()) as f64
}

fn from_guesses<P: Problem>(problem: &mut P) -> Vec<f64> {
    let tried: Vec<_> =
        problem.guesses().into_iter().map(|guess| solve(problem, &guess, STEPS[1], 0.0, 1e-2)).collect();
    let best = tried.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or_else(Vec::new, |(best, _)| solve(problem, &best, STEPS[2], 0.0, 1e-3).0)
}

/// The unknowns that make the cost small, and the cost.
fn solve<P: Problem>(
    problem: &mut P,
    start: &[f64],
    steps: usize,
    held: f64,
    mut damping: f64,
) -> (Vec<f64>, f64) {
    let mut x = start.to_vec();
    problem.bound(&mut x);
    let first = x.clone();
    let (scales, most) = problem.scales(&x);
    let whole = problem.system().whole;
    let priors = |x: &[f64], excess: f64| {
        let held = x.iter().zip(&first).zip(&scales).map(|((x, first), scale)| {
            let off = held * (x - first) / scale;
            off * off
        });
        whole * (WHOLE * WHOLE * excess * excess + held.sum::<f64>())
    };
    let mut cost = problem.evaluate(&x);
    let (mut excess, mut rates) = problem.excess(&x);
    cost += priors(&x, excess);
    for _ in 0..steps {
        let (mut products, mut slope) = at_level!(SimdLevel::best(), simd => problem.system().products(simd));
        let size = x.len();
        let counts = WHOLE * WHOLE * whole;
        for i in 0..size {
            slope[i] += counts * rates[i] * excess;
            for j in 0..size {
                products[i * size + j] += counts * rates[i] * rates[j];
            }
            let own = held * held * whole / (scales[i] * scales[i]);
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
            problem.bound(&mut next);
            let own = problem.evaluate(&next);
            let (own_excess, own_rates) = problem.excess(&next);
            let own = own + priors(&next, own_excess);
            if own < cost {
                (x, cost, found) = (next, own, true);
                (excess, rates) = (own_excess, own_rates);
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
    (x, cost)
}

impl System {
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

/// The sum over the lanes.
#[inline(always)]
pub(super) fn added<S: Simd>(lanes: Lanes<S>) -> f64 {
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
