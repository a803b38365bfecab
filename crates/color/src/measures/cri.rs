//! The CIE colour rendering index: how like daylight or a lamp a light shows colours.
//!
//! CIE 13.3-1995: fourteen test samples under the light and under a reference of the same correlated colour
//! temperature (a black body below 5000 K, a phase of daylight from there), the difference in CIE 1964
//! U\*V\*W\* after von Kries's adaptation in CIE 1960 u, v; Rᵢ = 100 − 4.6 ΔEᵢ. Sums are by 1 nm, the samples
//! interpolated (Sprague, CIE 167:2005); light below 360 nm, which is not seen, does not count.
//!
//! ```
//! use glanz_color::cri::color_rendering;
//! use glanz_color::light;
//!
//! // The general index of a fluorescent lamp is 64 (CIE 15), that of a lamp with a filament 100.
//! assert!((color_rendering(&light("FL2")?)?.ra - 64.0).abs() < 0.5);
//! assert!((color_rendering(&light("A")?)?.ra - 100.0).abs() < 0.1);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

use std::sync::LazyLock;

use crate::lights::fine_daylight;
use crate::lights::formulas::blackbody;
use crate::measures::chromaticity::{Chromaticity, tristimulus};
use crate::measures::temperature::{ColorTemperature, TemperatureError, color_temperature};
use crate::spectra::{FineSpectrum, Outside, Sampled};
use crate::surfaces::reflectances::fine_reflectance;

/// The number of test samples.
const SAMPLES: usize = 14;

/// The greatest distance from the Planckian locus for which CIE 13.3 calls the index meaningful.
pub const MOST_DUV: f64 = 5.4e-3;

/// The colour rendering of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorRendering {
    /// The general index: the mean of R1 to R8. 100 is like the reference; it may be negative.
    pub ra: f64,
    /// R1 to R14.
    pub r: [f64; SAMPLES],
    /// The light's temperature, by which the reference was chosen. Beyond [`MOST_DUV`] the light is not
    /// white, and the index means little.
    pub temperature: ColorTemperature,
}

/// Why a light has no colour rendering index.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RenderingError {
    /// Nothing of it is seen.
    #[error("expected a light that is seen, found one without X, Y, Z")]
    Unseen,
    /// It has no colour temperature.
    #[error("the light has no reference: {0}")]
    Temperature(#[from] TemperatureError),
    /// It is bluer than any daylight.
    #[error("expected a colour temperature of at most 25000 K, found {found_k} K; the series D ends there")]
    NoDaylight {
        /// The light's temperature.
        found_k: f64,
    },
}

/// The colour rendering index of a light, given on any scale.
///
/// # Errors
///
/// A light that is not seen or has no colour temperature, or none that a reference has.
pub fn color_rendering<S: Sampled>(test: &S) -> Result<ColorRendering, RenderingError> {
    let test = test.to_fine(Outside::Zero);
    let seen = Chromaticity::of_light(&test).ok_or(RenderingError::Unseen)?;
    let temperature = color_temperature(seen)?;
    let reference = reference(temperature.cct_k)?;
    let (test, reference) = (Viewed::under(&test), Viewed::under(&reference));
    let r = core::array::from_fn(|i| {
        let (a, b) = (test.sample(i, &reference), reference.sample(i, &reference));
        let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
        100.0 - 4.6 * squares.sum::<f64>().sqrt()
    });
    Ok(ColorRendering { ra: r[..8].iter().sum::<f64>() / 8.0, r, temperature })
}

/// The light that shows colours as they should be.
fn reference(cct_k: f64) -> Result<FineSpectrum, RenderingError> {
    if cct_k < 5000.0 {
        return Ok(blackbody(cct_k));
    }
    // The search for the temperature is exact to 1e-5: 25000 K may come out a little above.
    let series_end = 25_000.0;
    let kelvin = if cct_k < series_end * (1.0 + 1e-5) { cct_k.min(series_end) } else { cct_k };
    fine_daylight(kelvin).map_err(|_| RenderingError::NoDaylight { found_k: cct_k })
}

/// The reflectances of the test samples.
fn test_samples() -> &'static [FineSpectrum; SAMPLES] {
    static FINE: LazyLock<[FineSpectrum; SAMPLES]> = LazyLock::new(|| {
        let sample = |i: usize| fine_reflectance(&format!("tcs{i:02}"));
        core::array::from_fn(|i| sample(i + 1).expect("the test samples come with this crate"))
    });
    &FINE
}

/// The samples as a light shows them, Y = 100 for the perfect diffuser.
struct Viewed {
    white: [f64; 2],
    samples: [[f64; 3]; SAMPLES],
}

impl Viewed {
    fn under(light: &FineSpectrum) -> Self {
        let white = tristimulus(light);
        let samples = core::array::from_fn(|i| {
            tristimulus(&(&test_samples()[i] * light)).map(|response| 100.0 * response / white[1])
        });
        Self { white: uv(white), samples }
    }

