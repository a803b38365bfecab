//! Fits by differences of colour as they are rendered, CIEDE2000.
//!
//! A reading is seen as the point of a sphere that it is of, under one lamp: with π f cosθi, exposed so that a perfect diffuser
//! that faces the lamp is white (Y = 100, D65). CIEDE2000 is of all channels together, so tints of it have no closed form:
//! from the best fit by lightness Levenberg's and Marquardt's steps go on with widths and tints at once, to the least sum of
//! the squares of [`ciede2000_components`]. Of tints in more than three channels only what is seen is changed: X, Y and Z of
//! each lobe; spectra of one colour cannot be told apart by it.

use core::f64::consts::PI;

use glanz_color::difference::{ciede2000, ciede2000_components};
use glanz_color::models::Lab;

use super::errors::{ErrorEstimate, Errors};
use super::fitting::{self, Fit, FitError, FitOptions};
use super::lobe::FitLobe;
use super::metric::Metric;
use super::problem::{AT_BOUND, Columns, Problem, slices};
use super::rendered_slopes::Place;
use super::samples::Samples;
use super::solve::Solved;
use super::tints::Tints;
use super::{blocks, dense::Dense};
use crate::viewing::Viewing;
use crate::{Channels, Readings};

/// Steps, at most.
const MOST_STEPS: usize = 60;
/// A step that lowers the sum of squares by less than this part is the last.
const LAST_GAIN: f64 = 1e-9;
/// Damping that is greater leads nowhere.
const MOST_DAMPING: f64 = 1e8;
/// An unknown with less than this part of the greatest curvature, in its own scale, changes nothing.
const LEAST_CURVATURE: f64 = 1e-12;
/// A parameter that may be e times as great or small is not known.
const MOST_ERROR: f64 = 1.0;

/// Readings as they are seen.
pub(super) struct Seen<'a> {
    pub samples: &'a Samples,
    pub viewing: Viewing,
    labs: Vec<Lab>,
    /// Along which lists of channels tints change.
    pub directions: Vec<Vec<f64>>,
}

impl<'a> Seen<'a> {
    fn new(samples: &'a Samples, channels: &Channels) -> Self {
        let viewing = Viewing::under_d65(channels);
        let lab = |i: usize| viewing.lab(viewing.xyz(samples.values.iter().map(|value| PI * value[i])));
        let labs = blocks::map(samples.len(), |range| range.map(lab).collect::<Vec<_>>()).concat();
        let count = channels.count();
        let directions = match count {
            1..=3 => (0..count).map(|d| (0..count).map(|c| f64::from(u8::from(c == d))).collect()).collect(),
            _ => (0..3).map(|i| viewing.columns().iter().map(|xyz| xyz[i]).collect()).collect(),
        };
        Self { samples, viewing, labs, directions }
    }

    /// X, Y and Z that columns with these tints have, for a value of the column of 1.
    fn seen_tints(&self, tints: &[Tints], columns: usize) -> Vec<[f64; 3]> {
        (0..columns).map(|k| self.viewing.xyz(tints.iter().map(|tint| PI * tint[k]))).collect()
    }

    /// The components of the difference of a reading from what has these X, Y and Z.
    #[inline]
    pub(super) fn components(&self, i: usize, xyz: [f64; 3]) -> [f64; 3] {
        ciede2000_components(self.labs[i], self.viewing.lab(xyz))
    }

    /// The weighted sum of squares for columns and what is seen of their tints.
    fn squares(&self, columns: &[&[f64]], tints: &[[f64; 3]]) -> f64 {
        let part = |range: core::ops::Range<usize>| {
            let of = |i: usize| {
                let components = self.components(i, sum(columns, tints, i));
                self.samples.weights[i] * components.iter().map(|x| x * x).sum::<f64>()
            };
            range.map(of).sum::<f64>()
        };
        blocks::map(self.samples.len(), part).into_iter().sum()
    }
}

/// X, Y and Z of a reading: the sum of columns times what is seen of their tints.
#[inline]
pub(super) fn sum(columns: &[&[f64]], tints: &[[f64; 3]], i: usize) -> [f64; 3] {
    let mut xyz = [0.0; 3];
    for (column, tint) in columns.iter().zip(tints) {
        xyz.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += tint * column[i]);
    }
    xyz
}

/// A point with its tints.
struct State {
    point: Vec<f64>,
    columns: Vec<Columns>,
    solved: Solved,
}

/// The search from state to state.
struct Search<'a> {
    seen: Seen<'a>,
    problem: Problem<'a>,
}

