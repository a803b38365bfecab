//! The search for widths.

use std::collections::HashMap;
use std::rc::Rc;

use super::tints::Normal;
use super::{Fit, FitError, FittedLobe, Lobe, Metric, Samples};

/// Steps of the first grid, by the number of widths.
const GRID: [usize; 6] = [0, 14, 9, 6, 4, 3];
/// Starts of the simplex: the best of the grid.
const STARTS: usize = 3;
/// Evaluations of one simplex.
const MOST_STEPS: usize = 200;
/// Rounds in which weights follow the fit.
const ROUNDS: usize = 4;

pub(super) struct Problem<'a> {
    samples: &'a Samples,
    lobes: &'a [Lobe],
    metric: Metric,
    /// The logarithms of the ranges of the widths.
    ranges: Vec<[f64; 2]>,
    /// Columns by lobe and the bits of the width.
    columns: HashMap<(usize, u64), Rc<Vec<f64>>>,
    evaluations: usize,
}

/// A corner of a simplex: the sum of squares there, and the logarithms of the widths.
type Corner = (f64, Vec<f64>);

/// The best tints for widths.
struct Solved {
    /// Channel by channel.
    tints: Vec<Vec<f64>>,
    /// The sum of the squares of the metric's differences.
    squares: f64,
}

impl<'a> Problem<'a> {
    pub(super) fn new(samples: &'a Samples, lobes: &'a [Lobe], metric: Metric) -> Self {
        let widths = lobes.iter().filter_map(|lobe| lobe.width);
        let ranges = widths.map(|(_, [low, high])| [libm::log(low), libm::log(high)]).collect();
        Self { samples, lobes, metric, ranges, columns: HashMap::new(), evaluations: 0 }
    }

    /// How often shapes were evaluated.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// The logarithms of the best widths.
    pub(super) fn search(&mut self) -> Result<Vec<f64>, FitError> {
        let n = self.ranges.len();
        if n == 0 {
            return Ok(Vec::new());
        }
        let mut grid: Vec<(f64, Vec<f64>)> = Vec::new();
        for point in self.grid(GRID[n.min(GRID.len() - 1)]) {
            grid.push((self.squares(&point)?, point));
        }
        grid.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best = (f64::INFINITY, grid[0].1.clone());
        for (_, start) in grid.into_iter().take(STARTS) {
            let found = self.simplex(start)?;
            // Columns of one descent are of no use to the next.
            self.columns.clear();
            if found.0 < best.0 {
                best = found;
            }
        }
        Ok(best.1)
    }

    /// Points at even logarithms; of lobes of one model each set of widths once.
    fn grid(&self, steps: usize) -> Vec<Vec<f64>> {
        let names: Vec<&str> = self
            .lobes
            .iter()
            .filter(|lobe| lobe.width.is_some())
            .map(|lobe| lobe.shape.info().name)
            .collect();
        let mut points: Vec<Vec<f64>> = vec![Vec::new()];
        for (i, [low, high]) in self.ranges.iter().enumerate() {
            let values = (0..steps).map(|k| low + (high - low) * (k as f64 + 0.5) / steps as f64);
            let values: Vec<f64> = values.collect();
            points = points
                .into_iter()
                .flat_map(|point| values.iter().map(move |x| [&point[..], &[*x]].concat()))
                .filter(|point| (0..i).all(|j| names[j] != names[i] || point[j] < point[i]))
                .collect();
        }
        points
    }

    /// The sum of squares at these logarithms of widths.
    fn squares(&mut self, point: &[f64]) -> Result<f64, FitError> {
        let columns = self.columns(point)?;
        Ok(self.solve(&columns).squares)
    }

