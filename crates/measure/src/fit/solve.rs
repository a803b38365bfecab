//! The best tints for given shapes.

use core::ops::Range;

use glanz_math::{SimdLevel, at_level};

use super::blocks::{self, BLOCK, dot};
use super::metric::{CubeRoot, Curve, Lightness, Linear, Logarithm, Metric};
use super::samples::Samples;
use super::tints::{Normal, Tints};

/// The tints of shapes, and how far off they are.
#[derive(Clone)]
pub(super) struct Solved {
    /// Channel by channel.
    pub tints: Vec<Tints>,
    /// The sum of the squares of the metric's differences, weighted.
    pub squares: f64,
}

/// Finds tints by Gauss and Newton's way: each round is least squares of g's tangents, in closed form. The first is at
/// the readings themselves, the others at the fit of the round before.
pub(super) struct Solver<'a> {
    samples: &'a Samples,
    metric: Metric,
    /// g of the values, channel by channel.
    targets: Vec<Vec<f64>>,
    /// g of the least number.
    at_least: f64,
}

/// Rounds after the first, at most.
const ROUNDS: usize = 6;
/// A round that lowers the sum of squares by less than this part is the last.
const LAST_GAIN: f64 = 1e-10;

impl<'a> Solver<'a> {
    pub(super) fn new(samples: &'a Samples, metric: Metric) -> Self {
        let target = |values: &Vec<f64>| {
            blocks::fill(values.len(), |range, out| {
                out.copy_from_slice(&values[range]);
                metric.apply(out);
            })
        };
        let targets = samples.values.iter().map(target).collect();
        Self { samples, metric, targets, at_least: metric.of(samples.least) }
    }

