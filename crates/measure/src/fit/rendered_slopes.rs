//! Slopes of differences of colour.

use core::f64::consts::PI;

use super::FitError;
use super::dense::Dense;
use super::problem::{Problem, slices};
use super::rendered::{Seen, sum};
use crate::fit::blocks;

/// Slopes along parameters are taken over this, in logarithms.
const STEP: f64 = 1e-3;
/// Slopes along X, Y and Z are taken over this part of the greatest of them, and of this number.
const XYZ_STEP: f64 = 1e-6;
const LEAST_XYZ: f64 = 1e-3;

/// A point of the search, with its columns and what is seen of their tints.
pub(super) struct Place<'a> {
    pub point: &'a [f64],
    pub columns: &'a [&'a [f64]],
    pub tints: &'a [[f64; 3]],
}

impl Place<'_> {
    /// Sums of products of the slopes of all differences with each other, and with the differences: along the parameters, and
    /// along the tints, column by column and of each direction by direction.
    pub(super) fn slopes(&self, seen: &Seen, problem: &mut Problem) -> Result<Dense, FitError> {
        let moved = self.moved(problem)?;
        // What is seen of a step along each direction.
        let seen_steps: Vec<[f64; 3]> = seen
            .directions
            .iter()
            .map(|direction| seen.viewing.xyz(direction.iter().map(|along| PI * along)))
            .collect();
        let size = self.point.len() + self.columns.len() * seen_steps.len();
        let parts = blocks::map(seen.samples.len(), |range| {
            let mut sums = Dense::new(size);
            let mut rows = [(); 3].map(|()| Vec::with_capacity(size));
            for i in range {
                let xyz = sum(self.columns, self.tints, i);
                let (here, jacobian) = jacobian(seen, i, xyz);
                for (row, slope) in rows.iter_mut().zip(&jacobian) {
                    let along = |to: &[f64; 3]| slope.iter().zip(to).map(|(a, b)| a * b).sum::<f64>();
                    row.clear();
                    row.extend(moved.iter().map(|to| along(&to[i])));
                    let steps = seen_steps.iter().map(along).collect::<Vec<_>>();
                    for column in self.columns {
                        row.extend(steps.iter().map(|step| step * column[i]));
                    }
                }
                for (row, difference) in rows.iter().zip(here) {
                    sums.add_row(seen.samples.weights[i], row, -difference);
                }
            }
            sums
        });
        let mut all = Dense::new(size);
        parts.iter().for_each(|part| all.add(part));
        Ok(all)
    }

    /// For each parameter the slopes of X, Y and Z of all readings along it.
    fn moved(&self, problem: &mut Problem) -> Result<Vec<Vec<[f64; 3]>>, FitError> {
        let mut all = Vec::with_capacity(self.point.len());
        for (i, [_, high]) in problem.ranges().into_iter().enumerate() {
            let step = if self.point[i] + STEP > high { -STEP } else { STEP };
            let mut point = self.point.to_vec();
            point[i] += step;
            let columns = problem.columns(&problem.clamped(&point))?;
            let columns = slices(&columns);
            let slope = |k: usize| {
                let (there, here) = (sum(&columns, self.tints, k), sum(self.columns, self.tints, k));
                core::array::from_fn(|c| (there[c] - here[c]) / step)
            };
            all.push((0..self.columns.first().map_or(0, |column| column.len())).map(slope).collect());
        }
        Ok(all)
    }
}

/// The components of the difference of a reading from X, Y and Z, and for each its slopes along them.
fn jacobian(seen: &Seen, i: usize, xyz: [f64; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let here = seen.components(i, xyz);
    let step = XYZ_STEP * xyz.into_iter().fold(LEAST_XYZ, f64::max);
    let mut slopes = [[0.0; 3]; 3];
    for c in 0..3 {
        let mut moved = xyz;
        moved[c] += step;
        let there = seen.components(i, moved);
        (0..3).for_each(|k| slopes[k][c] = (there[k] - here[k]) / step);
    }
    (here, slopes)
}
