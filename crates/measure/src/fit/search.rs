//! The search for where to begin: a grid, and from its best points the simplex, with a part of the readings.

use super::FitError;
use super::lobe::FitLobe;
use super::metric::Metric;
use super::problem::{Problem, has_grain};
use super::samples::Samples;

/// Steps of the grid, by how many parameters are searched.
const GRID: [usize; 6] = [1, 14, 9, 6, 4, 3];
/// Starts of the simplex, at most: the best of the grid that are no neighbours, for those lead to the same end.
const STARTS: usize = 3;
/// A start with so many times the least sum of squares is none.
const WORST_START: f64 = 4.0;
/// An end with so many times the least sum of squares is none.
const WORST_END: f64 = 1.05;
/// Steps of one simplex.
const MOST_STEPS: usize = 200;
/// The simplex ends where its corners are this near to each other; the last digits are found with all readings.
const SIZE: f64 = 3e-3;
/// Halves of the logarithm of the quotient of two widths that are tried, and azimuths of the grain.
const STRETCHES: [f64; 2] = [0.3, 0.8];
const AZIMUTHS: usize = 6;

/// A corner of a simplex: the sum of squares there, and the point.
type Corner = (f64, Vec<f64>);

/// Where the search ended, the best first, and how often shapes were evaluated.
pub(super) struct Found {
    pub ends: Vec<Vec<f64>>,
    pub evaluations: usize,
}

/// The best points, roughly.
pub(super) fn search(samples: &Samples, lobes: &[FitLobe], metric: Metric) -> Result<Found, FitError> {
    let equal: Vec<FitLobe> = lobes.iter().map(FitLobe::isotropic).collect();
    let isotropic = search_isotropic(samples, &equal, metric)?;
    if !has_grain(lobes) {
        return Ok(isotropic);
    }
    let starts = stretched(lobes, &isotropic.ends[0]);
    let mut problem = Problem::new(samples, lobes, metric);
    let ends = problem.ends_of(starts, &vec![0.0; problem.ranges().len()])?;
    Ok(Found { ends, evaluations: isotropic.evaluations + problem.evaluations() })
}

/// The same with equal widths. Beside the grid the search begins with the best of a lobe less, and that lobe anywhere: so more
/// lobes are never worse than fewer.
fn search_isotropic(samples: &Samples, lobes: &[FitLobe], metric: Metric) -> Result<Found, FitError> {
    let mut problem = Problem::new(samples, lobes, metric);
    let (mut starts, mut evaluations) = (grid(&problem), 0);
    let searched: Vec<usize> = (0..lobes.len()).filter(|i| !lobes[*i].searched.is_empty()).collect();
    if let [_, .., last] = searched[..] {
        let fewer = [&lobes[..last], &lobes[last + 1..]].concat();
        let found = search_isotropic(samples, &fewer, metric)?;
        starts.extend(with_another(lobes, last, &found.ends[0]));
        evaluations += found.evaluations;
    }
    let ranges = problem.ranges();
    let apart = |[low, high]: &[f64; 2]| 1.5 * (high - low) / steps(ranges.len()) as f64;
    let apart: Vec<f64> = ranges.iter().map(apart).collect();
    let ends = problem.ends_of(starts, &apart)?;
    Ok(Found { ends, evaluations: evaluations + problem.evaluations() })
}

/// The point of all lobes but one, and that one anywhere in its ranges.
fn with_another(lobes: &[FitLobe], number: usize, others: &[f64]) -> Vec<Vec<f64>> {
    let place: usize = lobes[..number].iter().map(|lobe| lobe.searched.len()).sum();
    let with_part = |part: f64| {
        let own = lobes[number].searched.iter().map(|searched| {
            let [low, high] = searched.range;
            low + (high - low) * part
        });
        [&others[..place], &own.collect::<Vec<_>>(), &others[place..]].concat()
    };
    (0..GRID[1]).map(|k| with_part((k as f64 + 0.5) / GRID[1] as f64)).collect()
}

/// Steps of the grid for so many parameters.
fn steps(parameters: usize) -> usize {
    GRID.get(parameters).copied().unwrap_or(2)
}

