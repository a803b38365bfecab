//! Photometric units from radiometric spectra, and the scales that take a relative spectrum to a given
//! photometric value.
//!
//! One rule for all quantities: 683 lm/W ∫ S(λ) V(λ) dλ, with V(λ) of CIE 1924, by sums of 5 nm over
//! [`Spectrum`](crate::Spectrum) and of 1 nm over [`FineSpectrum`](crate::FineSpectrum).
//! The unit of the result follows from that of the spectrum:
//!
//! | spectrum, per nm | by day | at night |
//! |---|---|---|
//! | W/(m² sr nm) | luminance, cd/m² | scotopic luminance, cd/m² |
//! | W/(m² nm) | illuminance, lx | scotopic illuminance, lx |
//! | W/(sr nm) | luminous intensity, cd | scotopic intensity, cd |
//! | W/nm | luminous flux, lm | scotopic flux, lm |
//!
//! ```
//! use glanz_color::photometry::{Adapted, luminous, scale_to};
//! use glanz_color::{Spectrum, light};
//!
//! // A watt at 555 nm is 683 lumens.
//! let green = Spectrum::from_lines(&[(555.0, 1.0)])?;
//! assert!((luminous(&green, Adapted::Photopic) - 683.0).abs() < 0.1);
//! // Illuminant A as a screen of 250 cd/m²; the rods make 1.4 times as much of it.
//! let a = light("A")?;
//! let screen = a * scale_to(&a, 250.0, Adapted::Photopic)?;
//! assert!((luminous(&screen, Adapted::Photopic) - 250.0).abs() < 1e-9);
//! assert!((luminous(&screen, Adapted::Scotopic) / 250.0 - 1.41).abs() < 0.01);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use crate::observers::{Observer, kept};
use crate::spectra::Sampled;

/// Lumens per watt at the peak of V(λ), as the SI rounds it (683.002 exactly at 555 nm in air).
pub const PHOTOPIC_LM_PER_W: f64 = 683.0;

/// Scotopic lumens per watt at the peak of V′(λ) (CIE 1951; ISO/CIE 23539:2023 gives 1700.05).
pub const SCOTOPIC_LM_PER_W: f64 = 1700.0;

/// Whether the cones or the rods see.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Adapted {
    /// V(λ): the eye by day.
    Photopic,
    /// V′(λ): the eye at night.
    Scotopic,
}

/// A light that cannot be scaled to what was asked for.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PhotometryError {
    /// Nothing of it is seen.
    #[error("expected a light that is seen, found {found} lm/W ∫ S V; it has no scale")]
    Unseen {
        /// What the light has, in the unit asked for.
        found: f64,
    },
    /// There is no such amount of light.
    #[error("expected a finite photometric value of at least 0, found {0}")]
    NotAnAmount(f64),
}

impl Adapted {
    /// Whose efficiency it is, 1 at its peak.
    fn observer(self) -> &'static Observer {
        match self {
            Self::Photopic => kept("photopic"),
            Self::Scotopic => kept("scotopic"),
        }
    }

    const fn lm_per_w(self) -> f64 {
        match self {
            Self::Photopic => PHOTOPIC_LM_PER_W,
            Self::Scotopic => SCOTOPIC_LM_PER_W,
        }
    }
}

/// The photometric value of a radiometric spectrum: cd/m², lx, cd or lm, as the module's table says.
pub fn luminous<S: Sampled>(spectrum: &S, eye: Adapted) -> f64 {
    let responses = spectrum.responses(eye.observer());
    eye.lm_per_w() * responses.first().expect("an efficiency is one channel")
}

/// The luminance of a spectral radiance in W/(m² sr nm), in cd/m².
pub fn luminance_cd_m2<S: Sampled>(radiance: &S) -> f64 {
    luminous(radiance, Adapted::Photopic)
}

/// The illuminance of a spectral irradiance in W/(m² nm), in lx.
pub fn illuminance_lx<S: Sampled>(irradiance: &S) -> f64 {
    luminous(irradiance, Adapted::Photopic)
}

/// The luminous efficacy of a light's radiation within 300 … 780 nm, in lm/W; none without radiation.
pub fn efficacy_lm_per_w<S: Sampled>(spectrum: &S) -> Option<f64> {
    let watts = spectrum.power();
    (watts > 0.0).then(|| luminous(spectrum, Adapted::Photopic) / watts)
}

/// What a relative spectrum must be multiplied by to have a photometric value: the way back of
/// [`luminous`].
///
/// # Errors
///
/// A light of which nothing is seen (ultraviolet alone has no luminance), or a value that is negative or
/// not finite.
pub fn scale_to<S: Sampled>(spectrum: &S, value: f64, eye: Adapted) -> Result<f64, PhotometryError> {
    if !(value >= 0.0 && value.is_finite()) {
        return Err(PhotometryError::NotAnAmount(value));
    }
    let found = luminous(spectrum, eye);
    let scale = value / found;
    match found > 0.0 && scale.is_finite() {
        true => Ok(scale),
        false => Err(PhotometryError::Unseen { found }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::spectra::{STEP_NM, Spectrum};

    #[test]
    fn one_watt_at_555_nm_is_683_lumens() {
        let line = Spectrum::from_fn(|nm| if nm == 555.0 { 1.0 / STEP_NM } else { 0.0 });
        assert!((luminous(&line, Adapted::Photopic) - 683.0).abs() < 1e-9);
        // V'(555) = 0.402 (CIE 1951).
        assert!((luminous(&line, Adapted::Scotopic) - 1700.0 * 0.402).abs() < 1e-9);
    }

    #[test]
    fn equal_energy_has_its_known_efficacy() {
        // ∫ V = 106.857 nm over 480 nm, here over the 485 nm of 97 bands.
        let found = efficacy_lm_per_w(&Spectrum::ONE).unwrap();
        assert!((found - 683.0 * 106.857 / 485.0).abs() < 0.01, "{found}");
        assert_eq!(efficacy_lm_per_w(&Spectrum::ZERO), None);
    }

    #[test]
    fn a_scaled_light_has_the_value_asked_for() {
        let light = light("A").unwrap();
        for eye in [Adapted::Photopic, Adapted::Scotopic] {
            let scaled = light * scale_to(&light, 250.0, eye).unwrap();
            assert!((luminous(&scaled, eye) - 250.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_rods_see_more_of_daylight_than_of_a_lamp() {
        // S/P ratios: A about 1.41, D65 about 2.47 (CIE 191:2010).
        let ratio = |name: &str| {
            let light = light(name).unwrap();
            luminous(&light, Adapted::Scotopic) / luminous(&light, Adapted::Photopic)
        };
        assert!((ratio("A") - 1.41).abs() < 0.01, "{}", ratio("A"));
        assert!((ratio("D65") - 2.47).abs() < 0.01, "{}", ratio("D65"));
    }

    #[test]
    fn what_is_not_seen_has_no_scale() {
        let black_light = Spectrum::from_fn(|nm| if nm < 350.0 { 1.0 } else { 0.0 });
        assert!(matches!(
            scale_to(&black_light, 10.0, Adapted::Photopic),
            Err(PhotometryError::Unseen { .. })
        ));
        assert_eq!(
            scale_to(&Spectrum::ONE, -1.0, Adapted::Photopic),
            Err(PhotometryError::NotAnAmount(-1.0))
        );
    }
}
