//! What a file of spectra holds: named spectra, as they were measured.

use crate::file::read::Quantity;
use crate::spectra::{FIRST_NM, FineSpectrum, Interpolation, LAST_NM, Outside, Spectrum, TableError};

/// Fractions of light beyond this are counts, or on another scale, whatever a file says: iridescent feathers give back four
/// times the light of a white standard.
const GREATEST_FRACTION: f64 = 10.0;

/// Where values far below 0 are no noise.
const SEEN_NM: core::ops::RangeInclusive<f64> = 400.0..=700.0;

/// How far below 0 noise reaches, as a part of the greatest value: instruments that subtract their dark
/// signal give up to about a hundredth.
const NOISE: f64 = 0.02;

/// A spectrum of a file, at the wavelengths at which it was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedSpectrum {
    /// Its name in the file, or one made from the file's name.
    pub name: String,
    /// The wavelengths in nm, ascending, at least one.
    pub nm: Vec<f64>,
    /// A value for each wavelength; fractions of light from 0 to 1, not in per cent.
    pub values: Vec<f64>,
    /// What the values are.
    pub quantity: Quantity,
    /// The unit as the file gives it; empty if it does not. Values are not converted to another unit, save
    /// that densities per THz become densities per nm.
    pub unit: String,
    /// What the reader had to assume or left out, in words.
    pub notes: Vec<String>,
}

impl NamedSpectrum {
    /// The spectrum on the grid, and in words what lay outside of it or was missing.
    ///
    /// Beyond its ends a fraction of light is held, any other spectrum is 0, unless `outside` says otherwise.
    /// Values below 0 are noise, and become 0; from 400 to 700 nm down to −0.02 of the greatest value, or of 1 for fractions
    /// of light.
    ///
    /// # Errors
    ///
    /// [`TableError`] where there is but one wavelength, or a value is no number, or less than noise makes it.
    pub fn to_spectrum(&self, outside: Option<Outside>) -> Result<(Spectrum, Vec<String>), TableError> {
        let (clipped, noise) = self.without_noise()?;
        let (spectrum, mut notes) = self.resampled(&clipped, outside)?;
        notes.extend(noise);
        Ok((spectrum, notes))
    }

    /// The spectrum by 1 nm, for numbers: what it holds of a table, [`FineSpectrum`] says. What is clipped and what is
    /// refused is as for [`NamedSpectrum::to_spectrum`].
    ///
    /// # Errors
    ///
    /// [`TableError`], as for [`NamedSpectrum::to_spectrum`].
    pub fn to_fine(
        &self,
        outside: Option<Outside>,
        interpolation: Interpolation,
    ) -> Result<FineSpectrum, TableError> {
        let (clipped, _) = self.without_noise()?;
        FineSpectrum::interpolated(&self.nm, &clipped, outside.unwrap_or(self.outside()), interpolation)
    }

    /// The mean step between the wavelengths, in nm; 0 for one alone.
    pub fn step_nm(&self) -> f64 {
        match self.nm.as_slice() {
            [first, .., last] => (last - first) / (self.nm.len() - 1) as f64,
            _ => 0.0,
        }
    }

    /// The values without those below 0, and what is to be told of them.
    fn without_noise(&self) -> Result<(Vec<f64>, Option<String>), TableError> {
        self.check_band()?;
        let greatest = self.within_band();
        if self.quantity.is_ratio() && greatest > GREATEST_FRACTION {
            return Err(TableError::Scale { greatest });
        }
        let least = -NOISE * self.scale();
        let in_band = |nm: f64| (FIRST_NM..=LAST_NM).contains(&nm);
        let below =
            || self.nm.iter().zip(&self.values).filter(move |(nm, value)| **value < 0.0 && in_band(**nm));
        // Towards the ends lamps are weak and instruments blind: there noise is as great as it likes.
        if let Some((&nm, &value)) = below().find(|(nm, value)| **value < least && SEEN_NM.contains(*nm)) {
            return Err(TableError::Negative { nm, value, least });
        }
        let (count, lowest) = below().fold((0, 0.0), |(n, low), (_, value)| (n + 1, value.min(low)));
        let clipped: Vec<f64> = self.values.iter().map(|value| value.max(0.0)).collect();
        let name = &self.name;
        let told = || format!("{count} values of '{name}' below 0, down to {lowest}, are taken as noise: 0");
        Ok((clipped, (count > 0).then(told)))
    }

