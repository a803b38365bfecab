//! How the response of the eye grows with luminance: logarithm, cube root, saturation, and just noticeable steps.

use libm::{cbrt, log, log10, pow};

use super::within;

/// The logarithm of a luminance over a reference, in decades: the law of Weber and Fechner.
///
/// **Parameters** `luminance` and `reference` in the same unit, each held at 1e-30 and above.
/// **Limits** the threshold is a constant fraction of the luminance only by day; the law says nothing about the dark.
/// **Source** G. T. Fechner, "Elemente der Psychophysik", 1860.
///
/// ```
/// assert!((glanz_eye::curves::weber_fechner(1000.0, 1.0) - 3.0).abs() < 1e-15);
/// ```
pub fn weber_fechner(luminance: f64, reference: f64) -> f64 {
    let [luminance, reference] = [luminance, reference].map(|value| within(value, 1e-30, 1e30));
    log10(luminance) - log10(reference)
}

/// The lightness L* of a luminance relative to white, 0 to 100: the cube root of CIE 1976, linear near black.
///
/// **Parameters** `relative` Y/Yn, 0 to 1e6 (white is 1).
/// **Source** ISO/CIE 11664-4:2019.
///
/// ```
/// // Middle grey reflects 18 %.
/// assert!((glanz_eye::curves::lightness(0.18) - 49.5).abs() < 0.05);
/// ```
pub fn lightness(relative: f64) -> f64 {
    const EDGE: f64 = 216.0 / 24389.0;
    const SLOPE: f64 = 24389.0 / 27.0;
    let y = within(relative, 0.0, 1e6);
    if y > EDGE { 116.0 * cbrt(y) - 16.0 } else { SLOPE * y }
}

/// The saturating response of receptors, 0 to 1: Iⁿ/(Iⁿ + σⁿ).
///
/// **Parameters** `intensity` I and `semisaturation` σ in one unit, where the response is ½; `exponent` n, 0.01 to 10: 0.7 to 1 in receptors,
/// 0.73 in models of pictures.
/// **Source** K. I. Naka and W. A. H. Rushton, Journal of Physiology 185, 1966.
///
/// ```
/// assert_eq!(glanz_eye::curves::naka_rushton(50.0, 50.0, 0.73), 0.5);
/// ```
pub fn naka_rushton(intensity: f64, semisaturation: f64, exponent: f64) -> f64 {
    let (intensity, sigma) = (within(intensity, 0.0, 1e30), within(semisaturation, 1e-30, 1e30));
    1.0 / (1.0 + pow(sigma / intensity, within(exponent, 0.01, 10.0)))
}

/// The semisaturation σ of the cones that are adapted to a luminance, both in cd/m².
///
/// **Formula** 12.9223 G/(k⁴G + 0.171(1 − k⁴)²G^⅓), k = 1/(5G + 1).
/// **Parameters** `adapting` G in cd/m², held within 1e-8 and 1e8.
/// **Source** S. N. Pattanaik, J. Tumblin, H. Yee, D. P. Greenberg, "Time-dependent visual adaptation", SIGGRAPH 2000, after R. W. G. Hunt.
///
/// ```
/// assert!((glanz_eye::curves::cone_semisaturation(1.0) - 75.34525).abs() < 5e-6);
/// ```
pub fn cone_semisaturation(adapting: f64) -> f64 {
    let g = within(adapting, 1e-8, 1e8);
    let k = 1.0 / (5.0 * g + 1.0);
    let fourth = k * k * k * k;
    let rest = 1.0 - fourth;
    12.9223 * g / (fourth * g + 0.171 * rest * rest * cbrt(g))
}

/// The semisaturation σ of the rods that are adapted to a luminance, both in cd/m².
///
/// **Formula** 2.5874 G/(19000 j²G + 0.2615(1 − j²)⁴G^⅙), j = 1/(5e5·G + 1).
/// **Parameters** `adapting` G: scotopic luminance in cd/m², held within 1e-12 and 1e8.
/// **Source** as [`cone_semisaturation`]. One program that follows the paper has 5e4 in j, against its own comment and Hunt.
///
/// ```
/// assert!((glanz_eye::curves::rod_semisaturation(0.01) - 0.213156).abs() < 5e-7);
/// ```
pub fn rod_semisaturation(adapting: f64) -> f64 {
    let g = within(adapting, 1e-12, 1e8);
    let j = 1.0 / (5e5 * g + 1.0);
    let square = j * j;
    let rest = (1.0 - square) * (1.0 - square);
    2.5874 * g / (19_000.0 * square * g + 0.2615 * rest * rest * pow(g, 1.0 / 6.0))
}

