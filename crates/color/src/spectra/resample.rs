//! Spectra given otherwise, brought onto the grid: tables of any spacing, and lines.
//!
//! A table is read as the curve that is linear between its points. Two kinds are told apart:
//!
//! * **Points on the grid's wavelengths only** (steps of 5, 10, 20 … nm): the curve's values at the
//!   grid's wavelengths are taken. The values given are kept, and so is the integral of the curve.
//! * **All others** (1 nm, 4 nm, 383 nm and so on): each sample becomes the curve's mean, weighted with
//!   the triangle that falls from 1 at the sample to 0 at its neighbours. The triangles add up to 1
//!   everywhere, so the integral is kept to rounding, however fine or coarse the table is; constants and
//!   ramps stay what they are.
//!
//! The first and the last triangle reach 5 nm beyond the grid; a table that ends within these 5 nm, or
//! at the grid's end, is held there, so that a table from 300 to 780 nm loses nothing at its ends.

use thiserror::Error;

use crate::spectra::spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum};

/// What a table is taken to be below its first and above its last wavelength.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Nothing: for light, whose energy outside of the table is not known.
    Zero,
    /// The value at the table's end: for reflectance, η and k.
    Hold,
}

/// Why numbers are no table of a spectrum.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TableError {
    /// Not as many values as wavelengths.
    #[error("expected a value for each of {wavelengths} wavelengths, found {values} values")]
    Lengths {
        /// How many wavelengths there are.
        wavelengths: usize,
        /// How many values there are.
        values: usize,
    },
    /// Nothing to draw a line between.
    #[error("expected at least 2 wavelengths, found {found}")]
    TooShort {
        /// How many there are.
        found: usize,
    },
    /// A wavelength that is no positive number.
    #[error("expected a wavelength in nm at index {index}, found {nm}")]
    Wavelength {
        /// Which one, from 0.
        index: usize,
        /// The wavelength.
        nm: f64,
    },
    /// A wavelength that does not lie above the one before it.
    #[error("expected increasing wavelengths, found {nm} nm at index {index} after {before} nm")]
    NotIncreasing {
        /// Which one, from 0.
        index: usize,
        /// The wavelength.
        nm: f64,
        /// The one before it.
        before: f64,
    },
    /// A value that is no finite number, or so great that sums of it are none.
    #[error("expected a finite value at index {index} ({nm} nm), found {value}")]
    Value {
        /// Which one, from 0.
        index: usize,
        /// Its wavelength.
        nm: f64,
        /// The value.
        value: f64,
    },
    /// A value further below 0 than noise, where only values from 0 on mean something.
    #[error(
        "expected values of at least 0 (noise down to {least:.3e} is taken as 0), found {value} at {nm} nm"
    )]
    Negative {
        /// Its wavelength.
        nm: f64,
        /// The value.
        value: f64,
        /// The least value that is taken for noise.
        least: f64,
    },
    /// A table none of whose wavelengths lies on the grid.
    #[error(
        "expected wavelengths within 300 to 780 nm, found {first} to {last} nm: nothing of it is visible"
    )]
    OutOfBand {
        /// Its first wavelength.
        first: f64,
        /// Its last wavelength.
        last: f64,
    },
    /// Fractions of light on a scale that nothing explains.
    #[error(
        "expected fractions of light up to 1, or per cent up to 100, found {greatest}: say which value is all light \
         (--scale 255, or scale = \"percent\")"
    )]
    Scale {
        /// The greatest value.
        greatest: f64,
    },
    /// A channel of a sensor without any value above 0.
    #[error("expected a sensitivity above 0 at some wavelength, found none: {value} at {nm} nm and so on")]
    NoSensitivity {
        /// The first wavelength.
        nm: f64,
        /// The value there.
        value: f64,
    },
}

/// The greatest magnitude of a value: products and sums of such values stay finite.
const GREATEST: f64 = 1e100;