    /// The greatest value where it is used: instruments give noise beyond.
    pub(in crate::file::read) fn within_band(&self) -> f64 {
        let points = self.nm.iter().zip(&self.values);
        let seen = points.filter(|(nm, _)| (FIRST_NM..=LAST_NM).contains(*nm));
        seen.map(|(_, value)| *value).fold(0.0, f64::max)
    }

    /// Something must have been measured where the grid is.
    fn check_band(&self) -> Result<(), TableError> {
        match (self.nm.first(), self.nm.last()) {
            (Some(&first), Some(&last)) if first > LAST_NM || last < FIRST_NM => {
                Err(TableError::OutOfBand { first, last })
            }
            _ => Ok(()),
        }
    }

    /// The curve on the grid as the weights of a sensor's channel, and what lay outside of it or was missing.
    ///
    /// Beyond its ends it is 0. Values below 0 are kept: matching functions of real primaries have them.
    ///
    /// # Errors
    ///
    /// [`TableError`] where there is but one wavelength, or a value is no number, or none lies above 0.
    pub fn to_sensitivity(&self) -> Result<(Spectrum, Vec<String>), TableError> {
        if let (Some(&nm), Some(&value)) = (self.nm.first(), self.values.first())
            && !self.values.iter().any(|value| *value > 0.0)
        {
            return Err(TableError::NoSensitivity { nm, value });
        }
        self.resampled(&self.values, Some(Outside::Zero))
    }

    /// What noise is measured by: the greatest value; for fractions of light at least the white, 1.
    fn scale(&self) -> f64 {
        let white = if self.quantity.is_ratio() { 1.0 } else { 0.0 };
        self.values.iter().copied().fold(white, f64::max)
    }

    fn resampled(
        &self,
        values: &[f64],
        outside: Option<Outside>,
    ) -> Result<(Spectrum, Vec<String>), TableError> {
        let outside = outside.unwrap_or(self.outside());
        let spectrum = Spectrum::from_table(&self.nm, values, outside)?;
        Ok((spectrum, self.coverage(outside)))
    }

    /// What it is beyond its ends, if nothing else is said.
    fn outside(&self) -> Outside {
        if self.quantity.is_ratio() { Outside::Hold } else { Outside::Zero }
    }

    /// What of the grid the spectrum does not cover, and what of the spectrum the grid does not.
    fn coverage(&self, outside: Outside) -> Vec<String> {
        let (Some(&first), Some(&last)) = (self.nm.first(), self.nm.last()) else { return Vec::new() };
        let mut notes = Vec::new();
        let taken = match outside {
            Outside::Zero => "zero",
            Outside::Hold => "the value at its end",
        };
        if first > FIRST_NM {
            notes.push(format!(
                "'{}' begins at {first} nm: {taken} is taken from {FIRST_NM} nm on",
                self.name
            ));
        }
        if last < LAST_NM {
            notes.push(format!("'{}' ends at {last} nm: {taken} is taken up to {LAST_NM} nm", self.name));
        }
        let beyond = self.nm.iter().filter(|nm| !(FIRST_NM..=LAST_NM).contains(*nm)).count();
        if beyond > 0 {
            let of = self.nm.len();
            notes.push(format!("{beyond} of {of} values of '{}' lie outside of 300 to 780 nm", self.name));
        }
        notes
    }
}

/// At most this many remarks are kept of a file.
const MOST_NOTES: usize = 16;

/// Adds a remark, if it is new and there are not too many.
pub(in crate::file::read) fn note(notes: &mut Vec<String>, text: impl Into<String>) {
    let text = text.into();
    if notes.len() < MOST_NOTES && !notes.contains(&text) {
        notes.push(text);
    }
}
