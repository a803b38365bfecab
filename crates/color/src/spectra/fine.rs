//! Spectra at 1 nm, for numbers: what is told of a spectrum is summed at the resolution at which it is known.

use core::iter::Sum;
use core::ops::{Add, Mul};

use super::interpolate::Smooth;
use super::resample::{Curve, Grid, Outside, TableError, check};
use super::spectrum::{FIRST_NM, LAST_NM, SAMPLES, Spectrum, lambda_nm};

/// The last wavelength of a fine spectrum, in nm: that of the colour-matching functions.
pub const FINE_LAST_NM: f64 = 830.0;

/// The number of wavelengths of a fine spectrum, 1 nm apart.
pub const FINE_SAMPLES: usize = 531;

const GRID: Grid = Grid { first: FIRST_NM, last: FINE_LAST_NM, step: 1.0, samples: FINE_SAMPLES };

/// A function of wavelength for numbers: 531 values at 300, 301 … 830 nm.
///
/// Pictures are drawn with [`Spectrum`], by 5 nm; numbers of a spectrum are summed with this. What it holds of a table:
///
/// * **steps of 1 nm**: its values;
/// * **finer steps**: means under triangles of 1 nm, so that a sum with an observer is the integral of the table with the
///   observer's values interpolated to the table's wavelengths;
/// * **coarser, equal steps** (2, 5, 10, 20 nm …; [`FineSpectrum::interpolated`] can take lines instead): Sprague's interpolation (CIE 167:2005). Sums of a smooth curve are those of
///   the table at its own steps to about 1e-5, also for lamps with lines. Between lines it swings, so values below 0 are
///   possible;
/// * **coarser, unequal steps**: Lagrange's cubics, and lines beside gaps.
///
/// ```
/// use glanz_color::chromaticity::Chromaticity;
/// use glanz_color::{FineSpectrum, Outside, light};
///
/// // A narrow band, measured by 1 nm: on the grid for drawing it is wider.
/// let nm: Vec<f64> = (440..=470).map(f64::from).collect();
/// let values: Vec<f64> = nm.iter().map(|nm| 1.0 - (nm - 455.0).abs() / 15.0).collect();
/// let fine = FineSpectrum::from_table(&nm, &values, Outside::Zero)?;
/// assert!(fine.at(455.0) == 1.0 && (fine.integral() - 15.0).abs() < 1e-12);
/// assert!(fine.drawn(Outside::Zero).at(455.0) < 0.95);
/// # Ok::<_, glanz_color::TableError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FineSpectrum(Vec<f64>);

/// What joins the values of a table that are more than 1 nm apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    Lines,
    /// Sprague's polynomials (CIE 167:2005) for equal steps, Lagrange's cubics for others.
    Smooth,
}

impl FineSpectrum {
    /// The function of the wavelength in nm.
    pub fn from_fn(f: impl FnMut(f64) -> f64) -> Self {
        Self(fine_nm().map(f).collect())
    }

    /// The curve of a table; how, the type's page says.
    ///
    /// # Errors
    ///
    /// [`TableError`] says which wavelength or value is not possible.
    pub fn from_table(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        Self::interpolated(nm, values, outside, Interpolation::Smooth)
    }

    /// The curve of a table, whose values are joined in this way where they are more than 1 nm apart.
    ///
    /// # Errors
    ///
    /// [`TableError`] says which wavelength or value is not possible.
    pub fn interpolated(
        nm: &[f64],
        values: &[f64],
        outside: Outside,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        check(nm, values)?;
        let curve = Curve { nm, values, outside };
        let mean_step = (curve.last().0 - curve.first().0) / (nm.len() - 1) as f64;
        if mean_step > 1.0 {
            if interpolation == Interpolation::Lines {
                return Ok(Self::from_fn(|nm| curve.at(nm)));
            }
            let smooth = Smooth::of(curve);
            return Ok(Self::from_fn(|nm| smooth.at(nm)));
        }
        // A table with holes between whole nm is a line over them.
        match nm.iter().all(|nm| nm.fract() == 0.0) {
            true => Ok(Self::from_fn(|nm| curve.at(nm))),
            false => Ok(Self(curve.projected(&GRID))),
        }
    }