impl Search<'_> {
    fn state(&mut self, point: Vec<f64>, tints: Vec<Tints>) -> Result<State, FitError> {
        let point = self.problem.clamped(&point);
        let columns = self.problem.columns(&point)?;
        let all = slices(&columns);
        let squares = self.seen.squares(&all, &self.seen.seen_tints(&tints, all.len()));
        Ok(State { point, columns, solved: Solved { tints, squares } })
    }

    /// Sums over all readings at a state.
    fn slopes(&mut self, state: &State) -> Result<Dense, FitError> {
        let columns = slices(&state.columns);
        let tints = self.seen.seen_tints(&state.solved.tints, columns.len());
        let place = Place { point: &state.point, columns: &columns, tints: &tints };
        place.slopes(&self.seen, &mut self.problem)
    }

    /// The unknowns that may be changed: no parameter that would leave its range, and no tint that would be negative.
    fn chosen(&self, state: &State, slopes: &Dense) -> Vec<usize> {
        let (count, directions) = (state.point.len(), self.seen.directions.len());
        let ranges = self.problem.ranges();
        let most = (0..slopes.size).map(|i| slopes.diagonal(i)).fold(0.0, f64::max);
        let may = |i: &usize| {
            if slopes.diagonal(*i) <= LEAST_CURVATURE * most {
                return false;
            }
            let outward = slopes.products[*i] > 0.0;
            if *i < count {
                let [low, high] = ranges[*i];
                return if outward { state.point[*i] < high } else { state.point[*i] > low };
            }
            let (column, direction) = ((i - count) / directions, (i - count) % directions);
            let is_one_channel = self.seen.directions.len() == state.solved.tints.len();
            outward || !is_one_channel || state.solved.tints[direction][column] > 0.0
        };
        (0..slopes.size).filter(may).collect()
    }

    /// The state that a damped step leads to, and by how much it should lower the sum of squares.
    fn step(&mut self, state: &State, slopes: &Dense, damping: f64) -> Result<(State, f64), FitError> {
        let mut damped = slopes.clone();
        (0..slopes.size).for_each(|i| damped.matrix[i * slopes.size + i] *= 1.0 + damping);
        let step = damped.solve_for(&self.chosen(state, slopes)).unwrap_or_else(|| vec![0.0; slopes.size]);
        let expected = step.iter().zip(&slopes.products).map(|(step, product)| step * product).sum();
        let count = state.point.len();
        let point = state.point.iter().zip(&step).map(|(x, step)| x + step.clamp(-1.0, 1.0)).collect();
        let mut tints = state.solved.tints.clone();
        for (unknown, step) in step[count..].iter().enumerate() {
            let directions = self.seen.directions.len();
            let (column, direction) = (unknown / directions, unknown % directions);
            for (tint, along) in tints.iter_mut().zip(&self.seen.directions[direction]) {
                tint[column] += along * step;
            }
        }
        tints.iter_mut().flatten().for_each(|tint| *tint = tint.max(0.0));
        Ok((self.state(point, tints)?, expected))
    }

    /// The least sum of squares near a state.
    fn refine(
        &mut self,
        mut state: State,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(State, Dense), FitError> {
        let mut damping = 1e-3;
        let mut slopes = self.slopes(&state)?;
        for step in 0..MOST_STEPS {
            // Most end after few steps: each takes an eighth of what is left.
            progress(1.0 - libm::pow(0.875, step as f64));
            let (next, expected) = self.step(&state, &slopes, damping)?;
            if expected <= LAST_GAIN * state.solved.squares {
                break;
            }
            if next.solved.squares < state.solved.squares {
                let gain = 1.0 - next.solved.squares / state.solved.squares;
                state = next;
                damping *= 0.1;
                slopes = self.slopes(&state)?;
                if gain < LAST_GAIN {
                    break;
                }
            } else if damping > MOST_DAMPING {
                break;
            } else {
                damping *= 10.0;
            }
        }
        Ok((state, slopes))
    }

    /// Standard errors of the numbers of the point, tints being free.
    fn errors(&self, state: &State, slopes: &Dense) -> Errors {
        let samples = self.seen.samples;
        let numbers = samples.len() * self.seen.directions.len();
        let variance = state.solved.squares / numbers.saturating_sub(slopes.size).max(1) as f64;
        let ranges = self.problem.ranges();
        let most = (0..slopes.size).map(|i| slopes.diagonal(i)).fold(0.0, f64::max);
        let is_inside = |i: usize| {
            let [low, high] = ranges[i];
            state.point[i] - low > AT_BOUND && high - state.point[i] > AT_BOUND
        };
        let may =
            |i: &usize| (*i >= ranges.len() || is_inside(*i)) && slopes.diagonal(*i) > LEAST_CURVATURE * most;
        let chosen: Vec<usize> = (0..slopes.size).filter(may).collect();
        let error = |i: usize| {
            let inverse = slopes.inverse_at(i, &chosen).filter(|_| chosen.contains(&i))?;
            Some((variance * inverse).sqrt()).filter(|error| *error < MOST_ERROR)
        };
        Errors { of: (0..ranges.len()).map(error).collect(), estimate: ErrorEstimate::Profile }
    }
}

