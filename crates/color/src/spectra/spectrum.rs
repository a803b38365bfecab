//! A function of wavelength on the one grid that all of Glanz uses.

use serde::{Deserialize, Serialize};

/// The first wavelength of the grid, in nm. Ultraviolet is part of light here.
pub const FIRST_NM: f64 = 300.0;
/// The last wavelength of the grid, in nm.
pub const LAST_NM: f64 = 780.0;
/// The step of the grid, in nm.
pub const STEP_NM: f64 = 5.0;
/// The number of wavelengths of the grid.
pub const SAMPLES: usize = 97;

/// The wavelength of a sample of the grid, in nm.
pub const fn lambda_nm(index: usize) -> f64 {
    FIRST_NM + STEP_NM * index as f64
}

/// A function of wavelength: 97 values at 300, 305 … 780 nm.
///
/// For light a value is spectral power per nm; for surfaces a pure number. Integrals are sums over the
/// samples times 5 nm, so a sample stands for the band of 5 nm around it.
///
/// Spectra are added, subtracted, multiplied and divided wavelength by wavelength, among themselves and with scalars on
/// either side of `*` and `/`; where a divisor is 0 the quotient is not finite, as with numbers. By serde a spectrum is the
/// list of its 97 values.
///
/// ```
/// use glanz_color::{Spectrum, light, reflectance};
///
/// // What the chart's green of leaves sends back under two lamps, one of them dimmed.
/// let lamps = light("D65")? + 0.5 * light("A")?;
/// let leaf = reflectance("foliage")?;
/// let stimulus = leaf * lamps;
/// assert_eq!(stimulus.at(550.0), leaf.at(550.0) * lamps.at(550.0));
/// // The reflectance is found again as a quotient.
/// assert!((stimulus / lamps - leaf).max() < 1e-15);
/// let mean = [leaf, Spectrum::ONE].iter().sum::<Spectrum>() / 2.0;
/// assert_eq!(mean[50], (leaf[50] + 1.0) / 2.0);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<f64>", into = "Vec<f64>")]
pub struct Spectrum(pub [f64; SAMPLES]);

impl Default for Spectrum {
    /// Nothing at any wavelength.
    fn default() -> Self {
        Self::ZERO
    }
}

impl From<[f64; SAMPLES]> for Spectrum {
    fn from(values: [f64; SAMPLES]) -> Self {
        Self(values)
    }
}

impl From<Spectrum> for Vec<f64> {
    fn from(spectrum: Spectrum) -> Self {
        spectrum.0.to_vec()
    }
}

impl TryFrom<Vec<f64>> for Spectrum {
    type Error = String;
    fn try_from(values: Vec<f64>) -> Result<Self, String> {
        let found = values.len();
        let values = values.try_into().map_err(|_| format!("expected {SAMPLES} samples, found {found}"))?;
        Ok(Self(values))
    }
}

impl Spectrum {
    /// Nothing at any wavelength.
    pub const ZERO: Self = Self([0.0; SAMPLES]);
    /// 1 at every wavelength: the white surface, the equal-energy light.
    pub const ONE: Self = Self([1.0; SAMPLES]);

    /// The same value at every wavelength.
    pub const fn constant(value: f64) -> Self {
        Self([value; SAMPLES])
    }

    /// The function of the wavelength in nm, taken at the grid's wavelengths.
    pub fn from_fn(mut f: impl FnMut(f64) -> f64) -> Self {
        Self(core::array::from_fn(|i| f(lambda_nm(i))))
    }

    /// The value at a wavelength in nm, linear between samples; 0 outside of the grid.
    pub fn at(&self, nm: f64) -> f64 {
        let position = (nm - FIRST_NM) / STEP_NM;
        if !(0.0..=(SAMPLES - 1) as f64).contains(&position) {
            return 0.0;
        }
        let left = (position as usize).min(SAMPLES - 2);
        let t = position - left as f64;
        self.0[left] + (self.0[left + 1] - self.0[left]) * t
    }

    /// ∫ over the grid, in the unit of the values times nm.
    pub fn integral(&self) -> f64 {
        self.0.iter().sum::<f64>() * STEP_NM
    }

    /// ∫ of the product of both.
    pub fn dot(&self, other: &Self) -> f64 {
        self.0.iter().zip(&other.0).map(|(a, b)| a * b).sum::<f64>() * STEP_NM
    }

    /// Every value through a function.
    pub fn map(&self, f: impl FnMut(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    /// The greatest value.
    pub fn max(&self) -> f64 {
        self.0.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The least value.
    pub fn min(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Whether every value is a finite number.
    pub fn is_finite(&self) -> bool {
        self.0.iter().all(|v| v.is_finite())
    }

    /// Wavelength in nm and value, in order.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.0.iter().enumerate().map(|(i, value)| (lambda_nm(i), *value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_runs_from_300_to_780_nm() {
        assert_eq!(lambda_nm(0), FIRST_NM);
        assert_eq!(lambda_nm(SAMPLES - 1), LAST_NM);
        assert_eq!(Spectrum::ONE.integral(), 485.0);
    }

    #[test]
    fn values_between_samples_are_linear_and_outside_there_are_none() {
        let ramp = Spectrum::from_fn(|nm| 2.0 * nm);
        assert_eq!(ramp.at(301.0), 602.0);
        assert_eq!(ramp.at(780.0), 1560.0);
        assert_eq!(ramp.at(299.9), 0.0);
        assert_eq!(ramp.at(f64::NAN), 0.0);
    }
}
