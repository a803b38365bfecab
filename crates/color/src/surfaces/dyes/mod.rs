//! Fluorescent dyes by their spectra: what they absorb, what they emit, and how much of it.
//!
//! ```
//! use glanz_color::{Spectrum, dyes::dye, light};
//!
//! // Marker ink: pyranine on white card, which absorbs nine tenths of the blue light.
//! let ink = dye("pyranine")?.over(&Spectrum::constant(0.9), 1.0)?;
//! let glow = ink.off_diagonal();
//! let under_blue = glow.apply(&light("line(450)")?);
//! let under_black_light = glow.apply(&light("line(365)")?);
//! assert_eq!(under_blue.points().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(nm, _)| nm), Some(510.0));
//! assert!(under_black_light.at(510.0) > 0.1 * under_blue.at(510.0));
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod list;

use thiserror::Error;

use crate::names::{UnknownName, plain};
use crate::spectra::{SAMPLES, Spectrum, lambda_nm};
use crate::surfaces::reradiation::Reradiation;

pub use list::{DyeInfo, dyes};

/// The base must reflect from 0 to 1, up to the rounding of tables.
const BASE_LIMIT: f64 = 1.0 + 1e-9;

/// The greatest decadic absorbance of a layer that means anything: of 10 only 1e-10 passes.
const MOST_ABSORBANCE: f64 = 10.0;

/// The part of the layer's absorbance that emitted light meets on its way out, in the mean over the depth at which it is
/// emitted.
const WAY_OUT: f64 = 0.5;

/// A dye: the shape of its absorption, that of its emission, and its quantum yield.
///
/// **Formula.** A layer of decadic absorbance D·A(λ) over a base of reflectance ρ absorbs a(λ) = 1 − 10^(−D·A(λ)) of the light
/// that the base would reflect; what is left is the diagonal. Of the photons absorbed the part Q is emitted with the shape
/// e(λ), whatever excited it (Kasha's rule, 1950; Vavilov's law). On its way out it meets half of the layer: t = 10^(−D·A/2)
/// passes, and what is absorbed is emitted again, so that Q e t / (1 − Q Σ e (1 − t)) leaves. Emission below the exciting
/// wavelength is lost as heat.
/// **Laws.** Emits at longer wavelengths only; gives back at most as many photons as the base reflects.
/// **Limits.** No quenching by concentration; spectra of dyes in solution, which pigments and fibres shift by some 10 nm.
#[derive(Clone, Debug, PartialEq)]
pub struct Dye {
    absorption: Spectrum,
    photons: Spectrum,
    quantum_yield: f64,
}

/// Why there is no such dye, or no such layer of it.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DyeError {
    /// A spectrum has a value below 0, or none above it.
    #[error(
        "expected {what} of at least 0, and above 0 somewhere within 300 to 780 nm, found {found} at {nm} nm"
    )]
    Spectrum {
        /// Which spectrum.
        what: &'static str,
        /// The wavelength, in nm.
        nm: f64,
        /// The value there.
        found: f64,
    },
    /// A number is out of its range.
    #[error("expected {what} from 0 to {most}, found {found}")]
    Range {
        /// Which number.
        what: &'static str,
        /// The greatest value.
        most: f64,
        /// The number.
        found: f64,
    },
    /// The emission lies below the excitation.
    #[error(
        "expected an emission above the excitation (Stokes), found them strongest at {emission_nm} nm and {excitation_nm} nm: \
             are they exchanged?"
    )]
    Stokes {
        /// Where the excitation is strongest, in nm.
        excitation_nm: f64,
        /// Where the emission is strongest, in nm.
        emission_nm: f64,
    },
    /// The base reflects less than nothing or more than all.
    #[error("expected a base that reflects 0 to 1, found {found} at {nm} nm")]
    Base {
        /// The wavelength, in nm.
        nm: f64,
        /// The reflectance.
        found: f64,
    },
}

/// The dye of that name; [`dyes`] lists them.
///
/// # Errors
///
/// [`UnknownName`] suggests near names.
pub fn dye(name: &str) -> Result<Dye, UnknownName> {
    list::find(&plain(name))
        .ok_or_else(|| UnknownName::not_found("dye", name.trim(), dyes().iter().map(|info| info.name)))
}

