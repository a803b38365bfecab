//! How a light shows colours: ANSI/IES TM-30-20 and CIE 224:2017.
//!
//! 99 evaluation samples under the light and under a reference of the same correlated colour temperature (a black body up to
//! 4000 K, a phase of daylight from 5000 K, a mixture in between), for the CIE 1964 observer, in CAM02-UCS. Fidelity
//! Rf = 10 ln(1 + exp((100 − 6.73 ΔE)/10)), of the mean ΔE; the general index of CIE 224 is the same number. Gamut Rg is the
//! area of the mean colours of 16 bins of hue over that of the reference. Sums are by 1 nm from 380 to 780 nm; the samples,
//! by 5 nm, are interpolated (Sprague, CIE 167:2005).
//!
//! ```
//! use glanz_color::fine_light;
//! use glanz_color::tm30::evaluate;
//!
//! let lamp = evaluate(&fine_light("FL2")?)?;
//! // A cool white fluorescent lamp: colours are untrue and dull, skin above all.
//! assert!((lamp.rf - 70.1).abs() < 0.1 && (lamp.rg - 86.4).abs() < 0.1);
//! assert!(lamp.bins[0].chroma_shift < -0.2, "reds lose a quarter of their chroma");
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod ucs;

use std::sync::LazyLock;

use crate::lights::fine_daylight;
use crate::lights::formulas::blackbody;
use crate::measures::chromaticity::Chromaticity;
use crate::measures::cri::RenderingError;
use crate::measures::temperature::{ColorTemperature, color_temperature};
use crate::observers::kept;
use crate::spectra::table::Table;
use crate::spectra::{FineSpectrum, Outside, Sampled};
use ucs::Adapted;

/// The number of evaluation samples.
pub const SAMPLES: usize = 99;

/// The number of bins of hue.
pub const BINS: usize = 16;

/// The wavelengths within which sums are taken, in nm.
const BAND_NM: core::ops::RangeInclusive<f64> = 380.0..=780.0;

/// The temperature up to which the reference is a black body, and that from which it is daylight, in K.
const MIXED_K: [f64; 2] = [4000.0, 5000.0];

/// By how much a unit of ΔE lowers the fidelity.
const SCALE: f64 = 6.73;

/// How a light shows colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendition {
    /// The fidelity index, 0 to 100: of TM-30-20, and the general one of CIE 224:2017.
    pub rf: f64,
    /// The gamut index: above 100 colours are more saturated than under the reference. NaN where no sample has some of the
    /// hues under the reference, as under black bodies of 1000 K.
    pub rg: f64,
    /// The fidelity of each sample, 0 to 100.
    pub samples: [f64; SAMPLES],
    /// The bins of hue, from red over yellow, green and blue.
    pub bins: [HueBin; BINS],
    /// The light's temperature, by which the reference was chosen.
    pub temperature: ColorTemperature,
}

/// The samples of one range of hue, 22.5° wide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HueBin {
    /// How many samples have that hue under the reference.
    pub samples: usize,
    /// The local fidelity Rf,h: 0 to 100.
    pub fidelity: f64,
    /// The local chroma shift Rcs,h: −0.1 is 10 % less chroma than under the reference.
    pub chroma_shift: f64,
    /// The local hue shift Rhs,h in radians; positive towards the next bin.
    pub hue_shift: f64,
    /// The mean a′, b′ under the reference.
    pub reference: [f64; 2],
    /// The mean a′, b′ under the light.
    pub test: [f64; 2],
    /// The point of the colour vector graphic, whose reference is the unit circle.
    pub vector: [f64; 2],
}

impl HueBin {
    /// The hue in the middle of a bin, in degrees.
    pub fn middle_deg(bin: usize) -> f64 {
        (bin as f64 + 0.5) * 360.0 / BINS as f64
    }
}

/// How a light shows colours, given on any scale.
///
/// # Errors
///
/// A light that is not seen or has no colour temperature, or none that a reference has.
pub fn evaluate<S: Sampled>(light: &S) -> Result<Rendition, RenderingError> {
    let light = light.to_fine(Outside::Zero);
    let seen = Chromaticity::of_light(&light).ok_or(RenderingError::Unseen)?;
    let temperature = color_temperature(seen)?;
    let reference = reference(temperature.cct_k)?;
    let (test, reference) = (under(&light), under(&reference));
    let distances: [f64; SAMPLES] = core::array::from_fn(|i| {
        let squares = test[i].iter().zip(reference[i]).map(|(a, b)| (a - b) * (a - b));
        squares.sum::<f64>().sqrt()
    });
    let bins = bins(&test, &reference, &distances);
    Ok(Rendition {
        rf: fidelity(distances.iter().sum::<f64>() / SAMPLES as f64),
        rg: 100.0 * area(bins.map(|bin| bin.test)) / area(bins.map(|bin| bin.reference)),
        samples: distances.map(fidelity),
        bins,
        temperature,
    })
}

