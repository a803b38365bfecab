//! Standard errors of what is searched.
//!
//! Where all differences have one variance, it and the curvature of the sum of squares tell them: the profile's. Noise that is a
//! part of the value is greatest where readings are, under L2 above all: then the products of differences and slopes tell them
//! as they are. F. Eicker 1967, P. Huber 1967 and H. White, "A heteroskedasticity-consistent covariance matrix estimator and a
//! direct test for heteroskedasticity", Econometrica 48, 1980; in the form HC3 of J. MacKinnon and H. White, J. Econometrics 29,
//! 1985, where each difference counts as if its reading were not in the fit, with all of its channels.

use super::blocks;
use super::problem::{AT_BOUND, Columns, Problem, slices};
use super::refine::Slopes;
use super::samples::GROUPS;
use super::solve::Solved;
use super::tints::{MOST, Tints};
use crate::linear::solve;

/// A parameter with less than this part of the greatest curvature changes nothing.
const LEAST_CURVATURE: f64 = 1e-12;
/// A parameter that may be e times as great or small is not known.
const MOST_ERROR: f64 = 1.0;
/// The least that is left of a difference where its reading decides the fit by itself.
const LEAST_LEFT: f64 = 0.05;
/// Of so much more than chance squares of differences must follow the value: 1 of 1000 of χ² with one degree of freedom.
const SURELY: f64 = 10.83;

/// How standard errors were found.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, ErrorEstimate, FitOptions, Readings, fit};
///
/// // Readings of one value that are off by a hundredth in turn.
/// let mut readings = Readings::new(Channels::Luminance);
/// let wi = Vec3::from_angles(0.5, std::f64::consts::PI);
/// for theta_o in 0..60 {
///     let value = if theta_o % 2 == 0 { 0.21 } else { 0.19 };
///     readings.push(wi, Vec3::from_angles(f64::from(theta_o).to_radians(), 0.0), &[value]);
/// }
/// let found = fit(&readings, &["lambert"], &FitOptions::default())?;
/// assert_eq!(found.error_estimate.name(), ErrorEstimate::Profile.name());
/// # Ok::<(), glanz_measure::FitError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ErrorEstimate {
    /// From the curvature of the sum of squares, all differences having one variance.
    #[default]
    Profile,
    /// From each difference as it is (HC3): taken where their squares grow with the value.
    Sandwich,
}

impl ErrorEstimate {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Profile => "profile",
            Self::Sandwich => "sandwich",
        }
    }
}

/// Standard errors of the numbers of a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Errors {
    /// None where one cannot be told.
    pub of: Vec<Option<f64>>,
    pub estimate: ErrorEstimate,
}

impl Problem<'_> {
    /// Standard errors at a point with its tints, which follow it. Parameters at an end of their range are fixed there, and those
    /// of lobes that are not there say nothing.
    pub(super) fn errors(&self, point: &[f64], slopes: &Slopes, state: &(Solved, Vec<Columns>)) -> Errors {
        let matrix = &slopes.normal.matrix;
        let most = (0..point.len()).map(|i| matrix[i][i]).fold(0.0, f64::max);
        let mut chosen = 0;
        for (i, [low, high]) in self.ranges().into_iter().enumerate() {
            let is_inside = point[i] - low > AT_BOUND && high - point[i] > AT_BOUND;
            chosen |= usize::from(is_inside && matrix[i][i] > LEAST_CURVATURE * most) << i;
        }
        let sandwich = self.solver().spread_grows(&slopes.residuals, SURELY);
        let sandwich = sandwich.then(|| self.sandwich(slopes, chosen, state)).flatten();
        let estimate = if sandwich.is_some() { ErrorEstimate::Sandwich } else { ErrorEstimate::Profile };
        let variance = self.variance(point.len(), state.0.squares);
        let error = |i: usize| {
            let inverse = slopes.normal.inverse_at(i, chosen).filter(|_| chosen >> i & 1 == 1)?;
            let error = sandwich.map_or(variance * inverse, |all| all[i]).sqrt();
            Some(error).filter(|error| *error < MOST_ERROR)
        };
        Errors { of: (0..point.len()).map(error).collect(), estimate }
    }

    /// The variance of a difference, if all have one.
    fn variance(&self, parameters: usize, squares: f64) -> f64 {
        let samples = self.solver().samples();
        let columns: usize = self.lobes().iter().map(|lobe| lobe.columns()).sum();
        let numbers = parameters + columns * samples.values.len();
        let count = samples.len() * samples.values.len();
        squares / count.saturating_sub(numbers).max(1) as f64
    }

    /// Variances of the numbers of a point from each difference as it is; those of the channels of a reading count as one, since
    /// they may err together.
    fn sandwich(
        &self,
        slopes: &Slopes,
        chosen: usize,
        (solved, columns): &(Solved, Vec<Columns>),
    ) -> Option<[f64; MOST]> {
        let inverse = slopes.normal.inverse(chosen)?;
        let leverages = self.solver().leverages(&slices(columns), &solved.tints);
        let count = self.solver().samples().len();
        let parts = blocks::map(count, |range| {
            let mut sums = [0.0; MOST];
            for reading in range {
                let moved =
                    moved(slopes, &inverse, &leverages, (reading..slopes.residuals.len()).step_by(count));
                sums.iter_mut().zip(moved).for_each(|(sum, moved)| *sum += moved * moved);
            }
            sums
        });
        let mut all = [0.0; MOST];
        parts.iter().for_each(|part| all.iter_mut().zip(part).for_each(|(sum, part)| *sum += part));
        Some(all)
    }
}

/// How far a reading moves the numbers of a point: its differences, at these places, times the slopes, as if it were not in the fit.
fn moved(
    slopes: &Slopes,
    inverse: &[Tints; MOST],
    leverages: &[f64],
    places: impl Iterator<Item = usize>,
) -> [f64; MOST] {
    let (mut own, mut left, mut differences) =
        ([[0.0; MOST]; GROUPS], [[0.0; GROUPS]; GROUPS], [0.0; GROUPS]);
    let mut rows = [[0.0; MOST]; GROUPS];
    let mut count = 0;
    for (channel, at) in places.take(GROUPS).enumerate() {
        rows[channel].iter_mut().zip(&slopes.rows).for_each(|(own, row)| *own = row[at]);
        own[channel] = inverse.map(|line| product(&line, &rows[channel]));
        differences[channel] = slopes.residuals[at];
        for other in 0..=channel {
            left[channel][other] = -product(&own[channel], &rows[other]);
            left[other][channel] = left[channel][other];
        }
        left[channel][channel] = (1.0 + left[channel][channel] - leverages[at]).max(LEAST_LEFT);
        count += 1;
    }
    solve(&mut left, &mut differences[..count]);
    let sum = |i: usize| own.iter().zip(&differences).map(|(own, difference)| own[i] * difference).sum();
    core::array::from_fn(sum)
}

fn product(a: &Tints, b: &Tints) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