    pub(super) fn samples(&self) -> &'a Samples {
        self.samples
    }

    /// The sum of the squares of g of the values.
    pub(super) fn whole(&self) -> f64 {
        let of_channel = |target: &Vec<f64>| -> f64 {
            let weighted = |(g, weight): (&f64, &f64)| g * g * weight;
            target.iter().zip(&self.samples.weights).map(weighted).sum()
        };
        self.targets.iter().map(of_channel).sum()
    }

    /// The tints for these columns; from tints that are near to them it takes fewer rounds.
    pub(super) fn solve(&self, columns: &[&[f64]], near: Option<&[Tints]>) -> Solved {
        let solve = |sums: &[Sums]| sums.iter().map(|sums| sums.normal.solve()).collect::<Vec<Tints>>();
        // Of g(x) = x the tangents are the same everywhere: the first round is the last.
        let near = near.filter(|_| self.metric != Metric::L2);
        let mut tints = near.map_or_else(|| solve(&self.pass(columns, None)), <[Tints]>::to_vec);
        let mut best: Option<Solved> = None;
        for _ in 0..ROUNDS {
            let sums = self.pass(columns, Some(&tints));
            let squares = sums.iter().map(|sums| sums.squares).sum();
            let before = best.as_ref().map_or(f64::INFINITY, |best| best.squares);
            if squares < before {
                best = Some(Solved { tints: tints.clone(), squares });
            }
            if self.metric == Metric::L2 || (before - squares).abs() < LAST_GAIN * squares {
                break;
            }
            tints = solve(&sums);
        }
        best.unwrap_or(Solved { tints, squares: f64::INFINITY })
    }

    /// The differences of g, channel by channel, times the roots of the weights.
    pub(super) fn residuals(&self, columns: &[&[f64]], tints: &[Tints]) -> Vec<f64> {
        let of_channel = |c: usize| {
            blocks::fill(self.samples.len(), |range, out| {
                self.model(&range, columns, &tints[c], out);
                self.metric.apply(out);
                let targets = self.targets[c][range.clone()].iter().zip(&self.samples.weights[range]);
                for (out, (target, weight)) in out.iter_mut().zip(targets) {
                    *out = weight.sqrt() * (target - *out);
                }
            })
        };
        (0..tints.len()).map(of_channel).collect::<Vec<_>>().concat()
    }

    /// Whether the squares of these differences grow with g of the fit, surely: R. Koenker, "A note on studentizing a test for
    /// heteroscedasticity", J. Econometrics 17, 1981, for one regressor.
    pub(super) fn spread_grows(&self, residuals: &[f64], surely: f64) -> bool {
        let weights = self.samples.weights.iter().cycle();
        let of = |((residual, target), weight): ((&f64, &f64), &f64)| {
            [target - residual / weight.sqrt(), residual * residual]
        };
        let all = || residuals.iter().zip(self.targets.iter().flatten()).zip(weights.clone()).map(of);
        let count = residuals.len() as f64;
        let sums = all().fold([0.0; 2], |[a, b], [value, square]| [a + value, b + square]);
        let means = sums.map(|sum| sum / count);
        let [mut values, mut squares, mut both] = [0.0; 3];
        for [value, square] in all() {
            let [value, square] = [value - means[0], square - means[1]];
            values += value * value;
            squares += square * square;
            both += value * square;
        }
        both > 0.0 && count * both * both > surely * values * squares
    }

    /// How much each difference is held by its own reading, by way of the tints: the diagonal of X (XᵀX)⁻¹ Xᵀ of the slopes X,
    /// channel by channel.
    pub(super) fn leverages(&self, columns: &[&[f64]], tints: &[Tints]) -> Vec<f64> {
        let sums = self.pass(columns, Some(tints));
        let of_channel = |c: usize| {
            let chosen = (0..columns.len()).filter(|k| tints[c][*k] > 0.0).fold(0, |bits, k| bits | 1 << k);
            let inverse = sums[c].normal.inverse(chosen).unwrap_or_default();
            blocks::fill(self.samples.len(), |range, out| {
                self.squared_slopes(&range, columns, c, &tints[c], out);
                for (out, i) in out.iter_mut().zip(range) {
                    let line = |line: &Tints| -> f64 {
                        line.iter().zip(columns).map(|(inverse, column)| inverse * column[i]).sum()
                    };
                    *out *=
                        inverse.iter().zip(columns).map(|(own, column)| line(own) * column[i]).sum::<f64>();
                }
            })
        };
        (0..tints.len()).map(of_channel).collect::<Vec<_>>().concat()
    }

    /// The weighted squares of the slopes of g at the fit.
    fn squared_slopes(
        &self,
        range: &Range<usize>,
        columns: &[&[f64]],
        c: usize,
        tints: &Tints,
        out: &mut [f64],
    ) {
        let mut rows = [[0.0; BLOCK]; 2];
        let [valued, differences] = rows.each_mut().map(|row| &mut row[..range.len()]);
        self.model(range, columns, tints, out);
        let rows = [out, valued, differences];
        match self.metric {
            Metric::L2 => self.tangents::<Linear>(range, c, rows),
            Metric::Log => self.tangents::<Logarithm>(range, c, rows),
            Metric::CubeRoot => self.tangents::<CubeRoot>(range, c, rows),
            Metric::Lightness | Metric::Rendered => self.tangents::<Lightness>(range, c, rows),
        };
    }

    /// The sum of columns times tints.
    #[inline(always)]
    fn model(&self, range: &Range<usize>, columns: &[&[f64]], tints: &Tints, out: &mut [f64]) {
        out.fill(0.0);
        for (column, tint) in columns.iter().zip(tints) {
            out.iter_mut().zip(&column[range.clone()]).for_each(|(sum, value)| *sum += tint * value);
        }
    }

    /// Sums over all readings, channel by channel: at these tints, or at the readings themselves.
    fn pass(&self, columns: &[&[f64]], tints: Option<&[Tints]>) -> Vec<Sums> {
        let level = SimdLevel::best();
        let parts = blocks::map(self.samples.len(), |range| {
            let mut sums = vec![Sums::new(columns.len()); self.targets.len()];
            for (c, sums) in sums.iter_mut().enumerate() {
                let tints = tints.map(|tints| &tints[c]);
                at_level!(level, _simd => match self.metric {
                    Metric::L2 => self.block::<Linear>(&range, columns, c, tints, sums),
                    Metric::Log => self.block::<Logarithm>(&range, columns, c, tints, sums),
                    Metric::CubeRoot => self.block::<CubeRoot>(&range, columns, c, tints, sums),
                    Metric::Lightness | Metric::Rendered => {
                        self.block::<Lightness>(&range, columns, c, tints, sums)
                    }
                });
            }
            sums
        });
        let mut all = vec![Sums::new(columns.len()); self.targets.len()];
        for part in &parts {
            all.iter_mut().zip(part).for_each(|(sums, part)| sums.add(part));
        }
        all
    }

    /// Sums over the readings of a block.
    #[inline(always)]
    fn block<C: Curve>(
        &self,
        range: &Range<usize>,
        columns: &[&[f64]],
        c: usize,
        tints: Option<&Tints>,
        sums: &mut Sums,
    ) {
        let n = range.len();
        let mut rows = [[0.0; BLOCK]; 3];
        let [squared, valued, weighted] = rows.each_mut().map(|row| &mut row[..n]);
        match tints {
            None => squared.copy_from_slice(&self.samples.values[c][range.clone()]),
            Some(tints) => self.model(range, columns, tints, squared),
        }
        sums.squares = self.tangents::<C>(range, c, [&mut *squared, &mut *valued, &mut *weighted]);
        for (a, column) in columns.iter().enumerate() {
            let column = &column[range.clone()][..n];
            sums.normal.products[a] = dot(valued, column);
            for i in 0..n {
                weighted[i] = squared[i] * column[i];
            }
            for (b, other) in columns[..=a].iter().enumerate() {
                sums.normal.matrix[a][b] = dot(weighted, &other[range.clone()]);
            }
        }
    }

    /// The sum of the squares of differences, from the fit in the first row. With m the fit, r the difference of g there and s
    /// the slope of g, the tangent's least squares have the weights s² and the values m + r/s: the first row becomes s², the
    /// second their product, both weighted, and the third the differences.
    #[inline(always)]
    fn tangents<C: Curve>(&self, range: &Range<usize>, c: usize, rows: [&mut [f64]; 3]) -> f64 {
        // All of one length, which the compiler then need not check.
        let n = range.len();
        let [squared, valued, differences] = rows.map(|row| &mut row[..n]);
        let (weights, targets) =
            (&self.samples.weights[range.clone()][..n], &self.targets[c][range.clone()][..n]);
        let (least, at_least) = (self.samples.least, self.at_least);
        for i in 0..n {
            let model = squared[i];
            let value = C::of(model.max(0.0));
            let slope = C::slope(model.max(least), value.max(at_least));
            let difference = targets[i] - value;
            squared[i] = weights[i] * slope * slope;
            valued[i] = squared[i] * model + weights[i] * slope * difference;
            differences[i] = difference;
        }
        let mut sums = [0.0; 8];
        for i in 0..n {
            sums[i % 8] += weights[i] * differences[i] * differences[i];
        }
        sums.iter().sum()
    }
}

/// Sums over readings of one channel.
#[derive(Clone)]
struct Sums {
    /// Of the squares of differences.
    squares: f64,
    normal: Normal,
}

impl Sums {
    fn new(columns: usize) -> Self {
        Self { squares: 0.0, normal: Normal::new(columns) }
    }

    fn add(&mut self, other: &Self) {
        self.squares += other.squares;
        self.normal.add(&other.normal);
    }
}