/// The fit whose readings look most like those that were read.
pub(super) fn fit_samples(
    samples: &Samples,
    channels: &Channels,
    lobes: &[FitLobe],
    progress: &mut dyn FnMut(f64),
) -> Result<Fit, FitError> {
    let start = fitting::fit_samples(samples, lobes, Metric::Lightness, &mut |part| progress(0.5 * part))?;
    let mut search = Search {
        seen: Seen::new(samples, channels),
        problem: Problem::new(samples, lobes, Metric::Rendered),
    };
    let whole = search.seen.squares(&[], &[]);
    let state = search.state(start.point(), start.tints())?;
    let (state, slopes) = search.refine(state, &mut |part| progress(0.5 + 0.5 * part))?;
    let errors = search.errors(&state, &slopes);
    let found = search.problem.fit_of(&state.point, &errors, &state.solved)?;
    let squares = state.solved.squares;
    Ok(Fit {
        error: (squares / samples.weights.iter().sum::<f64>()).sqrt(),
        relative: (squares / whole.max(f64::MIN_POSITIVE)).sqrt(),
        evaluations: start.evaluations + found.evaluations,
        ..found
    })
}

impl Fit {
    /// The differences of colour, CIEDE2000, between readings and fit as they are rendered: as points of a sphere under one
    /// lamp, exposed so that a perfect diffuser that faces the lamp is white (Y = 100, D65, CIE 1931 observer). One for each
    /// reading that counts by the options, in their order.
    ///
    /// ```
    /// use glanz_math::Vec3;
    /// use glanz_measure::{Channels, FitOptions, Readings, fit};
    ///
    /// let mut readings = Readings::new(Channels::Rgb);
    /// let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
    /// (0..60).for_each(|theta_o| readings.push(wi, Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0), &[0.2, 0.1, 0.05]));
    /// let found = fit(&readings, &["lambert"], &FitOptions::default())?;
    /// let differences = found.delta_e(&readings, &FitOptions::default());
    /// assert!(differences.len() == 60 && differences.iter().all(|delta_e| *delta_e < 1e-3));
    /// # Ok::<(), glanz_measure::FitError>(())
    /// ```
    pub fn delta_e(&self, readings: &Readings, options: &FitOptions) -> Vec<f64> {
        let samples = Samples::of(readings, options);
        let seen = Seen::new(&samples, readings.channels());
        let azimuth = self.aniso_deg.unwrap_or(0.0).to_radians();
        let of_lobe = |lobe: &super::FittedLobe| {
            let column = samples.column(&lobe.shape, azimuth);
            if lobe.tint_at_grazing.is_some() { samples.schlick(&column).into() } else { vec![column] }
        };
        let columns: Vec<Vec<f64>> = self.lobes.iter().flat_map(of_lobe).collect();
        let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        let tints = seen.seen_tints(&self.tints(), columns.len());
        blocks::fill(samples.len(), |range, out| {
            for (out, i) in out.iter_mut().zip(range) {
                *out = ciede2000(seen.labs[i], seen.viewing.lab(sum(&columns, &tints, i)));
            }
        })
    }

    /// The logarithms of the parameters that were searched, and the azimuth of the grain: a point of the search.
    fn point(&self) -> Vec<f64> {
        let parameters = self.lobes.iter().flat_map(|lobe| &lobe.parameters);
        let logs = parameters.map(|parameter| libm::log(parameter.value));
        logs.chain(self.aniso_deg.map(f64::to_radians)).collect()
    }

    /// Tints by channels, and of each by columns.
    fn tints(&self) -> Vec<Tints> {
        let columns: Vec<&[f64]> = self.lobes.iter().flat_map(super::FittedLobe::tints).collect();
        let count = columns.first().map_or(0, |tint| tint.len());
        let mut tints = vec![Tints::default(); count];
        for (k, column) in columns.iter().enumerate() {
            tints.iter_mut().zip(*column).for_each(|(tints, tint)| tints[k] = *tint);
        }
        tints
    }
}
