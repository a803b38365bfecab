//! Between linear sRGB and spectra, for scenes that have both.
//!
//! Light in a scene is in units of luminance: a spectrum S counts ∫ S·ȳ dλ with ȳ of CIE 1931. The light
//! of RGB 1, 1, 1 is D65, so a surface of some RGB under white light shows that RGB in spectra too.
//!
//! Observer and daylight are those of the grid from 300 to 780 nm; the white of that D65 is taken for the
//! white of sRGB, so that white stays exactly white. That turns XYZ by less than 0.0005.
//!
//! ```
//! use glanz_color::Rgb;
//! use glanz_color::rgb_spectra::{daylight, luminance, rgb_of_light, spectrum_of_light};
//!
//! // The unit light is D65 with the luminance 1.
//! assert!((luminance(&daylight()) - 1.0).abs() < 1e-12);
//! let warm = spectrum_of_light(Rgb([1.0, 0.8, 0.5]));
//! let [r, g, b] = rgb_of_light(&warm);
//! assert!((r - 1.0).abs() < 1e-4 && (g - 0.8).abs() < 1e-4 && (b - 0.5).abs() < 1e-4);
//! ```

use std::sync::LazyLock;

use crate::algebra::Matrix3;
use crate::display::rgb::Rgb;
use crate::lights::light;
use crate::models::cones::{BRADFORD, adaptation_matrix};
use crate::models::{D65_XYZ, LinearSrgb, RgbSpace};
use crate::observers::Observer;
use crate::sampling::upsample;
use crate::sampling::upsample::JakobHanika;
use crate::spectra::Spectrum;

/// XYZ of the screen's white, Y = 1.
pub const SCREEN_WHITE: [f64; 3] = D65_XYZ;

/// XYZ to linear sRGB.
pub const XYZ_TO_RGB: Matrix3 = *RgbSpace::LINEAR_SRGB.from_xyz_matrix();

/// What the conversions need, worked out once.
struct Tables {
    daylight: Spectrum,
    curves: [Spectrum; 3],
    /// XYZ on the grid to linear sRGB, D65 on the grid becoming 1, 1, 1.
    to_rgb: Matrix3,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let observer = Observer::default();
    let curves = [0, 1, 2].map(|c| observer.channels[c].sensitivity);
    let d65 = light("D65").expect("D65 is in the list of lights");
    let daylight = d65 * (1.0 / d65.dot(&curves[1]));
    let white = curves.each_ref().map(|curve| curve.dot(&daylight));
    let to_rgb = XYZ_TO_RGB.times(&adaptation_matrix(&BRADFORD, white, D65_XYZ));
    Tables { daylight, curves, to_rgb }
});

/// D65 with the luminance 1: the classic unit light.
pub fn daylight() -> Spectrum {
    TABLES.daylight
}

/// Luminance of a light in the unit of its spectrum: ∫ S·ȳ dλ.
pub fn luminance(light: &Spectrum) -> f64 {
    light.dot(&TABLES.curves[1])
}

/// The luminance of the light that is 1 at each wavelength: what tristimulus values are multiplied with whose
/// scale that light sets.
pub fn luminance_of_equal_energy() -> f64 {
    luminance(&Spectrum::ONE)
}

/// Linear sRGB of a light, out of gamut where it is more saturated than the primaries.
pub fn rgb_of_light(light: &Spectrum) -> [f64; 3] {
    let tables = &*TABLES;
    tables.to_rgb.apply(tables.curves.each_ref().map(|curve| curve.dot(light)))
}

/// Linear sRGB of a surface under D65.
pub fn rgb_of_reflectance(reflectance: &Spectrum) -> [f64; 3] {
    upsample::rgb_of_reflectance(reflectance).0
}

/// A smooth reflectance that has this linear sRGB under D65 (Jakob and Hanika 2019). Colours with a
/// component above 1 are made darker for it and the spectrum brighter again.
pub fn spectrum_of_reflectance(rgb: Rgb) -> Spectrum {
    let channels = rgb.0.map(|c| f64::from(c).max(0.0));
    let [r, g, b] = channels;
    if r == g && g == b {
        return Spectrum::constant(r);
    }
    let greatest = r.max(g).max(b).max(1.0);
    let fit = JakobHanika::fit(LinearSrgb(channels.map(|c| c / greatest)));
    fit.expect("numbers from 0 to 1 are inside of the cube").spectrum() * greatest
}

/// A light that has this linear sRGB: D65 through a smooth filter. Twice the RGB is twice the light.
pub fn spectrum_of_light(rgb: Rgb) -> Spectrum {
    let greatest = rgb.0.into_iter().fold(0.0_f32, f32::max);
    if greatest <= 0.0 {
        return Spectrum::ZERO;
    }
    let unit = Rgb(rgb.0.map(|c| c / greatest));
    TABLES.daylight * spectrum_of_reflectance(unit) * f64::from(greatest)
}

/// The three spectra whose mixture in the proportions of linear sRGB is the reflectance of a texel (Mallett and
/// Yuksel 2019). Their sum is 1 at each wavelength.
pub fn basis() -> &'static [Spectrum; 3] {
    upsample::mallett_yuksel_basis()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the upsampling by Jakob and Hanika leaves, and three digits of sums.
    const ROUND_TRIP: f64 = 1e-4;

    #[test]
    fn white_is_white_and_the_unit_light_is_one() {
        for c in rgb_of_light(&daylight()) {
            assert!((c - 1.0).abs() < 1e-12, "{c}");
        }
        assert!((luminance(&daylight()) - 1.0).abs() < 1e-12);
        assert_eq!(spectrum_of_reflectance(Rgb::WHITE), Spectrum::ONE);
    }

    #[test]
    fn twice_the_rgb_is_twice_the_light() {
        let (once, twice) =
            (spectrum_of_light(Rgb([0.2, 0.05, 0.1])), spectrum_of_light(Rgb([0.4, 0.1, 0.2])));
        for (a, b) in once.0.iter().zip(twice.0) {
            assert!((2.0 * a - b).abs() <= 1e-12 * b.abs(), "{a} and {b}");
        }
    }

    #[test]
    fn colours_come_back_as_surfaces_and_as_lights() {
        for rgb in [[0.8, 0.1, 0.1], [0.2, 0.5, 0.9], [0.05, 0.6, 0.05], [3.0, 1.0, 0.5], [0.0, 0.0, 0.0]] {
            let expected = rgb.map(f64::from);
            let surface = rgb_of_reflectance(&spectrum_of_reflectance(Rgb(rgb)));
            let light = rgb_of_light(&spectrum_of_light(Rgb(rgb)));
            for (got, expected) in surface.iter().zip(expected).chain(light.iter().zip(expected)) {
                assert!((got - expected).abs() < ROUND_TRIP * expected.max(1.0), "{rgb:?}: {got}");
            }
        }
    }
}