    fn columns(&mut self, point: &[f64]) -> Result<Vec<Rc<Vec<f64>>>, FitError> {
        let mut widths =
            point.iter().zip(&self.ranges).map(|(x, [low, high])| libm::exp(x.clamp(*low, *high)));
        let mut all = Vec::with_capacity(self.lobes.len());
        for (number, lobe) in self.lobes.iter().enumerate() {
            let width = if lobe.width.is_some() { widths.next().unwrap_or(1.0) } else { 0.0 };
            let key = (number, width.to_bits());
            if let Some(known) = self.columns.get(&key) {
                all.push(Rc::clone(known));
                continue;
            }
            let shape = lobe.with(width).map_err(|error| FitError::Model(error.to_string()))?;
            let column = Rc::new(self.samples.column(&shape));
            self.evaluations += 1;
            self.columns.insert(key, Rc::clone(&column));
            all.push(column);
        }
        Ok(all)
    }

    /// The tints for these columns. Weights turn the squares of differences into those of the metric: they follow the fit
    /// of the round before, and are exact where it no longer changes. All channels share those of their mean.
    fn solve(&self, columns: &[Rc<Vec<f64>>]) -> Solved {
        let samples = self.samples;
        let (n, channels) = (samples.len(), samples.channels);
        let columns: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
        let first = |y: &f64| self.metric.weight(*y, *y, samples.least);
        let mut weights: Vec<f64> = samples.means.iter().map(first).collect();
        let mut tints = Vec::new();
        let rounds = if self.metric == Metric::L2 { 1 } else { ROUNDS };
        for _ in 0..rounds {
            let normal = Normal::new(&columns, &weights);
            let of_channel = |c: usize| {
                let product = |column: &&[f64]| {
                    (0..n).map(|i| weights[i] * column[i] * samples.values[i * channels + c]).sum::<f64>()
                };
                normal.solve(&columns.iter().map(product).collect::<Vec<_>>()).0
            };
            tints = (0..channels).map(of_channel).collect::<Vec<_>>();
            let mean = |k: usize| tints.iter().map(|tint| tint[k]).sum::<f64>() / channels as f64;
            let means: Vec<f64> = (0..columns.len()).map(mean).collect();
            for i in 0..n {
                let model: f64 = columns.iter().zip(&means).map(|(column, tint)| column[i] * tint).sum();
                weights[i] = self.metric.weight(model, samples.means[i], samples.least);
            }
        }
        let squares = (0..n).map(|i| self.of_reading(i, &columns, &tints)).sum();
        Solved { tints, squares }
    }

    /// The squares of the metric's differences at a reading, of all channels.
    fn of_reading(&self, i: usize, columns: &[&[f64]], tints: &[Vec<f64>]) -> f64 {
        let channels = self.samples.channels;
        let of_channel = |(c, tint): (usize, &Vec<f64>)| {
            let model: f64 = columns.iter().zip(tint).map(|(column, tint)| column[i] * tint).sum();
            let difference = self.metric.of(model) - self.metric.of(self.samples.values[i * channels + c]);
            difference * difference
        };
        tints.iter().enumerate().map(of_channel).sum()
    }

    /// J. Nelder and R. Mead 1965, in the logarithms of the widths.
    fn simplex(&mut self, start: Vec<f64>) -> Result<(f64, Vec<f64>), FitError> {
        let n = start.len();
        let mut corners = vec![(self.squares(&start)?, start.clone())];
        for i in 0..n {
            let mut corner = start.clone();
            corner[i] += 0.2;
            corners.push((self.squares(&corner)?, corner));
        }
        for _ in 0..MOST_STEPS {
            corners.sort_by(|a, b| a.0.total_cmp(&b.0));
            let best = &corners[0].1;
            let sizes = corners[1..].iter().flat_map(|(_, x)| x.iter().zip(best).map(|(a, b)| (a - b).abs()));
            if sizes.fold(0.0, f64::max) < 1e-5 {
                break;
            }
            match self.moved(&corners)? {
                Some(corner) => corners[n] = corner,
                None => self.shrink(&mut corners)?,
            }
        }
        corners.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(corners.swap_remove(0))
    }

