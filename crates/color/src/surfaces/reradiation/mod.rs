//! Re-radiation: light that comes back at another wavelength than it came in.
//!
//! A Donaldson matrix M\[out\]\[in\] says what fraction of the light that comes in at one wavelength goes
//! out at another. L(out) = Σ M\[out\]\[in\] E(in) then holds for spectra of any scale, with one rule
//! that all of this module keeps: an entry is *per emission band*, the fraction of the light around `in`
//! that leaves within the band of 5 nm around `out`. So the sum of a column is a fraction of energy, and a
//! matrix of other bands must be resampled, not only read at other wavelengths (see `measured`).

mod axis;
mod energy;
mod measured;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};

use crate::spectra::{SAMPLES, Spectrum};

pub use energy::EnergyReport;
pub(crate) use measured::MOST_BANDS;
pub use measured::MeasuredError;

/// A Donaldson matrix: the spectral radiance factor from each wavelength of incidence to each of
/// emission.
///
/// Entry `[out][in]` is what one unit of light in the band of 5 nm around `in` gives in the band of 5
/// nm around `out`. The diagonal is ordinary reflectance.
///
/// ```
/// use glanz_color::{Reradiation, Spectrum, fluorescent, light};
///
/// // Paper with a brightener gives back more blue daylight than comes in.
/// let paper = fluorescent("paper-brightened")?;
/// let d65 = light("D65")?;
/// assert!(paper.total_radiance_factor(&d65).at(440.0) > 1.0);
/// // Without ultraviolet the brightener has nothing to turn.
/// let visible = Spectrum::from_fn(|nm| if nm < 420.0 { 0.0 } else { 1.0 }) * d65;
/// assert!(paper.total_radiance_factor(&visible).at(440.0) < 0.95);
/// // A surface that does not fluoresce is a diagonal.
/// assert_eq!(Reradiation::diagonal(&Spectrum::constant(0.5)).apply(&d65), d65 * 0.5);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Spectrum>", into = "Vec<Spectrum>")]
pub struct Reradiation {
    entries: Box<[[f64; SAMPLES]]>,
}

impl From<Reradiation> for Vec<Spectrum> {
    fn from(matrix: Reradiation) -> Self {
        matrix.entries.iter().map(|row| Spectrum(*row)).collect()
    }
}

impl TryFrom<Vec<Spectrum>> for Reradiation {
    type Error = String;
    /// From one row for each wavelength of emission.
    fn try_from(rows: Vec<Spectrum>) -> Result<Self, String> {
        match rows.len() {
            SAMPLES => Ok(Self { entries: rows.into_iter().map(|row| row.0).collect() }),
            found => Err(format!("expected {SAMPLES} rows, found {found}")),
        }
    }
}

impl Reradiation {
    /// Ordinary reflection: nothing but a diagonal.
    pub fn diagonal(reflectance: &Spectrum) -> Self {
        Self::from_fn(|out, input| if out == input { reflectance[out] } else { 0.0 })
    }

    /// The matrix of `f(out, in)`, both numbers of samples of the grid.
    pub fn from_fn(mut f: impl FnMut(usize, usize) -> f64) -> Self {
        Self { entries: (0..SAMPLES).map(|out| core::array::from_fn(|input| f(out, input))).collect() }
    }

    /// One entry.
    pub fn get(&self, out: usize, input: usize) -> f64 {
        self.entries[out][input]
    }

    /// The diagonal: what comes back at the wavelength at which it came in.
    pub fn reflectance(&self) -> Spectrum {
        Spectrum(core::array::from_fn(|i| self.entries[i][i]))
    }

    /// The same material without its fluorescence: the diagonal alone.
    pub fn without_reradiation(&self) -> Self {
        Self::diagonal(&self.reflectance())
    }

    /// The fluorescence alone: all but the diagonal.
    pub fn off_diagonal(&self) -> Self {
        Self::from_fn(|out, input| if out == input { 0.0 } else { self.entries[out][input] })
    }

    /// More or less of everything that comes back.
    pub fn scaled(&self, factor: f64) -> Self {
        Self::from_fn(|out, input| self.entries[out][input] * factor)
    }

    /// The light that comes back: L(out) = Σ M\[out, in\] E(in).
    pub fn apply(&self, light: &Spectrum) -> Spectrum {
        Spectrum(core::array::from_fn(|out| {
            self.entries[out].iter().zip(&light.0).map(|(entry, e)| entry * e).sum()
        }))
    }

    /// The total radiance factor under a light: L(λ) / E(λ), reflected and emitted light together.
    ///
    /// It exceeds 1 where more is emitted than came in. Where the light is 0 or negative there is no
    /// such ratio: the value is 0 there, though light may leave the material.
    pub fn total_radiance_factor(&self, light: &Spectrum) -> Spectrum {
        let leaving = self.apply(light);
        Spectrum(core::array::from_fn(|i| if light[i] > 0.0 { leaving[i] / light[i] } else { 0.0 }))
    }

    /// Whether every entry is a finite number.
    pub fn is_finite(&self) -> bool {
        self.entries.iter().flatten().all(|entry| entry.is_finite())
    }
}