impl Spectrum {
    /// The curve through the points of a table, on the grid; how, this module's first page says.
    ///
    /// `nm` are wavelengths in any increasing order of spacing. Whatever lies outside of the grid is
    /// dropped.
    ///
    /// ```
    /// use glanz_color::{Outside, Spectrum};
    ///
    /// // A filter that was measured every 100 nm.
    /// let filter = Spectrum::from_table(&[400.0, 500.0, 600.0], &[0.1, 0.5, 0.9], Outside::Hold)?;
    /// assert_eq!((filter.at(450.0), filter.at(700.0)), (0.3, 0.9));
    /// let error = Spectrum::from_table(&[500.0, 400.0], &[0.1, 0.2], Outside::Hold).unwrap_err();
    /// assert_eq!(error.to_string(), "expected increasing wavelengths, found 400 nm at index 1 after 500 nm");
    /// # Ok::<_, glanz_color::TableError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`TableError`] says which wavelength or value is not possible.
    pub fn from_table(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        check(nm, values)?;
        let curve = Curve { nm, values, outside };
        Ok(match nm.iter().all(|nm| nm % STEP_NM == 0.0) {
            true => Self::from_fn(|nm| curve.at(nm)),
            false => {
                let means = curve.projected(&Grid::DRAWN);
                Self(core::array::from_fn(|i| means[i]))
            }
        })
    }

    /// Light that consists of lines: pairs of a wavelength in nm and a power.
    ///
    /// A line between two samples is shared by both, more by the nearer one, so that power and centre
    /// of gravity are kept; a sample's value is its power over 5 nm. A line less than 5 nm outside of the
    /// grid gives the grid's end its part, one further away is dropped.
    ///
    /// # Errors
    ///
    /// [`TableError`] says which line's wavelength or power is not possible.
    pub fn from_lines(lines: &[(f64, f64)]) -> Result<Self, TableError> {
        let samples = Grid::DRAWN.lines(lines)?;
        Ok(Self(core::array::from_fn(|i| samples[i])))
    }
}

/// Wavelengths at equal steps.
pub(super) struct Grid {
    /// The first wavelength, in nm.
    pub(super) first: f64,
    /// The last wavelength, in nm.
    pub(super) last: f64,
    /// The step, in nm.
    pub(super) step: f64,
    /// How many wavelengths there are.
    pub(super) samples: usize,
}

impl Grid {
    /// The grid of [`Spectrum`].
    const DRAWN: Self = Self { first: FIRST_NM, last: LAST_NM, step: STEP_NM, samples: SAMPLES };

    /// Lines as power per nm at each sample.
    pub(super) fn lines(&self, lines: &[(f64, f64)]) -> Result<Vec<f64>, TableError> {
        let mut values = vec![0.0; self.samples];
        for (index, &(nm, power)) in lines.iter().enumerate() {
            check_point(index, nm, power)?;
            let position = (nm - self.first) / self.step;
            let left = position.floor();
            for (sample, fraction) in [(left, left + 1.0 - position), (left + 1.0, position - left)] {
                if (0.0..self.samples as f64).contains(&sample) {
                    values[sample as usize] += power * fraction / self.step;
                }
            }
        }
        Ok(values)
    }

    /// Adds ∫ of a piece of a curve times each triangle. It lies within one step around the grid.
    fn add_segment(&self, sums: &mut [f64], from: (f64, f64), to: (f64, f64)) {
        let position = |nm: f64| (nm - self.first) / self.step;
        let value = |nm: f64| lerp(from.1, to.1, (nm - from.0) / (to.0 - from.0));
        let mut left = position(from.0).floor();
        let mut a = from.0;
        while a < to.0 {
            let b = to.0.min(self.first + (left + 1.0) * self.step);
            let (va, vb) = (value(a), value(b));
            // Both factors are linear here, so this is exact: ∫ = Δ/6 (f₀g₀ + 4 f½g½ + f₁g₁).
            let (ga, gb) = (position(a) - left, position(b) - left);
            let rising = (b - a) / 6.0 * (va * ga + (va + vb) * (ga + gb) + vb * gb);
            let whole = (b - a) / 2.0 * (va + vb);
            for (sample, part) in [(left, whole - rising), (left + 1.0, rising)] {
                if (0.0..self.samples as f64).contains(&sample) {
                    sums[sample as usize] += part;
                }
            }
            a = b;
            left += 1.0;
        }
    }
}