    /// What stands for the worst corner, the last one: its mirror image, farther or nearer; nothing where none is better.
    fn moved(&mut self, corners: &[Corner]) -> Result<Option<Corner>, FitError> {
        let n = corners.len() - 1;
        let (worst, at_worst) = &corners[n];
        let mean = |i: usize| corners[..n].iter().map(|(_, x)| x[i]).sum::<f64>() / n as f64;
        let centre: Vec<f64> = (0..n).map(mean).collect();
        let along =
            |t: f64| -> Vec<f64> { centre.iter().zip(at_worst).map(|(c, w)| c + t * (c - w)).collect() };
        let mirrored = along(1.0);
        let value = self.squares(&mirrored)?;
        if value < corners[0].0 {
            let far = along(2.0);
            let farther = self.squares(&far)?;
            return Ok(Some(if farther < value { (farther, far) } else { (value, mirrored) }));
        }
        if value < corners[n - 1].0 {
            return Ok(Some((value, mirrored)));
        }
        let near = if value < *worst { along(0.5) } else { along(-0.5) };
        let nearer = self.squares(&near)?;
        Ok((nearer < value.min(*worst)).then_some((nearer, near)))
    }

    /// All corners half the way to the best one.
    fn shrink(&mut self, corners: &mut [Corner]) -> Result<(), FitError> {
        let best = corners[0].1.clone();
        for corner in corners.iter_mut().skip(1) {
            let x: Vec<f64> = corner.1.iter().zip(&best).map(|(x, b)| 0.5 * (x + b)).collect();
            *corner = (self.squares(&x)?, x);
        }
        Ok(())
    }

    /// The fit at these logarithms of widths.
    pub(super) fn fit_at(&mut self, point: &[f64], errors: &[Option<f64>]) -> Result<Fit, FitError> {
        let columns = self.columns(point)?;
        let solved = self.solve(&columns);
        let count = (self.samples.len() * self.samples.channels) as f64;
        let whole: f64 = self.samples.values.iter().map(|y| self.metric.of(*y).powi(2)).sum();
        if whole <= 0.0 || solved.tints.iter().flatten().all(|tint| *tint <= 0.0) {
            return Err(FitError::Nothing("all values are 0 or below".to_owned()));
        }
        let mut width = 0;
        let mut lobes = Vec::new();
        for (number, lobe) in self.lobes.iter().enumerate() {
            let (mut log_error, mut at_bound, mut value) = (None, false, 0.0);
            if lobe.width.is_some() {
                let [low, high] = self.ranges[width];
                let x = point[width].clamp(low, high);
                at_bound = x - low < 1e-3 || high - x < 1e-3;
                log_error = errors[width].filter(|_| !at_bound);
                value = libm::exp(x);
                width += 1;
            }
            let shape = lobe.with(value).map_err(|error| FitError::Model(error.to_string()))?;
            let tint = solved.tints.iter().map(|tint| tint[number]).collect();
            lobes.push(FittedLobe {
                shape,
                parameter: lobe.width.map(|(name, _)| name),
                log_error,
                at_bound,
                tint,
            });
        }
        let (error, relative) = ((solved.squares / count).sqrt(), (solved.squares / whole).sqrt());
        Ok(Fit { lobes, error, relative, readings: self.samples.len(), evaluations: self.evaluations })
    }

    /// Standard errors of the logarithms of the widths, from the curvature of the sum of squares about its least.
    pub(super) fn errors(&mut self, point: &[f64]) -> Result<Vec<Option<f64>>, FitError> {
        let squares = self.squares(point)?;
        let n = point.len();
        let step = 0.02;
        let mut curvature = vec![vec![0.0; n]; n];
        for i in 0..n {
            for j in 0..=i {
                let mut sum = 0.0;
                for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                    let mut moved = point.to_vec();
                    moved[i] += a * step;
                    moved[j] += b * step;
                    sum += a * b * self.squares(&moved)?;
                }
                curvature[i][j] = sum / (4.0 * step * step);
                curvature[j][i] = curvature[i][j];
            }
        }
        let numbers = n + self.lobes.len() * self.samples.channels;
        let count = self.samples.len() * self.samples.channels;
        let variance = squares / count.saturating_sub(numbers).max(1) as f64;
        let normal = Normal { matrix: curvature };
        Ok((0..n).map(|i| Some((2.0 * variance * normal.inverse_at(i)?).sqrt())).collect())
    }
}
