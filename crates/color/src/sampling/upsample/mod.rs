//! From RGB to spectra: what a colour's spectrum may be, where only its RGB is known.
//!
//! Two ways. [`JakobHanika`] finds, for one colour, the smooth reflectance that has it exactly: for materials
//! and lights. [`mallett_yuksel_basis`] are three fixed spectra, mixed by R, G and B: for textures.
//!
//! RGB here is linear sRGB of a surface under D65 for the CIE 1931 observer, summed on the grid: see
//! [`rgb_of_reflectance`], the way back.
//!
//! ```
//! use glanz_color::models::LinearSrgb;
//! use glanz_color::upsample::{JakobHanika, rgb_of_reflectance};
//!
//! let reflectance = JakobHanika::fit(LinearSrgb([0.6, 0.1, 0.05]))?.spectrum();
//! assert!(reflectance.at(650.0) > 0.5 && reflectance.max() <= 1.0);
//! let LinearSrgb([r, g, b]) = rgb_of_reflectance(&reflectance);
//! assert!((r - 0.6).abs() < 1e-6 && (g - 0.1).abs() < 1e-6 && (b - 0.05).abs() < 1e-6);
//! # Ok::<_, glanz_color::upsample::UpsampleError>(())
//! ```

mod jakob_hanika;
mod mallett_yuksel;
#[cfg(test)]
mod tests;

use std::sync::LazyLock;

use crate::lights::light;
use crate::measures::chromaticity::{cie1931, tristimulus};
use crate::models::cones::{BRADFORD, adaptation_matrix};
use crate::models::{D65_XYZ, LinearSrgb, RgbSpace};
use crate::spectra::{STEP_NM, Spectrum};

pub use jakob_hanika::{JakobHanika, UpsampleError};
pub use mallett_yuksel::mallett_yuksel_basis;

/// What each wavelength of a reflectance counts for linear R, G, B under D65: their sums over the grid times
/// 5 nm are 1.
///
/// The white of sRGB is given with four digits and differs from that of D65 on the grid by 3e-5; Bradford's
/// adaptation takes one to the other, so the perfect diffuser is exactly white.
fn weights() -> &'static [Spectrum; 3] {
    static WEIGHTS: LazyLock<[Spectrum; 3]> = LazyLock::new(|| {
        let d65 = light("D65").expect("D65 comes with this crate");
        let white = tristimulus(&d65).map(|v| v / tristimulus(&d65)[1]);
        let adapt = adaptation_matrix(&BRADFORD, white, D65_XYZ);
        let to_rgb = RgbSpace::LINEAR_SRGB.from_xyz_matrix().times(&adapt);
        let curves = cie1931().map(|curve| *curve * d65 * (1.0 / tristimulus(&d65)[1]));
        to_rgb.0.map(|[x, y, z]| curves[0] * x + curves[1] * y + curves[2] * z)
    });
    &WEIGHTS
}

/// Linear sRGB of a reflectance under D65, for the CIE 1931 observer; the perfect diffuser is 1, 1, 1.
pub fn rgb_of_reflectance(reflectance: &Spectrum) -> LinearSrgb {
    LinearSrgb(weights().each_ref().map(|weight| weight.dot(reflectance)))
}
