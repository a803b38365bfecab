//! Re-radiation as an instrument measures it, carried over to the grid.
//!
//! An instrument with bands of width b gives for every pair of wavelengths the fraction of the light that
//! leaves within b around `out`. Two things of different kinds are in such a matrix, and they are
//! resampled differently:
//!
//! * *The diagonal* is the light that keeps its wavelength: a reflectance, a ratio that does not depend
//!   on b. It is interpolated as any reflectance.
//! * *All else* is emission: a density in `out`, times b. It is interpolated as a density and then
//!   multiplied with the 5 nm of the grid, so a matrix of 10 nm gives entries half as great, twice as
//!   many.
//!
//! What a material emits within the very band that excites it cannot be told from reflection by such an
//! instrument. It stays with the diagonal, so the emission is taken to be 0 on it. What the interpolation
//! of the neighbouring bands then puts on the diagonal of the finer grid is moved up by one sample: the
//! diagonal is the reflectance and nothing else.
//!
//! Along the emission, and for the diagonal, the interpolation is cubic, since a line between coarse
//! samples widens every peak and edge: with lines XYZ of measured materials move by up to 1.3 %. Along
//! the excitation it is linear, which shares every measured column out to the light around it with
//! weights that are never negative and sum to 1: a line of light between two measured wavelengths
//! excites by the mean of both. Where a cubic falls below 0 it is cut. Then the column is scaled to the
//! energy that was measured: the sum of all bands on the grid, each as wide as the way between the middles to
//! its neighbours, those at the ends whole, as all samples are in a sum over the grid.
//!
//! Outside of the measured wavelengths the matrix is 0: nothing is known there, so nothing is claimed.

use thiserror::Error;

use super::Reradiation;
use super::axis::{Axis, Weights};
use crate::spectra::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};

/// Measured values may be as far below 0 by noise: those of the BFC-450 reach −0.05. They are cut to 0.
const NOISE: f64 = 0.1;
/// No band can give more of the light that comes in; beyond it the values are likely per cent.
const GREATEST: f64 = 2.0;
/// Wavelengths this close are the same, in nm.
const SAME_NM: f64 = 0.01;
/// The most wavelengths of an axis: a thousand bands are more than any instrument has.
pub(crate) const MOST_BANDS: usize = 4096;

/// Why values are no re-radiation matrix.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeasuredError {
    /// An axis has no, or far too many, wavelengths.
    #[error("expected 1 to {MOST_BANDS} wavelengths of {axis}, found {found}")]
    Length {
        /// `excitation` or `emission`.
        axis: &'static str,
        /// How many there are.
        found: usize,
    },
    /// Wavelengths do not ascend, or are no positive numbers.
    #[error("expected ascending wavelengths of {axis} in nm, found {found} after {before} (number {index})")]
    Order {
        /// `excitation` or `emission`.
        axis: &'static str,
        /// Which one of the axis, counted from 1.
        index: usize,
        /// The wavelength before, in nm.
        before: f64,
        /// The wavelength, in nm.
        found: f64,
    },
    /// The number of values does not fit the axes.
    #[error("expected {expected} values, one for each emission and excitation, found {found}")]
    Count {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A value that no material has.
    #[error(
        "expected values from -0.1 to 2, as fractions of the incident light, \
         found {found} at an emission of {out_nm} nm, excitation {in_nm} nm"
    )]
    Value {
        /// The wavelength of emission, in nm.
        out_nm: f64,
        /// The wavelength of excitation, in nm.
        in_nm: f64,
        /// The value.
        found: f64,
    },
    /// The width of the bands is no positive number.
    #[error("expected the width of the emission bands as 0.1 to 100 nm, found {found}")]
    Band {
        /// The width, in nm.
        found: f64,
    },
    /// The reflectance at a wavelength of excitation is not in the matrix.
    #[error(
        "expected the excitation {in_nm} nm among the wavelengths of emission too, \
         since the reflectance stands there, found none within 0.01 nm"
    )]
    Diagonal {
        /// The wavelength of excitation, in nm.
        in_nm: f64,
    },
}

impl Reradiation {
    /// The matrix of a measurement, resampled to the grid as told at the top of this module.
    ///
    /// `values` holds a row for each wavelength of emission `out_nm`, in it a value for each of
    /// excitation `in_nm`, both ascending in nm. `band_nm` is the width of the emission band that a value
    /// stands for, as a rule the step of `out_nm`. Every excitation within the range of emission must be
    /// one of its wavelengths. Noise below 0 is cut.
    pub fn from_measured(
        out_nm: &[f64],
        in_nm: &[f64],
        values: &[f64],
        band_nm: f64,
    ) -> Result<Self, MeasuredError> {
        check_axis("emission", out_nm)?;
        check_axis("excitation", in_nm)?;
        if !(0.1..=100.0).contains(&band_nm) {
            return Err(MeasuredError::Band { found: band_nm });
        }
        check_values(out_nm, in_nm, values)?;
        let mut emission: Vec<f64> = values.iter().map(|value| value.max(0.0)).collect();
        let reflectance = take_diagonal(out_nm, in_nm, &mut emission)?;
        let columns = excite(in_nm, &emission, STEP_NM / band_nm);
        let rows: Vec<Weights> = (0..SAMPLES).map(|out| Axis::new(out_nm).cubic(lambda_nm(out))).collect();
        let widths = widths(out_nm, band_nm);
        let mut columns: Vec<[f64; SAMPLES]> =
            columns.iter().map(|column| emit(column, &rows, &widths)).collect();
        for (input, column) in columns.iter_mut().enumerate().take(SAMPLES - 1) {
            column[input + 1] += core::mem::take(&mut column[input]);
        }
        Ok(Self::from_fn(|out, input| {
            let reflected = if out == input { reflectance[out] } else { 0.0 };
            reflected + columns[input][out]
        }))
    }
}