/// The range of the grayscale standard display function in just noticeable steps.
const STEPS: (f64, f64) = (1.0, 1023.0);

/// The luminance in cd/m² of a number of just noticeable steps: the grayscale standard display function.
///
/// **Parameters** `index` j, 1 to 1023, from 0.05 to 3993 cd/m². The target is a grating of 2° with 4 cycles per degree (Barten's model).
/// **Source** DICOM PS3.14, equation B.1.
///
/// ```
/// assert!((glanz_eye::curves::gsdf_luminance(255.0) - 15.08309).abs() < 5e-6);
/// ```
pub fn gsdf_luminance(index: f64) -> f64 {
    let x = log(within(index, STEPS.0, STEPS.1));
    let above = horner(&[-1.301_187_7, 8.024_263_6e-2, 1.364_669_9e-1, -2.546_840_4e-2, 1.363_533_4e-3], x);
    let below =
        horner(&[1.0, -2.584_019_1e-2, -1.032_022_9e-1, 2.874_562_0e-2, -3.197_897_7e-3, 1.299_263_4e-4], x);
    pow(10.0, above / below)
}

/// How many just noticeable steps a luminance in cd/m² is: the inverse of [`gsdf_luminance`], to a tenth of a step.
///
/// **Parameters** `luminance`, 0.05 to 3993.4 cd/m².
/// **Source** DICOM PS3.14, equation B.2.
///
/// ```
/// assert!((glanz_eye::curves::gsdf_index(100.0) - 476.364).abs() < 5e-4);
/// ```
pub fn gsdf_index(luminance: f64) -> f64 {
    let x = log10(within(luminance, 0.05, 3993.404));
    let terms = [
        71.498_068,
        94.593_053,
        41.912_053,
        9.824_700_4,
        0.281_754_07,
        -1.187_845_5,
        -0.180_143_49,
        0.147_108_99,
        -0.017_046_845,
    ];
    horner(&terms, x)
}

/// The polynomial with these coefficients, that of x⁰ first.
fn horner(terms: &[f64], x: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * x + term)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    #[test]
    fn the_grayscale_function_has_the_values_of_dicom() {
        // eye.md 51–55; PS3.14 tabulates the first three as 0.0500, 15.0831 and 3993.4040.
        for (index, known) in [(1.0, "0.04998"), (255.0, "15.08309"), (1023.0, "3993.3296")] {
            assert_digits(gsdf_luminance(index), known);
        }
        assert_digits(gsdf_index(80.0), "446.882");
        assert_digits(gsdf_index(100.0), "476.364");
    }

    #[test]
    fn the_two_directions_of_the_grayscale_function_agree() {
        /// The published inverse is a fit.
        const FIT: f64 = 0.3;
        for index in (1..=1023).step_by(7).map(f64::from) {
            let back = gsdf_index(gsdf_luminance(index));
            assert!((back - index).abs() < FIT, "{index}: {back}");
        }
    }

    #[test]
    fn semisaturation_has_its_values() {
        // eye.md 56–58.
        assert_digits(cone_semisaturation(1.0), "75.34525");
        assert_digits(cone_semisaturation(100.0), "1628.085");
        assert_digits(rod_semisaturation(0.01), "0.213156");
    }

    #[test]
    fn in_the_dark_semisaturation_stays_above_0() {
        // The limits G → 0 of the formulas.
        assert!((cone_semisaturation(0.0) / 12.9223 - 1.0).abs() < 1e-3);
        assert!((rod_semisaturation(0.0) / (2.5874 / 19_000.0) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn lightness_is_that_of_the_colour_crate() {
        use glanz_color::Xyz;
        use glanz_color::models::Lab;
        for y in [0.0, 0.001, 0.0088, 0.009, 0.2, 1.0] {
            let known = Lab::for_white(Xyz([y, y, y]), Xyz([1.0, 1.0, 1.0])).0[0];
            assert!((lightness(y) - known).abs() < 1e-10, "{y}");
        }
    }

    #[test]
    fn receptors_saturate() {
        assert_eq!((naka_rushton(0.0, 1.0, 0.73), naka_rushton(1e30, 1e-30, 1.0)), (0.0, 1.0));
        assert!(naka_rushton(2.0, 1.0, 0.73) < naka_rushton(2.0, 1.0, 1.0));
    }
}