/// Points at even logarithms; of lobes that are the same each set of widths once.
fn grid(problem: &Problem) -> Vec<Vec<f64>> {
    let owners = problem.lobes().iter().flat_map(|lobe| lobe.searched.iter().map(move |_| lobe));
    let owners: Vec<&FitLobe> = owners.collect();
    let is_again = |i: usize, j: usize| owners[i].searched.len() == 1 && owners[i] == owners[j];
    let ranges = problem.ranges();
    let steps = steps(ranges.len());
    let mut points: Vec<Vec<f64>> = vec![Vec::new()];
    for (i, [low, high]) in ranges.into_iter().enumerate() {
        let values = (0..steps).map(|k| low + (high - low) * (k as f64 + 0.5) / steps as f64);
        let values: Vec<f64> = values.collect();
        points = points
            .into_iter()
            .flat_map(|point| values.iter().map(move |x| [&point[..], &[*x]].concat()))
            .filter(|point| (0..i).all(|j| !is_again(i, j) || point[j] < point[i]))
            .collect();
    }
    points
}

/// Points with widths that differ, about one where they are equal.
fn stretched(lobes: &[FitLobe], isotropic: &[f64]) -> Vec<Vec<f64>> {
    let mut points = Vec::new();
    for stretch in STRETCHES {
        for step in 0..AZIMUTHS {
            let (mut point, mut rest) = (Vec::new(), isotropic.iter());
            for lobe in lobes {
                for searched in &lobe.searched {
                    let x = rest.next().copied().unwrap_or(0.0);
                    let is_width = lobe.across.is_some_and(|across| across.range == searched.range);
                    point.push(if is_width { x - stretch } else { x });
                }
                point.extend(lobe.across.map(|_| point[point.len() - 1] + 2.0 * stretch));
            }
            point.push(core::f64::consts::PI * step as f64 / AZIMUTHS as f64);
            points.push(point);
        }
    }
    points
}

fn are_near(a: &[f64], b: &[f64], apart: &[f64]) -> bool {
    apart.iter().zip(a.iter().zip(b)).all(|(apart, (a, b))| (a - b).abs() < *apart)
}

/// The best of these, and those that may be better with all readings.
fn distinct(mut ends: Vec<Corner>) -> Vec<Vec<f64>> {
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let worst = WORST_END * ends[0].0;
    let mut kept: Vec<Vec<f64>> = Vec::new();
    for (squares, end) in ends {
        let is_known = kept.iter().any(|other| are_near(other, &end, &vec![10.0 * SIZE; end.len()]));
        if kept.is_empty() || squares < worst && !is_known {
            kept.push(end);
        }
    }
    kept
}

impl Problem<'_> {
    /// Where the simplex ends that begins at the best of these, of which two are neighbours where all numbers are less than
    /// this apart. The best comes first; ends that are much worse, or the same, are left out.
    fn ends_of(&mut self, starts: Vec<Vec<f64>>, apart: &[f64]) -> Result<Vec<Vec<f64>>, FitError> {
        let mut all: Vec<Corner> = Vec::new();
        for point in starts {
            let point = self.clamped(&point);
            all.push((self.squares(&point)?, point));
        }
        self.forget();
        if apart.is_empty() {
            return Ok(vec![Vec::new()]);
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let least = all[0].0;
        let mut starts: Vec<Vec<f64>> = Vec::new();
        for (squares, start) in all {
            let is_known = starts.iter().any(|other| are_near(other, &start, apart));
            if starts.is_empty() || starts.len() < STARTS && squares < WORST_START * least && !is_known {
                starts.push(start);
            }
        }
        let mut ends = Vec::new();
        for start in starts {
            let (squares, end) = self.simplex(start)?;
            ends.push((squares, self.clamped(&end)));
            self.forget();
        }
        Ok(distinct(ends))
    }

    /// J. Nelder and R. Mead 1965, in the logarithms of the widths.
    fn simplex(&mut self, start: Vec<f64>) -> Result<Corner, FitError> {
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
            if sizes.fold(0.0, f64::max) < SIZE {
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
}