/// Takes the diagonal out of the values and gives it on the grid.
fn take_diagonal(out_nm: &[f64], in_nm: &[f64], values: &mut [f64]) -> Result<Spectrum, MeasuredError> {
    let (first, last) = (out_nm[0] - SAME_NM, out_nm[out_nm.len() - 1] + SAME_NM);
    let (mut at, mut reflectance) = (Vec::new(), Vec::new());
    for (input, &nm) in in_nm.iter().enumerate().filter(|(_, nm)| (first..=last).contains(*nm)) {
        let out = out_nm.partition_point(|&out| out < nm - SAME_NM);
        if out == out_nm.len() || (out_nm[out] - nm).abs() > SAME_NM {
            return Err(MeasuredError::Diagonal { in_nm: nm });
        }
        at.push(nm);
        reflectance.push(core::mem::take(&mut values[out * in_nm.len() + input]));
    }
    let axis = Axis::new(&at);
    Ok(Spectrum::from_fn(|nm| sum(&axis.cubic(nm), |index| reflectance[index]).max(0.0)))
}

/// For each wavelength of the grid the emission that it excites, at the measured wavelengths of emission
/// and per band of the grid; empty where nothing was measured.
fn excite(in_nm: &[f64], emission: &[f64], scale: f64) -> Vec<Vec<f64>> {
    let axis = Axis::new(in_nm);
    let column = |input: usize| {
        let weights = axis.linear(lambda_nm(input));
        emission.chunks(in_nm.len()).map(|row| scale * sum(&weights, |index| row[index])).collect()
    };
    (0..SAMPLES).map(column).collect()
}

/// The emission at the grid's wavelengths, never below 0 and with the energy that was measured.
fn emit(column: &[f64], rows: &[Weights], widths: &[f64]) -> [f64; SAMPLES] {
    let kept: [f64; SAMPLES] = core::array::from_fn(|out| sum(&rows[out], |index| column[index]).max(0.0));
    let energy: f64 = column.iter().zip(widths).map(|(value, width)| value * width).sum();
    let total: f64 = kept.iter().sum();
    let scale = if total > 0.0 { energy / total } else { 0.0 };
    kept.map(|value| value * scale)
}

/// How wide the band of each wavelength of emission is, in samples of the grid; 0 beyond the grid.
fn widths(out_nm: &[f64], band_nm: f64) -> Vec<f64> {
    let step = |left: usize| match out_nm.get(left..left + 2) {
        Some([a, b]) => Some(b - a),
        _ => None,
    };
    let width = |(index, nm): (usize, &f64)| {
        let left = index.checked_sub(1).and_then(step).or(step(index)).unwrap_or(band_nm);
        let right = step(index).unwrap_or(left);
        if (FIRST_NM..=LAST_NM).contains(nm) { 0.5 * (left + right) / STEP_NM } else { 0.0 }
    };
    out_nm.iter().enumerate().map(width).collect()
}

fn sum(weights: &Weights, value: impl Fn(usize) -> f64) -> f64 {
    weights.iter().map(|&(index, weight)| weight * value(index)).sum()
}

fn check_axis(axis: &'static str, nm: &[f64]) -> Result<(), MeasuredError> {
    if !(1..=MOST_BANDS).contains(&nm.len()) {
        return Err(MeasuredError::Length { axis, found: nm.len() });
    }
    let mut before = 0.0;
    for (index, &found) in nm.iter().enumerate() {
        if !(found.is_finite() && found > before + SAME_NM) {
            return Err(MeasuredError::Order { axis, index: index + 1, before, found });
        }
        before = found;
    }
    Ok(())
}

fn check_values(out_nm: &[f64], in_nm: &[f64], values: &[f64]) -> Result<(), MeasuredError> {
    let expected = out_nm.len() * in_nm.len();
    if values.len() != expected {
        return Err(MeasuredError::Count { expected, found: values.len() });
    }
    match values.iter().position(|value| !(-NOISE..=GREATEST).contains(value)) {
        None => Ok(()),
        Some(place) => Err(MeasuredError::Value {
            out_nm: out_nm[place / in_nm.len()],
            in_nm: in_nm[place % in_nm.len()],
            found: values[place],
        }),
    }
}
