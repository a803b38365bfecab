//! Mixing colours, as document 000 tells it: by adding light, or by taking it away.
//!
//! **Additive** (a screen): lights add up. What adds is light itself: spectra, XYZ, linear RGB, never code
//! values. **Subtractive** (a print): each layer lets a part of the light through, and the parts multiply,
//! wavelength by wavelength; in three channels that is an approximation.
//!
//! Nothing is clipped. Two colours are complementary where together they make white.
//!
//! ```
//! use glanz_color::mixing::{add_lights, complement, overprint};
//! use glanz_color::models::{Cmy, ColorModel, LinearSrgb, Srgb, Xyz};
//!
//! // Red and green light make yellow.
//! let lights = [Srgb([1.0, 0.0, 0.0]), Srgb([0.0, 1.0, 0.0])].map(Srgb::to_xyz);
//! let LinearSrgb(sum) = add_lights(lights).to();
//! assert!(sum.iter().zip([1.0, 1.0, 0.0]).all(|(found, expected)| (found - expected).abs() < 1e-12));
//! // Cyan over yellow ink prints green, the complement of magenta.
//! assert_eq!(overprint([Cmy([1.0, 0.0, 0.0]), Cmy([0.0, 0.0, 1.0])]), Cmy([1.0, 0.0, 1.0]));
//! assert_eq!(complement(LinearSrgb([1.0, 0.0, 1.0])), LinearSrgb([0.0, 1.0, 0.0]));
//! ```

use crate::models::{Cmy, Hls, LinearSrgb, Srgb, Xyz};
use crate::spectra::Spectrum;

/// The light of all lights together.
pub fn add_lights(lights: impl IntoIterator<Item = Xyz>) -> Xyz {
    let mut sum = [0.0; 3];
    for Xyz(light) in lights {
        sum = core::array::from_fn(|i| sum[i] + light[i]);
    }
    Xyz(sum)
}

/// The light of all lights together.
pub fn add_spectra<'a>(lights: impl IntoIterator<Item = &'a Spectrum>) -> Spectrum {
    lights.into_iter().fold(Spectrum::ZERO, |sum, light| sum + *light)
}

/// What an eye makes of small areas side by side, as of the phosphors of a screen: the mean, weighted by
/// area.
///
/// Weights need no sum of 1; where their sum is 0 there is nothing to see, and the result is black.
pub fn juxtapose(areas: impl IntoIterator<Item = (Xyz, f64)>) -> Xyz {
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    for (Xyz(light), area) in areas {
        sum = core::array::from_fn(|i| sum[i] + area * light[i]);
        total += area;
    }
    Xyz(if total == 0.0 { [0.0; 3] } else { sum.map(|v| v / total) })
}

/// What layers of these transmittances let through, one behind the other; for printed layers, what they
/// and the paper reflect.
pub fn multiply_spectra<'a>(layers: impl IntoIterator<Item = &'a Spectrum>) -> Spectrum {
    layers.into_iter().fold(Spectrum::ONE, |product, layer| product * *layer)
}

/// The same in linear RGB: right where the layers' spectra are flat within each third of the spectrum.
pub fn multiply_rgb(layers: impl IntoIterator<Item = LinearSrgb>) -> LinearSrgb {
    let mut product = [1.0; 3];
    for LinearSrgb(layer) in layers {
        product = core::array::from_fn(|i| product[i] * layer[i]);
    }
    LinearSrgb(product)
}

/// Inks over each other by code values: what is left of each primary is the product of what each ink
/// leaves, 1 − Π(1 − ink).
pub fn overprint(inks: impl IntoIterator<Item = Cmy>) -> Cmy {
    let mut left = [1.0; 3];
    for Cmy(ink) in inks {
        left = core::array::from_fn(|i| left[i] * (1.0 - ink[i]));
    }
    Cmy(left.map(|part| 1.0 - part))
}

/// The light that makes this one white: 1 − R, 1 − G, 1 − B of linear light.
///
/// Brighter lights than white have a complement with negative components.
pub fn complement(light: LinearSrgb) -> LinearSrgb {
    LinearSrgb(light.0.map(|c| 1.0 - c))
}

/// The complement in the sense of CMY: 1 − R, 1 − G, 1 − B of code values, a picture's negative.
pub fn negative(color: Srgb) -> Srgb {
    Srgb(color.0.map(|c| 1.0 - c))
}

/// The hue across the double cone, with the same lightness and saturation.
pub fn opposite_hue(Hls([hue, lightness, saturation]): Hls) -> Hls {
    let opposite = libm::fmod(hue + 180.0, 360.0);
    Hls([if opposite < 0.0 { opposite + 360.0 } else { opposite }, lightness, saturation])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::ColorModel;

    const RED: LinearSrgb = LinearSrgb([1.0, 0.0, 0.0]);
    const GREEN: LinearSrgb = LinearSrgb([0.0, 1.0, 0.0]);
    const BLUE: LinearSrgb = LinearSrgb([0.0, 0.0, 1.0]);
    const YELLOW: LinearSrgb = LinearSrgb([1.0, 1.0, 0.0]);
    const CYAN: LinearSrgb = LinearSrgb([0.0, 1.0, 1.0]);

    fn assert_same(found: LinearSrgb, expected: LinearSrgb) {
        for (a, b) in found.0.iter().zip(expected.0) {
            assert!((a - b).abs() < 1e-12, "{found:?} is not {expected:?}");
        }
    }

    #[test]
    fn two_additive_primaries_make_the_complement_of_the_third() {
        let sum = |a: LinearSrgb, b: LinearSrgb| add_lights([a.to_xyz(), b.to_xyz()]).to();
        assert_same(sum(RED, GREEN), YELLOW);
        assert_same(sum(RED, GREEN), complement(BLUE));
        assert_same(sum(GREEN, BLUE), complement(RED));
        assert_same(sum(YELLOW, complement(YELLOW)), LinearSrgb([1.0; 3]));
    }

    #[test]
    fn two_subtractive_primaries_make_an_additive_one() {
        assert_same(multiply_rgb([CYAN, YELLOW]), GREEN);
        assert_eq!(overprint([Cmy([1.0, 0.0, 0.0]), Cmy([0.0, 0.0, 1.0])]), Cmy([1.0, 0.0, 1.0]));
        assert_eq!(overprint([]), Cmy([0.0; 3]));
    }

    #[test]
    fn juxtaposition_weighs_by_area() {
        let white = Xyz::WHITE;
        let Xyz(mean) = juxtapose([(white, 1.0), (Xyz([0.0; 3]), 3.0)]);
        assert_eq!(mean, white.0.map(|v| v / 4.0));
        assert_eq!(juxtapose([]), Xyz([0.0; 3]));
    }

    #[test]
    fn spectra_add_and_multiply_by_wavelength() {
        let (half, ramp) = (Spectrum::constant(0.5), Spectrum::from_fn(|nm| nm / 780.0));
        assert_eq!(multiply_spectra([&half, &ramp]), ramp * 0.5);
        assert_eq!(add_spectra([&half, &half]), Spectrum::ONE);
    }

    #[test]
    fn opposite_hues_are_half_a_circle_apart() {
        assert_eq!(opposite_hue(Hls([210.0, 0.4, 0.8])), Hls([30.0, 0.4, 0.8]));
        assert_eq!(negative(Srgb([1.0, 0.25, 0.0])), Srgb([0.0, 0.75, 1.0]));
    }
}
