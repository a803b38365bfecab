//! The last digits, with all readings.
//!
//! K. Levenberg 1944 and D. Marquardt 1963, on the differences of g with the best tints at each point: G. H. Golub and
//! V. Pereyra, "The differentiation of pseudo-inverses and nonlinear least squares problems whose variables separate",
//! SIAM J. Numer. Anal. 10, 1973.

use super::FitError;
use super::blocks::{self, dot};
use super::errors::Errors;
use super::problem::{Columns, Problem, slices};
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

/// Parameters that can be searched at once.
pub(super) const MOST_PARAMETERS: usize = MOST;

/// The best point.
pub(super) struct Refined {
    pub point: Vec<f64>,
    /// Of its numbers.
    pub errors: Errors,
    /// The tints there.
    pub tints: Vec<Tints>,
    squares: f64,
}

/// Slopes of all differences at a point.
pub(super) struct Slopes {
    /// Their products with each other, and with the differences.
    pub normal: Normal,
    /// For each number of the point, channel by channel as the differences are.
    pub rows: Vec<Vec<f64>>,
    /// The differences.
    pub residuals: Vec<f64>,
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
            return Ok(Refined {
                point,
                errors: Errors::default(),
                tints: here.0.tints,
                squares: here.0.squares,
            });
        }
        let mut slopes = self.slopes(&point, &here)?;
        for step in 0..MOST_STEPS {
            // Most end after few steps: each takes a fourth of what is left.
            progress(1.0 - libm::pow(0.75, step as f64));
            let (next, expected) = self.step(&point, &slopes.normal, damping);
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
        let errors = self.errors(&point, &slopes, &here);
        Ok(Refined { point, errors, tints: here.0.tints, squares: here.0.squares })
    }

    /// The slopes of all differences at a point with its tints.
    fn slopes(
        &mut self,
        point: &[f64],
        (solved, columns): &(Solved, Vec<Columns>),
    ) -> Result<Slopes, FitError> {
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
        let mut normal = Normal::new(rows.len());
        parts.iter().for_each(|part| normal.add(part));
        Ok(Slopes { normal, rows, residuals })
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
}
