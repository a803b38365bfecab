//! What a spectral table says of its file.

use schemars::JsonSchema;
use serde::Deserialize;

use super::values::Amount;
use crate::names::names;

/// Which spectrum of a file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected the name of a spectrum, or its number from 1")]
pub(crate) enum Column {
    /// By its number, from 1.
    Number(u32),
    /// By its name.
    Name(String),
}

/// A factor, or how the values of a file are scaled.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected a factor of at least 0, \"percent\" or \"fraction\"")]
pub(crate) enum ScaleValue {
    /// A factor.
    Factor(Amount),
    /// The scale of a file.
    File(FileScale),
}

impl ScaleValue {
    /// What the function is multiplied by.
    pub(crate) fn factor(&self) -> f64 {
        match self {
            Self::Factor(factor) => factor.0,
            Self::File(_) => 1.0,
        }
    }
}

names! {
    /// How the values of a file are scaled.
    pub(crate) FileScale {
        /// 1 is all light.
        Fraction = "fraction",
        /// 100 is all light.
        Percent = "percent",
    } default Fraction
}

names! {
    /// What the values of a file are.
    pub(crate) FileQuantity {
        /// Power by wavelength.
        Light = "light",
        /// Reflectance or transmittance.
        Surface = "surface",
        /// What comes back of the light.
        Reflectance = "reflectance",
        /// What passes of the light.
        Transmittance = "transmittance",
        /// −log₁₀ of what passes.
        Absorbance = "absorbance",
    } default Surface
}

names! {
    /// The unit of the wavelengths of a file.
    pub(crate) AxisUnit {
        /// Wavelengths in nm.
        Nanometres = "nm",
        /// Wavelengths in µm.
        Micrometres = "um",
        /// Wavelengths in m.
        Metres = "m",
        /// Wavelengths in Å.
        Angstroms = "angstrom",
        /// Wavenumbers in 1/cm.
        InverseCentimetres = "cm-1",
        /// Frequencies in THz.
        Terahertz = "thz",
        /// Frequencies in Hz.
        Hertz = "hz",
        /// Energies of photons in eV.
        Electronvolts = "ev",
    } default Nanometres
}
