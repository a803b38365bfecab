//! What sums are taken of: spectra as they are drawn, by 5 nm, and as numbers are told of them, by 1 nm.

use core::iter::Sum;
use core::ops::{Add, Mul};

use super::fine::{FineSpectrum, Interpolation};
use super::resample::{Outside, TableError};
use super::spectrum::Spectrum;
use crate::observers::Observer;

/// A spectrum of which sums are taken: [`Spectrum`] by 5 nm, or [`FineSpectrum`] by 1 nm.
///
/// The functions that make numbers of a spectrum take either, so that the difference between both is what drawing by 5 nm
/// costs.
///
/// ```
/// use glanz_color::chromaticity::Chromaticity;
/// use glanz_color::{fine_light, light};
///
/// let drawn = Chromaticity::of_light(&light("FL11")?).expect("it is seen");
/// let told = Chromaticity::of_light(&fine_light("FL11")?).expect("it is seen");
/// // The table is by 5 nm: both are the CIE's numbers.
/// assert!((drawn.x - told.x).abs() < 2e-5 && (drawn.y - told.y).abs() < 2e-5);
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
pub trait Sampled:
    Sized + Clone + Mul<f64, Output = Self> + Add<Output = Self> + Sum + private::Build
{
    /// ∫ with each channel of an observer, in the unit of the values times nm.
    fn responses(&self, observer: &Observer) -> Vec<f64>;

    /// ∫ over 300 to 780 nm.
    fn power(&self) -> f64;

    /// The product of both, wavelength by wavelength: light that a surface sends back.
    #[must_use]
    fn times(&self, other: &Self) -> Self;

    /// The spectrum by 1 nm; beyond 780 nm it is `outside` if it is known up to there only.
    fn to_fine(&self, outside: Outside) -> FineSpectrum;
}

/// How spectra by formula and from tables of this crate are made; and a seal.
pub(crate) mod private {
    use super::{Outside, TableError};

    #[expect(unnameable_types, reason = "it seals the trait above")]
    pub trait Build: Sized {
        fn build(f: &dyn Fn(f64) -> f64) -> Self;
        fn tabled(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError>;
        fn linear(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError>;
        fn lined(lines: &[(f64, f64)]) -> Result<Self, TableError>;
    }
}

impl private::Build for Spectrum {
    fn build(f: &dyn Fn(f64) -> f64) -> Self {
        Self::from_fn(f)
    }
    fn tabled(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        Self::from_table(nm, values, outside)
    }
    fn linear(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        Self::from_table(nm, values, outside)
    }
    fn lined(lines: &[(f64, f64)]) -> Result<Self, TableError> {
        Self::from_lines(lines)
    }
}

impl private::Build for FineSpectrum {
    fn build(f: &dyn Fn(f64) -> f64) -> Self {
        Self::from_fn(f)
    }
    fn tabled(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        Self::from_table(nm, values, outside)
    }
    fn linear(nm: &[f64], values: &[f64], outside: Outside) -> Result<Self, TableError> {
        Self::interpolated(nm, values, outside, Interpolation::Lines)
    }
    fn lined(lines: &[(f64, f64)]) -> Result<Self, TableError> {
        Self::from_lines(lines)
    }
}

impl Sampled for Spectrum {
    fn responses(&self, observer: &Observer) -> Vec<f64> {
        observer.response(self)
    }
    fn power(&self) -> f64 {
        self.integral()
    }
    fn times(&self, other: &Self) -> Self {
        *self * *other
    }
    fn to_fine(&self, outside: Outside) -> FineSpectrum {
        FineSpectrum::from_drawn(self, outside)
    }
}

impl Sampled for FineSpectrum {
    fn responses(&self, observer: &Observer) -> Vec<f64> {
        observer.fine_sensitivities().iter().map(|sensitivity| sensitivity.dot(self)).collect()
    }
    fn power(&self) -> f64 {
        self.integral()
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn to_fine(&self, _: Outside) -> FineSpectrum {
        self.clone()
    }
}
