//! The sum of squares as a function of the parameters that are searched.

use std::collections::HashMap;
use std::rc::Rc;

use super::errors::Errors;
use super::lobe::FitLobe;
use super::metric::Metric;
use super::samples::Samples;
use super::solve::{Solved, Solver};
use super::tints::Tints;
use super::{Fit, FitError, FittedLobe, FittedParameter};

/// The columns of a lobe, one for each of its tints.
pub(super) type Columns = Rc<Vec<Vec<f64>>>;

/// Readings, lobes and a metric. A point is the logarithms of all parameters that are searched, lobe by lobe, and then the
/// azimuth of the grain if a lobe is anisotropic.
pub(super) struct Problem<'a> {
    solver: Solver<'a>,
    lobes: &'a [FitLobe],
    /// Columns by lobe and the bits of what is searched of it.
    known: HashMap<(usize, Vec<u64>), Columns>,
    evaluations: usize,
}

/// A value at the end of its range is this near to it, in logarithms.
pub(super) const AT_BOUND: f64 = 1e-3;

/// Columns that are kept, at most this many numbers.
const MOST_KNOWN: usize = 8 << 20;

impl<'a> Problem<'a> {
    pub(super) fn new(samples: &'a Samples, lobes: &'a [FitLobe], metric: Metric) -> Self {
        Self { solver: Solver::new(samples, metric), lobes, known: HashMap::new(), evaluations: 0 }
    }

    /// How often shapes were evaluated.
    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    pub(super) fn lobes(&self) -> &'a [FitLobe] {
        self.lobes
    }

    pub(super) fn solver(&self) -> &Solver<'a> {
        &self.solver
    }

    /// The ranges of the numbers of a point. An azimuth has none.
    pub(super) fn ranges(&self) -> Vec<[f64; 2]> {
        let all = self.lobes.iter().flat_map(|lobe| lobe.searched.iter().chain(&lobe.across));
        let azimuth = has_grain(self.lobes).then_some([f64::NEG_INFINITY, f64::INFINITY]);
        all.map(|searched| searched.range).chain(azimuth).collect()
    }

    /// The point within the ranges.
    pub(super) fn clamped(&self, point: &[f64]) -> Vec<f64> {
        point.iter().zip(self.ranges()).map(|(x, [low, high])| x.clamp(low, high)).collect()
    }

    /// The sum of squares at a point.
    pub(super) fn squares(&mut self, point: &[f64]) -> Result<f64, FitError> {
        Ok(self.solved(point, None)?.0.squares)
    }

    /// The best tints at a point, sooner found if some near to them are known, and the columns there.
    pub(super) fn solved(
        &mut self,
        point: &[f64],
        near: Option<&[Tints]>,
    ) -> Result<(Solved, Vec<Columns>), FitError> {
        let point = self.clamped(point);
        let all = self.columns(&point)?;
        Ok((self.solver.solve(&slices(&all), near), all))
    }

    /// Forgets columns, which are of no use far from where they were made.
    pub(super) fn forget(&mut self) {
        self.known.clear();
    }

    /// The columns at a point, lobe by lobe.
    pub(super) fn columns(&mut self, point: &[f64]) -> Result<Vec<Columns>, FitError> {
        let samples = self.solver.samples();
        if self.known.len() * samples.len() > MOST_KNOWN {
            self.forget();
        }
        let (mut place, azimuth) = (0, azimuth(self.lobes, point));
        let mut all = Vec::with_capacity(self.lobes.len());
        for (number, lobe) in self.lobes.iter().enumerate() {
            let count = lobe.parameters().count();
            let values = &point[place..place + count];
            let reads_tangent = lobe.across.is_some() || lobe.shape.is_anisotropic();
            let turn = if reads_tangent { azimuth } else { 0.0 };
            place += count;
            let key = (number, values.iter().chain([&turn]).map(|x| x.to_bits()).collect());
            if let Some(known) = self.known.get(&key) {
                all.push(Rc::clone(known));
                continue;
            }
            let column = samples.column(&shape(lobe, values)?, turn);
            let columns =
                Rc::new(if lobe.is_schlick { samples.schlick(&column).into() } else { vec![column] });
            self.evaluations += 1;
            self.known.insert(key, Rc::clone(&columns));
            all.push(columns);
        }
        Ok(all)
    }

    /// The fit at a point, where the tints may be known about.
    pub(super) fn fit_at(
        &mut self,
        point: &[f64],
        errors: &Errors,
        near: Option<&[Tints]>,
    ) -> Result<Fit, FitError> {
        let point = self.clamped(point);
        let solved = self.solved(&point, near)?.0;
        self.fit_of(&point, errors, &solved)
    }

    /// The fit that a point with its tints is.
    pub(super) fn fit_of(&self, point: &[f64], errors: &Errors, solved: &Solved) -> Result<Fit, FitError> {
        let (samples, whole) = (self.solver.samples(), self.solver.whole());
        if whole <= 0.0 || solved.tints.iter().flatten().all(|tint| *tint <= 0.0) {
            return Err(FitError::Nothing("all values are 0 or below".to_owned()));
        }
        let (mut place, mut column) = (0, 0);
        let mut lobes = Vec::new();
        for lobe in self.lobes {
            let count = lobe.parameters().count();
            let range = place..place + count;
            let tint = |column: usize| solved.tints.iter().map(|tint| tint[column]).collect();
            lobes.push(FittedLobe {
                shape: shape(lobe, &point[range.clone()])?,
                parameters: parameters(lobe, &point[range.clone()], &errors.of[range]),
                tint: tint(column),
                tint_at_grazing: lobe.is_schlick.then(|| tint(column + 1)),
            });
            (place, column) = (place + count, column + lobe.columns());
        }
        let weights = samples.weights.iter().sum::<f64>() * samples.values.len() as f64;
        Ok(Fit {
            lobes,
            aniso_deg: has_grain(self.lobes)
                .then(|| azimuth(self.lobes, point).to_degrees().rem_euclid(180.0)),
            isotropic_error: None,
            error_estimate: errors.estimate,
            error: (solved.squares / weights).sqrt(),
            relative: (solved.squares / whole).sqrt(),
            readings: samples.len(),
            evaluations: self.evaluations,
        })
    }
}

