//! Longitudinal chromatic aberration: by how much each wavelength is out of focus.

use libm::fabs;

use super::within;

/// The defocus of an eye that is in focus at 589 nm, in dioptres: negative where light is focused before the retina.
///
/// **Formula** 1.68524 − 633.46/(λ − 214.102). **Parameters** `nm` the wavelength λ, 360 to 830 nm.
/// **Source** L. N. Thibos, M. Ye, X. Zhang, A. Bradley, "The chromatic eye", Applied Optics 31(19), 1992; from memory, not checked
/// against the paper. People of all ages have nearly the same.
///
/// ```
/// assert!((glanz_eye::curves::chromatic_defocus(450.0) + 1.0001).abs() < 5e-5);
/// ```
pub fn chromatic_defocus(nm: f64) -> f64 {
    1.685_24 - 633.46 / (within(nm, 360.0, 830.0) - 214.102)
}

/// The diameter in degrees of the disc in which a point of one wavelength is blurred, while another is in focus: geometrical optics.
///
/// **Formula** pupil in m times the difference of [`chromatic_defocus`], in radians.
/// **Parameters** `nm` and `focus_nm` wavelengths in nm; `pupil_mm` the diameter of the pupil, 0 to 10 mm.
/// **Limits** no diffraction, which widens the disc of pupils below 2 mm.
///
/// ```
/// // Blue light through a pupil of 3 mm, with yellow-green in focus.
/// assert!((glanz_eye::curves::defocus_disc_deg(450.0, 3.0, 555.0) - 0.142).abs() < 5e-4);
/// ```
pub fn defocus_disc_deg(nm: f64, pupil_mm: f64, focus_nm: f64) -> f64 {
    let dioptres = fabs(chromatic_defocus(nm) - chromatic_defocus(focus_nm));
    (within(pupil_mm, 0.0, 10.0) * 1e-3 * dioptres).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    #[test]
    fn defocus_has_the_values_of_thibos() {
        // eye.md 118.
        assert_digits(chromatic_defocus(450.0), "-1.0001");
        assert_digits(chromatic_defocus(650.0), "0.2320");
    }

    #[test]
    fn the_wavelength_in_focus_has_no_disc_and_wide_pupils_have_large_ones() {
        assert_eq!(defocus_disc_deg(555.0, 3.0, 555.0), 0.0);
        assert_eq!(defocus_disc_deg(450.0, 6.0, 555.0), 2.0 * defocus_disc_deg(450.0, 3.0, 555.0));
        // eye.md §2.
        assert_digits(defocus_disc_deg(450.0, 3.0, 555.0), "0.142");
    }
}