impl Dye {
    /// A dye from spectra: its excitation or absorbance on any scale, its emission as power per nm on any scale, and the photons
    /// emitted for each absorbed, 0 to 1.
    ///
    /// # Errors
    ///
    /// [`DyeError`]: a spectrum without a value above 0, a yield out of range, or both spectra exchanged.
    pub fn from_spectra(
        excitation: &Spectrum,
        emission: &Spectrum,
        quantum_yield: f64,
    ) -> Result<Self, DyeError> {
        let (excitation_nm, most) = peak("an excitation", excitation)?;
        let (emission_nm, _) = peak("an emission", emission)?;
        if emission_nm < excitation_nm {
            return Err(DyeError::Stokes { excitation_nm, emission_nm });
        }
        in_range("a quantum yield", quantum_yield, 1.0)?;
        let photons = Spectrum::from_fn(|nm| emission.at(nm) * nm);
        let sum = photons.0.iter().sum::<f64>();
        Ok(Self { absorption: *excitation * (1.0 / most), photons: photons * (1.0 / sum), quantum_yield })
    }

    /// The shape of the absorption, 1 at its greatest within 300 to 780 nm.
    pub fn absorption(&self) -> &Spectrum {
        &self.absorption
    }

    /// The shape of the emission as power, 1 at its greatest.
    pub fn emission(&self) -> Spectrum {
        let power = Spectrum::from_fn(|nm| self.photons.at(nm) / nm);
        power * (1.0 / power.max())
    }

    /// Photons emitted for each absorbed.
    pub fn quantum_yield(&self) -> f64 {
        self.quantum_yield
    }

    /// This dye excited through other dyes of a mixture too, which hand on what they absorb: each with its share of the
    /// absorbance.
    pub fn sensitised_by(&self, others: &[(&Dye, f64)]) -> Self {
        let absorption =
            others.iter().fold(self.absorption, |sum, (dye, share)| sum + dye.absorption * *share);
        Self { absorption: absorption * (1.0 / absorption.max()), ..self.clone() }
    }

    /// A layer over a base of this reflectance; `absorbance` is its greatest decadic absorbance for light that enters and comes
    /// back: 1 absorbs nine tenths.
    ///
    /// # Errors
    ///
    /// [`DyeError`]: an absorbance from 0 to 10 or a base out of its range.
    pub fn over(&self, base: &Spectrum, absorbance: f64) -> Result<Reradiation, DyeError> {
        in_range("an absorbance", absorbance, MOST_ABSORBANCE)?;
        if let Some((nm, found)) = base.points().find(|(_, value)| !(0.0..=BASE_LIMIT).contains(value)) {
            return Err(DyeError::Base { nm, found });
        }
        let passed = |part: f64| self.absorption.map(|value| libm::exp10(-part * absorbance * value));
        let absorbed = passed(1.0).map(|passed| 1.0 - passed) * *base;
        let leaving = self.leaving(&passed(WAY_OUT));
        Ok(Reradiation::from_fn(|out, input| match out.cmp(&input) {
            core::cmp::Ordering::Less => 0.0,
            core::cmp::Ordering::Equal => base[input] - absorbed[input],
            core::cmp::Ordering::Greater => absorbed[input] * lambda_nm(input) * leaving[out],
        }))
    }

    /// Energy that leaves in each band for one photon absorbed, its energy being 1 / λ.
    fn leaving(&self, passed: &Spectrum) -> [f64; SAMPLES] {
        let out = self.photons * *passed;
        let again = 1.0 - out.0.iter().sum::<f64>();
        let factor = self.quantum_yield / (1.0 - self.quantum_yield * again);
        core::array::from_fn(|i| factor * out[i] / lambda_nm(i))
    }
}

/// Where a spectrum is greatest, in nm, and how great.
fn peak(what: &'static str, spectrum: &Spectrum) -> Result<(f64, f64), DyeError> {
    if let Some((nm, found)) = spectrum.points().find(|(_, value)| !(*value >= 0.0 && value.is_finite())) {
        return Err(DyeError::Spectrum { what, nm, found });
    }
    let most = spectrum.points().fold((lambda_nm(0), 0.0), |best, at| if at.1 > best.1 { at } else { best });
    match most.1 > 0.0 {
        true => Ok(most),
        false => Err(DyeError::Spectrum { what, nm: most.0, found: most.1 }),
    }
}

fn in_range(what: &'static str, found: f64, most: f64) -> Result<(), DyeError> {
    if (0.0..=most).contains(&found) { Ok(()) } else { Err(DyeError::Range { what, most, found }) }
}

#[cfg(test)]
mod tests;
