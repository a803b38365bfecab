//! The diameter of the pupil, and the light that comes through it.

use core::f64::consts::FRAC_PI_4;

use libm::pow;

use super::within;

/// Luminous efficacy of light of 555 nm, in lm/W (SI).
pub const PHOTOPIC_EFFICACY: f64 = 683.0;
/// Scotopic luminous efficacy of light of 507 nm, in lm/W (CIE 1951 with the SI's 683 lm/W at 555 nm).
pub const SCOTOPIC_EFFICACY: f64 = 1700.0;

/// How many eyes see the field: a pupil is wider where only one does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Eyes {
    /// One eye, the other one covered.
    One,
    /// Both eyes.
    #[default]
    Both,
}

/// The diameter of the pupil in mm: the unified formula.
///
/// **Formula** q = (L·a·e/846)^0.41, d = 7.75 − 5.75 q/(q + 2), and D = d + (A − 28.58)(0.02132 − 0.009562 d).
/// **Parameters** `luminance` L of the adapting field in cd/m², `field_deg2` its area a in deg² (not its diameter), `age` A in years,
/// 20 to 83, and `eyes`: e is 1 for both, 0.1 for one.
/// **Source** A. B. Watson and J. I. Yellott, "A unified formula for light-adapted pupil size", Journal of Vision 12(10), 2012.
/// **Not known** individuals differ by about a millimetre; emotion, drugs and the spectrum (melanopsin) are not in it.
///
/// ```
/// use glanz_eye::curves::{Eyes, pupil_diameter_mm};
///
/// assert!((pupil_diameter_mm(1.0, 900.0, 45.0, Eyes::Both) - 5.24009).abs() < 5e-6);
/// ```
pub fn pupil_diameter_mm(luminance: f64, field_deg2: f64, age: f64, eyes: Eyes) -> f64 {
    // So much flux is beyond any light; held, a product of 0 and infinity stays a number.
    let [luminance, field_deg2] = [luminance, field_deg2].map(|value| within(value, 0.0, 1e12));
    let eyes = if eyes == Eyes::Both { 1.0 } else { 0.1 };
    let q = pow(luminance * field_deg2 * eyes / 846.0, 0.41);
    let young = 7.75 - 5.75 * q / (q + 2.0);
    young + (within(age, 20.0, 83.0) - 28.58) * (0.021_32 - 0.009_562 * young)
}

/// Retinal illuminance in trolands: the luminance in cd/m² times the area of the pupil in mm², without the Stiles–Crawford effect.
///
/// ```
/// // The artificial pupil of 1 mm² defines the unit.
/// let across = libm::sqrt(4.0 / core::f64::consts::PI);
/// assert!((glanz_eye::curves::trolands(25.0, across) - 25.0).abs() < 1e-12);
/// ```
pub fn trolands(luminance: f64, diameter_mm: f64) -> f64 {
    // Beyond any light and any eye.
    let diameter = within(diameter_mm, 0.0, 1000.0);
    within(luminance, 0.0, 1e12) * FRAC_PI_4 * diameter * diameter
}

/// Photons per second that 1 troland of light of one wavelength brings to the cornea from each deg² of the field.
///
/// **Formula** (π/180)² · 1e-6 m² / K(λ) · λ/(hc): the flux of 1 cd/m² through 1 mm², in photons.
/// **Parameters** `nm` the wavelength λ; `efficacy` K(λ) in lm/W: [`PHOTOPIC_EFFICACY`] times V(λ) for trolands,
/// [`SCOTOPIC_EFFICACY`] times V′(λ) for scotopic trolands. Infinite where the efficacy is 0: such light has no trolands.
/// **Source** the SI's constants; G. Wyszecki and W. S. Stiles, "Color Science", 1982, has the same conversion.
///
/// The photons that arrive in a time are Poisson-distributed about the mean that this gives.
///
/// ```
/// use glanz_eye::curves::{PHOTOPIC_EFFICACY, photons_per_troland};
///
/// assert!((photons_per_troland(555.0, PHOTOPIC_EFFICACY) / 1.24609e6 - 1.0).abs() < 5e-6);
/// ```
pub fn photons_per_troland(nm: f64, efficacy: f64) -> f64 {
    /// Planck's constant times the speed of light, in J·m.
    const HC: f64 = 6.626_070_15e-34 * 299_792_458.0;
    const DEG: f64 = core::f64::consts::PI / 180.0;
    // Light of no wavelength has no photons; a wavelength of 1 m is no light either.
    let energy_j = HC / (within(nm, 0.0, 1e9) * 1e-9);
    DEG * DEG * 1e-6 / (efficacy.max(0.0) * energy_j).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    /// A disc of 60° across.
    const FIELD_DEG2: f64 = 2827.43;

    #[test]
    fn the_pupil_has_the_values_of_watson_and_yellott() {
        // eye.md 30–35: computed there by a second implementation, which agrees with three others.
        for (age, luminance, known) in [
            (20.0, 0.01, "7.5160"),
            (20.0, 1.0, "5.3997"),
            (20.0, 100.0, "2.9506"),
            (20.0, 1e4, "2.1503"),
            (80.0, 0.01, "4.7131"),
            (80.0, 1.0, "3.7189"),
        ] {
            assert_digits(pupil_diameter_mm(luminance, FIELD_DEG2, age, Eyes::Both), known);
        }
        // eye.md 38: the example of the R package CVD.
        assert_digits(pupil_diameter_mm(1.0, 900.0, 45.0, Eyes::Both), "5.24009");
    }

    #[test]
    fn one_eye_is_wider_open_and_age_is_held_within_the_formula() {
        let one = pupil_diameter_mm(10.0, FIELD_DEG2, 30.0, Eyes::One);
        assert!(one > pupil_diameter_mm(10.0, FIELD_DEG2, 30.0, Eyes::Both) + 0.5);
        // A tenth of the light for both eyes is the same.
        assert_eq!(one, pupil_diameter_mm(1.0, FIELD_DEG2, 30.0, Eyes::Both));
        let child = pupil_diameter_mm(10.0, FIELD_DEG2, 5.0, Eyes::Both);
        assert_eq!(child, pupil_diameter_mm(10.0, FIELD_DEG2, 20.0, Eyes::Both));
    }

    #[test]
    fn a_troland_has_its_photons_by_day_and_by_night() {
        // eye.md §2: 1.24609e6 per second and deg² at 555 nm, 4.57338e5 at 507 nm.
        assert_digits(photons_per_troland(555.0, PHOTOPIC_EFFICACY) / 1e6, "1.24609");
        assert_digits(photons_per_troland(507.0, SCOTOPIC_EFFICACY) / 1e5, "4.57338");
    }
}