    /// Light that consists of lines: pairs of a wavelength in nm and a power, each shared by the two samples around it.
    ///
    /// # Errors
    ///
    /// [`TableError`] says which line's wavelength or power is not possible.
    pub fn from_lines(lines: &[(f64, f64)]) -> Result<Self, TableError> {
        GRID.lines(lines).map(Self)
    }

    /// A spectrum that is known on the grid for drawing only, by Sprague's interpolation.
    pub fn from_drawn(spectrum: &Spectrum, outside: Outside) -> Self {
        let nm: [f64; SAMPLES] = core::array::from_fn(lambda_nm);
        let smooth = Smooth::of(Curve { nm: &nm, values: &spectrum.0, outside });
        Self::from_fn(|nm| smooth.at(nm))
    }

    /// The spectrum as it is drawn: by 5 nm, means under triangles.
    pub fn drawn(&self, outside: Outside) -> Spectrum {
        let nm: Vec<f64> = fine_nm().collect();
        Spectrum::from_table(&nm, &self.0, outside).expect("a fine spectrum is a table of finite values")
    }

    /// The value at a wavelength in nm, linear between samples; 0 outside.
    pub fn at(&self, nm: f64) -> f64 {
        let position = nm - FIRST_NM;
        if !(0.0..=(FINE_SAMPLES - 1) as f64).contains(&position) {
            return 0.0;
        }
        let left = (position as usize).min(FINE_SAMPLES - 2);
        self.0[left] + (self.0[left + 1] - self.0[left]) * (position - left as f64)
    }

    /// The values, from 300 nm on.
    pub fn values(&self) -> &[f64] {
        &self.0
    }

    /// Wavelength in nm and value, in order.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        fine_nm().zip(self.0.iter().copied())
    }

    /// ∫ over 300 to 780 nm, in the unit of the values times nm.
    pub fn integral(&self) -> f64 {
        self.points().take_while(|(nm, _)| *nm <= LAST_NM).map(|(_, value)| value).sum()
    }

    /// ∫ of the product of both, from 300 to 830 nm.
    pub fn dot(&self, other: &Self) -> f64 {
        self.0.iter().zip(&other.0).map(|(a, b)| a * b).sum()
    }

    /// The greatest value.
    pub fn max(&self) -> f64 {
        self.0.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same within these wavelengths in nm, 0 outside of them.
    pub fn within(&self, nm: core::ops::RangeInclusive<f64>) -> Self {
        Self(self.points().map(|(at, value)| if nm.contains(&at) { value } else { 0.0 }).collect())
    }
}

/// The wavelengths in nm.
fn fine_nm() -> impl Iterator<Item = f64> {
    (0..FINE_SAMPLES).map(|i| FIRST_NM + i as f64)
}

impl Mul<f64> for FineSpectrum {
    type Output = Self;
    fn mul(mut self, factor: f64) -> Self {
        self.0.iter_mut().for_each(|value| *value *= factor);
        self
    }
}

impl Mul for &FineSpectrum {
    type Output = FineSpectrum;
    fn mul(self, other: Self) -> FineSpectrum {
        FineSpectrum(self.0.iter().zip(&other.0).map(|(a, b)| a * b).collect())
    }
}

impl Add for FineSpectrum {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a += b);
        self
    }
}

impl Sum for FineSpectrum {
    fn sum<I: Iterator<Item = Self>>(spectra: I) -> Self {
        spectra.fold(Self(vec![0.0; FINE_SAMPLES]), Add::add)
    }
}

#[cfg(test)]
mod tests;
