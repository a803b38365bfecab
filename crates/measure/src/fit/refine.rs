//! The last digits, with all readings, and standard errors.
//!
//! K. Levenberg 1944 and D. Marquardt 1963, on the differences of g with the best tints at each point: G. H. Golub and
//! V. Pereyra, "The differentiation of pseudo-inverses and nonlinear least squares problems whose variables separate",
//! SIAM J. Numer. Anal. 10, 1973.

use super::FitError;
use super::blocks::{self, dot};
use super::problem::{AT_BOUND, Columns, Problem, slices};
use super::solve::Solved;
use super::tints::{MOST, Normal, Tints};

/// Steps, at most.
const MOST_STEPS: usize = 30;
/// Slopes are taken over this, in logarithms.
const STEP: f64 = 1e-3;
/// A step that lowers it by less than this part is the last: the next would be a hundredth of it.
const LAST_STEP: f64 = 1e-7;
/// Where a step would lower the sum of squares by less than this part, the search ends.
const LAST_GAIN: f64 = 1e-11;

/// A parameter with less than this part of the greatest curvature changes nothing.
const LEAST_CURVATURE: f64 = 1e-12;
/// A parameter that may be e times as great or small is not known.
const MOST_ERROR: f64 = 1.0;

/// Parameters that can be searched at once.
pub(super) const MOST_PARAMETERS: usize = MOST;

/// The best point.
pub(super) struct Refined {
    pub point: Vec<f64>,
    /// The standard error of each number of the point; none where it cannot be told.
    pub errors: Vec<Option<f64>>,
    /// The tints there.
    pub tints: Vec<Tints>,
    squares: f64,
}

impl Problem<'_> {
    /// The best of what is found from several points, of which there is one.
    pub(super) fn refine_best(
        &mut self,
        starts: &[Vec<f64>],
        near: Option<&[Tints]>,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Refined, FitError> {
        let count = starts.len() as f64;
        let mut best = self.refine(&starts[0], near, &mut |part| progress(part / count))?;
        for (done, start) in starts.iter().enumerate().skip(1) {
            self.forget();
            let refined = self.refine(start, None, &mut |part| progress((done as f64 + part) / count))?;
            if refined.squares < best.squares {
                best = refined;
            }
        }
        Ok(best)
    }

    /// The least sum of squares near a point, where the tints may be known about.
    fn refine(
        &mut self,
        start: &[f64],
        near: Option<&[Tints]>,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Refined, FitError> {
        let mut point = self.clamped(start);
        let mut damping = 1e-4;
        let mut here = self.solved(&point, near)?;
        if point.is_empty() {
            return Ok(Refined { point, errors: Vec::new(), tints: here.0.tints, squares: here.0.squares });
        }
        let mut slopes = self.slopes(&point, &here)?;
        for step in 0..MOST_STEPS {
            // Most end after few steps: each takes a fourth of what is left.
            progress(1.0 - libm::pow(0.75, step as f64));
            let (next, expected) = self.step(&point, &slopes, damping);
            if expected < LAST_GAIN * here.0.squares {
                break;
            }
            let found = self.solved(&next, Some(&here.0.tints))?;
            if found.0.squares < here.0.squares {
                (point, here) = (next, found);
                if expected < LAST_STEP * here.0.squares {
                    break;
                }
                damping *= 0.1;
                slopes = self.slopes(&point, &here)?;
            } else if damping > 1e6 {
                break;
            } else {
                damping = 10.0 * damping.max(1e-3);
            }
        }
        let errors = self.errors(&point, &slopes, here.0.squares);
        Ok(Refined { point, errors, tints: here.0.tints, squares: here.0.squares })
    }

    /// The products of the slopes of all differences with each other, and with the differences, at a point with its tints.
    fn slopes(
        &mut self,
        point: &[f64],
        (solved, columns): &(Solved, Vec<Columns>),
    ) -> Result<Normal, FitError> {
        let residuals = self.solver().residuals(&slices(columns), &solved.tints);
        let mut rows = Vec::with_capacity(point.len());
        for (i, [_, high]) in self.ranges().into_iter().enumerate() {
            let step = if point[i] + STEP > high { -STEP } else { STEP };
            let mut moved = point.to_vec();
            moved[i] += step;
            let (at_moved, columns) = self.solved(&moved, Some(&solved.tints))?;
            let at_moved = self.solver().residuals(&slices(&columns), &at_moved.tints);
            rows.push(blocks::fill(residuals.len(), |range, out| {
                for (out, k) in out.iter_mut().zip(range) {
                    *out = (residuals[k] - at_moved[k]) / step;
                }
            }));
        }
        let parts = blocks::map(residuals.len(), |range| {
            let mut part = Normal::new(rows.len());
            for (i, row) in rows.iter().enumerate() {
                part.products[i] = dot(&row[range.clone()], &residuals[range.clone()]);
                for (j, other) in rows[..=i].iter().enumerate() {
                    part.matrix[i][j] = dot(&row[range.clone()], &other[range.clone()]);
                }
            }
            part
        });
        let mut all = Normal::new(rows.len());
        parts.iter().for_each(|part| all.add(part));
        Ok(all)
    }

    /// The next point, and by how much it should lower the sum of squares. Parameters at an end of their range that would
    /// leave it stay.
    fn step(&self, point: &[f64], slopes: &Normal, damping: f64) -> (Vec<f64>, f64) {
        let mut damped = *slopes;
        let most = (0..point.len()).map(|i| slopes.matrix[i][i]).fold(0.0, f64::max);
        for i in 0..point.len() {
            damped.matrix[i][i] += damping * (slopes.matrix[i][i] + 1e-9 * most);
        }
        let mut chosen = 0;
        for (i, [low, high]) in self.ranges().into_iter().enumerate() {
            let outward = slopes.products[i] > 0.0;
            let stays = if outward { point[i] >= high } else { point[i] <= low };
            chosen |= usize::from(!stays) << i;
        }
        let Some(step) = damped.solve_for(chosen) else { return (point.to_vec(), 0.0) };
        let moved: Vec<f64> = point.iter().zip(step).map(|(x, step)| x + step.clamp(-1.0, 1.0)).collect();
        let expected = (0..point.len()).map(|i| step[i] * slopes.products[i]).sum();
        (self.clamped(&moved), expected)
    }

    /// Standard errors, from the curvature of the sum of squares about its least, whose tints follow: that of the profile.
    /// Parameters at an end of their range are fixed there, and those of lobes that are not there say nothing.
    fn errors(&self, point: &[f64], slopes: &Normal, squares: f64) -> Vec<Option<f64>> {
        let samples = self.solver().samples();
        let columns: usize = self.lobes().iter().map(|lobe| lobe.columns()).sum();
        let numbers = point.len() + columns * samples.values.len();
        let count = samples.len() * samples.values.len();
        let variance = squares / count.saturating_sub(numbers).max(1) as f64;
        let most = (0..point.len()).map(|i| slopes.matrix[i][i]).fold(0.0, f64::max);
        let mut chosen = 0;
        for (i, [low, high]) in self.ranges().into_iter().enumerate() {
            let is_inside = point[i] - low > AT_BOUND && high - point[i] > AT_BOUND;
            chosen |= usize::from(is_inside && slopes.matrix[i][i] > LEAST_CURVATURE * most) << i;
        }
        let error = |i: usize| {
            let inverse = slopes.inverse_at(i, chosen).filter(|_| chosen >> i & 1 == 1)?;
            Some((variance * inverse).sqrt()).filter(|error| *error < MOST_ERROR)
        };
        (0..point.len()).map(error).collect()
    }
}