    /// U\*, V\*, W\* of a sample, adapted to the reference.
    fn sample(&self, i: usize, reference: &Self) -> [f64; 3] {
        let ([c, d], [c_light, d_light]) = (adapting(uv(self.samples[i])), adapting(self.white));
        let [c_reference, d_reference] = adapting(reference.white);
        let (c, d) = (c * c_reference / c_light, d * d_reference / d_light);
        let by = 16.518 + 1.481 * c - d;
        let (u, v) = ((10.872 + 0.404 * c - 4.0 * d) / by, 5.520 / by);
        let w = 25.0 * libm::cbrt(self.samples[i][1]) - 17.0;
        [13.0 * w * (u - reference.white[0]), 13.0 * w * (v - reference.white[1]), w]
    }
}

/// c and d of CIE 13.3, section 5.7.
fn adapting([u, v]: [f64; 2]) -> [f64; 2] {
    [(4.0 - u - 10.0 * v) / v, (1.708 * v + 0.404 - 1.481 * u) / v]
}

/// CIE 1960 u, v of XYZ; those of equal energy where nothing is seen, which a seen light and samples that
/// reflect at every wavelength exclude.
fn uv(xyz: [f64; 3]) -> [f64; 2] {
    Chromaticity::of_xyz(xyz).unwrap_or(Chromaticity::E).uv1960()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::spectra::Spectrum;

    /// R1 to R14 by colour-science 0.4.7, `colour_rendering_index` ("CIE 1995").
    const KNOWN: [(&str, f64, [f64; SAMPLES]); 6] = [
        (
            "FL2",
            64.234,
            [
                56.05, 76.72, 90.32, 57.09, 59.03, 67.25, 74.15, 33.25, -83.59, 45.42, 46.03, 53.72, 60.35,
                94.06,
            ],
        ),
        (
            "FL4",
            51.479,
            [
                42.19, 69.91, 90.45, 37.96, 41.0, 53.81, 64.99, 11.51, -110.88, 31.54, 18.58, 25.13, 46.88,
                94.34,
            ],
        ),
        (
            "FL7",
            90.212,
            [89.18, 91.92, 90.87, 90.75, 90.35, 88.84, 92.6, 87.19, 60.98, 78.5, 88.72, 86.72, 89.74, 94.54],
        ),
        (
            "FL11",
            82.859,
            [98.23, 92.72, 51.09, 88.43, 87.21, 77.37, 88.62, 79.2, 24.94, 47.06, 72.48, 53.25, 97.11, 67.21],
        ),
        (
            "HP1",
            8.498,
            [
                -2.66, 61.52, 40.44, -26.21, -3.47, 51.94, 21.43, -75.01, -259.14, 42.77, -51.67, 26.46,
                7.53, 60.78,
            ],
        ),
        (
            "LED-B3",
            84.844,
            [83.61, 89.28, 93.24, 84.76, 83.74, 84.84, 88.21, 71.07, 23.76, 74.32, 83.74, 66.7, 84.74, 96.18],
        ),
    ];

    /// colour-science interpolates lights and samples to 1 nm and finds temperatures by Robertson's table:
    /// lights with lines differ by some tenths, most where Rᵢ is far below 0.
    fn tolerance(r: f64) -> f64 {
        0.5 + 0.01 * (100.0 - r)
    }

    #[test]
    fn lights_have_the_indices_of_colour_science() {
        for (name, ra, r) in KNOWN {
            let found = color_rendering(&light(name).unwrap()).unwrap();
            assert!((found.ra - ra).abs() < 0.5, "{name}: {found:?}");
            for (found, expected) in found.r.iter().zip(r) {
                assert!((found - expected).abs() < tolerance(expected), "{name}: {found}, not {expected}");
            }
        }
    }

    #[test]
    fn fluorescent_lamps_have_the_indices_that_the_cie_prints() {
        // CIE 15:2004, table T.7, in whole numbers.
        for (name, ra) in [("FL1", 76.0), ("FL2", 64.0), ("FL4", 51.0), ("FL7", 90.0), ("FL11", 83.0)] {
            let found = color_rendering(&light(name).unwrap()).unwrap().ra;
            assert!((found - ra).abs() < 0.7, "{name}: {found}");
        }
    }

    #[test]
    fn references_render_as_themselves() {
        for name in ["A", "D50", "D65", "D75"] {
            let found = color_rendering(&(light(name).unwrap() * 7.0)).unwrap();
            assert!(found.r.iter().all(|r| *r > 99.8), "{name}: {found:?}");
        }
    }

    #[test]
    fn the_end_of_the_daylight_series_is_a_reference() {
        assert!(color_rendering(&light("blackbody(25000)").unwrap()).is_ok());
        assert!(color_rendering(&light("blackbody(25100)").unwrap()).is_err());
    }

    #[test]
    fn lights_without_a_reference_are_refused() {
        assert_eq!(color_rendering(&Spectrum::ZERO), Err(RenderingError::Unseen));
        let blue = Spectrum::from_fn(|nm| if nm < 480.0 { 1.0 } else { 0.0 });
        assert!(matches!(color_rendering(&blue), Err(RenderingError::Temperature(_))));
        assert!(matches!(
            color_rendering(&blackbody::<Spectrum>(60_000.0)),
            Err(RenderingError::NoDaylight { .. })
        ));
    }
}