pub(super) fn check(nm: &[f64], values: &[f64]) -> Result<(), TableError> {
    if nm.len() != values.len() {
        return Err(TableError::Lengths { wavelengths: nm.len(), values: values.len() });
    }
    if nm.len() < 2 {
        return Err(TableError::TooShort { found: nm.len() });
    }
    for (index, (&nm, &value)) in nm.iter().zip(values).enumerate() {
        check_point(index, nm, value)?;
    }
    match nm.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(at) => Err(TableError::NotIncreasing { index: at + 1, nm: nm[at + 1], before: nm[at] }),
        None => Ok(()),
    }
}

fn check_point(index: usize, nm: f64, value: f64) -> Result<(), TableError> {
    if !(nm > 0.0 && nm.is_finite()) {
        return Err(TableError::Wavelength { index, nm });
    }
    match value.abs() <= GREATEST {
        true => Ok(()),
        false => Err(TableError::Value { index, nm, value }),
    }
}

/// A table as a curve; it has at least two points, in increasing order.
pub(super) struct Curve<'a> {
    pub(super) nm: &'a [f64],
    pub(super) values: &'a [f64],
    pub(super) outside: Outside,
}

impl Curve<'_> {
    pub(super) fn first(&self) -> (f64, f64) {
        (self.nm[0], self.values[0])
    }

    pub(super) fn last(&self) -> (f64, f64) {
        let last = self.nm.len() - 1;
        (self.nm[last], self.values[last])
    }

    /// The value at a wavelength.
    pub(super) fn at(&self, nm: f64) -> f64 {
        let (first, last) = (self.first(), self.last());
        if !(first.0..=last.0).contains(&nm) {
            return match self.outside {
                Outside::Zero => 0.0,
                Outside::Hold if nm < first.0 => first.1,
                Outside::Hold => last.1,
            };
        }
        let right = self.nm.partition_point(|known| *known < nm).max(1);
        let (a, b) = (self.nm[right - 1], self.nm[right]);
        lerp(self.values[right - 1], self.values[right], (nm - a) / (b - a))
    }

    /// The means under the grid's triangles.
    pub(super) fn projected(&self, grid: &Grid) -> Vec<f64> {
        let mut sums = vec![0.0; grid.samples];
        let (low, high) = (grid.first - grid.step, grid.last + grid.step);
        let (first, last) = (self.first(), self.last());
        let hold = self.outside == Outside::Hold;
        if first.0 > low && (hold || first.0 <= grid.first) {
            grid.add_segment(&mut sums, (low, first.1), (first.0.min(high), first.1));
        }
        if last.0 < high && (hold || last.0 >= grid.last) {
            grid.add_segment(&mut sums, (last.0.max(low), last.1), (high, last.1));
        }
        for (nm, values) in self.nm.windows(2).zip(self.values.windows(2)) {
            let (a, b) = (nm[0].max(low), nm[1].min(high));
            if a < b {
                let value = |at: f64| lerp(values[0], values[1], (at - nm[0]) / (nm[1] - nm[0]));
                grid.add_segment(&mut sums, (a, value(a)), (b, value(b)));
            }
        }
        sums.iter().map(|sum| sum * (1.0 / grid.step)).collect()
    }
}

/// The value a part `t` of the way from `a` to `b`, exact at both ends and between equal values.
fn lerp(a: f64, b: f64, t: f64) -> f64 {
    if t < 0.5 { a + (b - a) * t } else { b - (b - a) * (1.0 - t) }
}

#[cfg(test)]
mod tests;
