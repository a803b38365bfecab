//! What a file of re-radiation holds.

use crate::surfaces::reradiation::{MeasuredError, Reradiation};

/// A re-radiation matrix of a file, at the wavelengths at which it was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedReradiation {
    /// Its name in the file, or one made from the file's name.
    pub name: String,
    /// The wavelengths of emission in nm, ascending.
    pub out_nm: Vec<f64>,
    /// The wavelengths of excitation in nm, ascending.
    pub in_nm: Vec<f64>,
    /// A row for each wavelength of emission, in it a value for each of excitation: the fraction of the
    /// incident light that leaves within the band of emission.
    pub values: Vec<f64>,
    /// The width of the band of emission that a value stands for, in nm.
    pub band_nm: f64,
    /// What the reader had to assume or left out, in words.
    pub notes: Vec<String>,
}

impl NamedReradiation {
    /// The matrix on the grid; see [`Reradiation::from_measured`].
    ///
    /// # Errors
    ///
    /// [`MeasuredError`] says which wavelength or value no material has.
    pub fn to_reradiation(&self) -> Result<Reradiation, MeasuredError> {
        Reradiation::from_measured(&self.out_nm, &self.in_nm, &self.values, self.band_nm)
    }
}

/// The step of ascending wavelengths, which is taken for the width of a band, and whether all steps are
/// the same up to rounding.
pub(in crate::file::read) fn step(nm: &[f64]) -> Option<(f64, bool)> {
    let (first, last) = (nm.first()?, nm.last()?);
    let step = (last - first) / (nm.len().checked_sub(1).filter(|count| *count > 0)? as f64);
    let even = nm.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() <= 0.01 * step);
    Some((step, even))
}