/// The light that shows colours as they should be, within the band that sums are taken of.
///
/// # Errors
///
/// A temperature beyond that of the bluest daylight.
pub fn reference(cct_k: f64) -> Result<FineSpectrum, RenderingError> {
    let [low, high] = MIXED_K;
    let planck = || blackbody::<FineSpectrum>(cct_k);
    let daylight = |cct_k| fine_daylight(cct_k).map_err(|_| RenderingError::NoDaylight { found_k: cct_k });
    if cct_k <= low {
        return Ok(planck());
    }
    if cct_k >= high {
        return daylight(cct_k);
    }
    // Both as bright to the observer by which colours are told.
    let bright = |light: FineSpectrum| {
        let luminance = response(&light)[1];
        light * (1.0 / luminance)
    };
    let part = (cct_k - low) / (high - low);
    Ok(bright(planck()) * (1.0 - part) + bright(daylight(cct_k)?) * part)
}

/// Rf of a difference; never below 0.
fn fidelity(distance: f64) -> f64 {
    10.0 * libm::log1p(libm::exp((100.0 - SCALE * distance) / 10.0))
}

/// X, Y, Z of the CIE 1964 observer.
fn response(light: &FineSpectrum) -> [f64; 3] {
    let responses = light.responses(kept("cie1964"));
    core::array::from_fn(|i| responses[i])
}

fn samples() -> &'static [FineSpectrum; SAMPLES] {
    static FINE: LazyLock<[FineSpectrum; SAMPLES]> = LazyLock::new(|| {
        let table = Table::parse(include_str!("../../../data/evaluation_samples.csv"));
        let sample = |i: usize| table.sampled(&format!("ces{:02}", i + 1), Outside::Hold);
        core::array::from_fn(|i| sample(i).expect("the table has 99 samples"))
    });
    &FINE
}

/// J′, a′, b′ of the samples under a light, to which the eye is adapted.
fn under(light: &FineSpectrum) -> [[f64; 3]; SAMPLES] {
    let light = light.within(BAND_NM);
    let white = response(&light);
    let scale = 100.0 / white[1];
    let eye = Adapted::to(white.map(|v| scale * v));
    samples().each_ref().map(|sample| eye.jab(response(&(sample * &light)).map(|v| scale * v)))
}

/// The bin of a hue.
fn bin_of([_, a, b]: [f64; 3]) -> usize {
    let turn = libm::atan2(b, a) / core::f64::consts::TAU;
    ((turn - turn.floor()) * BINS as f64) as usize % BINS
}

fn bins(test: &[[f64; 3]], reference: &[[f64; 3]], distances: &[f64]) -> [HueBin; BINS] {
    core::array::from_fn(|bin| {
        let here: Vec<usize> = (0..SAMPLES).filter(|i| bin_of(reference[*i]) == bin).collect();
        let count = here.len();
        let mean = |of: &dyn Fn(usize) -> f64| here.iter().map(|i| of(*i)).sum::<f64>() / count as f64;
        let ab = |of: &[[f64; 3]]| [mean(&|i| of[i][1]), mean(&|i| of[i][2])];
        let (test, reference) = (ab(test), ab(reference));
        let chroma = libm::hypot(reference[0], reference[1]);
        let shift = [(test[0] - reference[0]) / chroma, (test[1] - reference[1]) / chroma];
        let (sin, cos) = libm::sincos(HueBin::middle_deg(bin).to_radians());
        HueBin {
            samples: count,
            fidelity: fidelity(mean(&|i| distances[i])),
            chroma_shift: shift[0] * cos + shift[1] * sin,
            hue_shift: shift[1] * cos - shift[0] * sin,
            reference,
            test,
            vector: [cos + shift[0], sin + shift[1]],
        }
    })
}

/// The area of a polygon.
fn area(corners: [[f64; 2]; BINS]) -> f64 {
    let next = |i: usize| corners[(i + 1) % BINS];
    (0..BINS).map(|i| corners[i][0] * next(i)[1] - next(i)[0] * corners[i][1]).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests;