/// Whether the direction of the grain is searched.
pub(super) fn has_grain(lobes: &[FitLobe]) -> bool {
    lobes.iter().any(|lobe| lobe.across.is_some())
}

fn azimuth(lobes: &[FitLobe], point: &[f64]) -> f64 {
    point.last().copied().filter(|_| has_grain(lobes)).unwrap_or(0.0)
}

/// All columns, one after the other.
pub(super) fn slices(columns: &[Columns]) -> Vec<&[f64]> {
    columns.iter().flat_map(|columns| columns.iter().map(|column| &column[..])).collect()
}

/// A lobe's shape at the logarithms of its parameters.
fn shape(lobe: &FitLobe, point: &[f64]) -> Result<glanz_bsdf::Shape, FitError> {
    let mut shape = lobe.shape.clone();
    for ((name, x), value) in lobe.parameters().zip(point).zip(values(lobe, point)) {
        debug_assert!(x.is_finite());
        shape = shape.with(name, value).map_err(|error| FitError::Model(error.to_string()))?;
    }
    Ok(shape)
}

/// The parameters at their logarithms, within the ranges that the shape allows.
fn values(lobe: &FitLobe, point: &[f64]) -> Vec<f64> {
    let params = lobe.shape.info().params;
    let value = |(name, x): (&str, &f64)| {
        let value = libm::exp(*x);
        params
            .iter()
            .find(|param| param.name == name)
            .map_or(value, |param| value.clamp(param.min, param.max))
    };
    lobe.parameters().zip(point).map(value).collect()
}

fn parameters(lobe: &FitLobe, point: &[f64], errors: &[Option<f64>]) -> Vec<FittedParameter> {
    let searched = lobe.searched.iter().chain(&lobe.across);
    let all = searched.zip(point).zip(values(lobe, point)).zip(errors);
    all.map(|(((searched, x), value), error)| {
        let [low, high] = searched.range;
        let at_bound = x - low < AT_BOUND || high - x < AT_BOUND;
        FittedParameter { name: searched.name, value, log_error: error.filter(|_| !at_bound), at_bound }
    })
    .collect()
}
