//! Dispersion formulas of transparent media.

use crate::spectra::Spectrum;

/// η as a formula of the wavelength λ in vacuum, in µm.
///
/// ```
/// use glanz_color::Dispersion;
///
/// // Cauchy's formula for an ordinary crown glass: blue is bent more than red.
/// let crown = Dispersion::Cauchy(&[1.5046, 0.0042]);
/// assert!((crown.eta(589.3) - 1.5167).abs() < 1e-4);
/// assert!(crown.eta(450.0) > crown.eta(650.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dispersion<'a> {
    /// W. Sellmeier 1871: η² = 1 + Σ B λ² / (λ² − C); pairs of B and C, with C in µm².
    Sellmeier(&'a [(f64, f64)]),
    /// A.-L. Cauchy 1836: η = A + B / λ² + C / λ⁴ …; A, B in µm², C in µm⁴ ….
    Cauchy(&'a [f64]),
}

impl Dispersion<'_> {
    /// η at a wavelength in nm. NaN where Sellmeier's sum is negative, near the resonances √C.
    pub fn eta(&self, lambda_nm: f64) -> f64 {
        let um2 = lambda_nm * lambda_nm * 1e-6;
        match self {
            Self::Sellmeier(terms) => {
                (1.0 + terms.iter().map(|(b, c)| b * um2 / (um2 - c)).sum::<f64>()).sqrt()
            }
            Self::Cauchy(terms) => terms.iter().rev().fold(0.0, |sum, term| sum / um2 + term),
        }
    }

    /// η at the grid's wavelengths.
    pub fn spectrum(&self) -> Spectrum {
        Spectrum::from_fn(|nm| self.eta(nm))
    }
}
