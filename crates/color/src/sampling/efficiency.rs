//! Efficiency of representations of spectra: the error of colours that are computed with few numbers instead of
//! the whole spectrum.
//!
//! ```
//! use glanz_color::efficiency::Representation;
//! use glanz_color::{colorchecker, light};
//!
//! let patches: Vec<_> = colorchecker().map(|(_, reflectance)| reflectance).collect();
//! let d65 = light("D65")?;
//! let of_8 = Representation::Uniform(8).errors(&patches, &d65);
//! let of_32 = Representation::Uniform(32).errors(&patches, &d65);
//! assert!(of_32.mean < of_8.mean);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

use std::sync::LazyLock;

use crate::measures::colorimetry::lab;
use crate::measures::difference::ciede2000;
use crate::models::{ColorModel, LinearSrgb, Xyz};
use crate::observers::Observer;
use crate::sampling::meyer::{MeyerSamples, sample};
use crate::sampling::upsample::rgb_of_reflectance;
use crate::spectra::{FIRST_NM, LAST_NM, STEP_NM, Spectrum};

/// The numbers of uniform samples.
pub const COUNTS: std::ops::RangeInclusive<usize> = 3..=32;

/// A representation of spectra by few numbers, with which colours are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representation {
    /// So many wavelengths in the middles of equal bands of 300 … 780 nm, as the colour mode `sampled:N` takes them.
    Uniform(usize),
    /// The same of 400 … 700 nm, where the observer's sensitivity is concentrated.
    UniformVisible(usize),
    /// Linear sRGB of the light times that of the surface.
    Rgb,
    /// Meyer's four wavelengths with the published weights.
    Meyer,
    /// Meyer's four wavelengths with weights solved for the light.
    MeyerAdapted,
}

/// Errors over a set of surfaces, in ΔE00.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// The mean.
    pub mean: f64,
    /// What half of the surfaces do not exceed.
    pub median: f64,
    /// What 95 % of the surfaces do not exceed.
    pub p95: f64,
    /// The greatest.
    pub max: f64,
}

impl Representation {
    /// All representations, the fewest samples first within each kind.
    pub fn all() -> Vec<Self> {
        let uniform = COUNTS.map(Self::Uniform).chain(COUNTS.map(Self::UniformVisible));
        uniform.chain([Self::Rgb, Self::Meyer, Self::MeyerAdapted]).collect()
    }

    /// The name of its kind, whatever the number of samples.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform(_) => "uniform, 300-780 nm",
            Self::UniformVisible(_) => "uniform, 400-700 nm",
            Self::Rgb => "sRGB product",
            Self::Meyer => "Meyer, published",
            Self::MeyerAdapted => "Meyer, adapted",
        }
    }

    /// How many numbers stand for a spectrum.
    pub fn samples(self) -> usize {
        match self {
            Self::Uniform(count) | Self::UniformVisible(count) => count,
            Self::Rgb => 3,
            Self::Meyer | Self::MeyerAdapted => 4,
        }
    }

    /// X, Y, Z of a surface under a light in this representation; their scale is its own.
    fn xyz(self, surface: &Spectrum, light: &Spectrum) -> [f64; 3] {
        match self {
            // The outermost of the grid's bands reach half a step beyond its wavelengths.
            Self::Uniform(count) => {
                uniform(surface, light, count, (FIRST_NM - 0.5 * STEP_NM, LAST_NM + 0.5 * STEP_NM))
            }
            Self::UniformVisible(count) => uniform(surface, light, count, (400.0, 700.0)),
            Self::Rgb => {
                let LinearSrgb(light) = LinearSrgb::from_xyz(Xyz(tristimulus(light)));
                let LinearSrgb(surface) = rgb_of_reflectance(surface);
                LinearSrgb(core::array::from_fn(|i| light[i] * surface[i])).to_xyz().0
            }
            Self::Meyer => {
                let (surface, light) = (sample(surface), sample(light));
                MeyerSamples::published().xyz(core::array::from_fn(|i| surface[i] * light[i]))
            }
            Self::MeyerAdapted => MeyerSamples::adapted(light).xyz(sample(surface)),
        }
    }

    /// The errors over these surfaces under a light, against all 97 wavelengths.
    ///
    /// Each representation has a white of its own, the perfect diffuser computed with it, as a renderer that adapts
    /// to its white has: what counts is the error of colours, not that of the white.
    pub fn errors(self, surfaces: &[Spectrum], light: &Spectrum) -> Errors {
        let (white, white_true) = (self.xyz(&Spectrum::ONE, light), tristimulus(light));
        let error = |surface: &Spectrum| {
            let found = lab(self.xyz(surface, light), white);
            ciede2000(found, lab(tristimulus(&(*surface * *light)), white_true))
        };
        let mut errors: Vec<f64> = surfaces.iter().map(error).collect();
        errors.sort_by(f64::total_cmp);
        let at = |part: f64| {
            let index = (part * (errors.len().max(1) - 1) as f64).round() as usize;
            errors.get(index).copied().unwrap_or(f64::NAN)
        };
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        Errors { mean, median: at(0.5), p95: at(0.95), max: at(1.0) }
    }
}

/// The curves x, y, z of the CIE 1931 observer.
fn curves() -> &'static [Spectrum; 3] {
    static CURVES: LazyLock<[Spectrum; 3]> = LazyLock::new(|| {
        let observer = Observer::default();
        core::array::from_fn(|i| observer.channels[i].sensitivity)
    });
    &CURVES
}

/// X, Y, Z of light by all wavelengths.
fn tristimulus(light: &Spectrum) -> [f64; 3] {
    curves().each_ref().map(|curve| curve.dot(light))
}

/// A sum over wavelengths in the middles of equal bands.
fn uniform(surface: &Spectrum, light: &Spectrum, count: usize, (from, to): (f64, f64)) -> [f64; 3] {
    let band = (to - from) / count as f64;
    let nm = |index: usize| from + band * (index as f64 + 0.5);
    curves()
        .each_ref()
        .map(|curve| (0..count).map(|i| surface.at(nm(i)) * light.at(nm(i)) * curve.at(nm(i)) * band).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lights::light;
    use crate::surfaces::reflectances::colorchecker;

    fn mean(representation: Representation, name: &str) -> f64 {
        let patches: Vec<_> = colorchecker().map(|(_, spectrum)| spectrum).collect();
        representation.errors(&patches, &light(name).unwrap()).mean
    }

    #[test]
    fn all_97_wavelengths_make_no_error() {
        for name in ["D65", "A", "FL11"] {
            // The sum of f64 in another order.
            assert!(mean(Representation::Uniform(97), name) < 1e-9, "{name}");
        }
    }

    #[test]
    fn greys_have_no_error_in_any_representation() {
        let grey = [Spectrum::constant(0.2)];
        for representation in Representation::all() {
            let errors = representation.errors(&grey, &light("FL2").unwrap());
            assert!(errors.max < 1e-3, "{representation:?}: {errors:?}");
        }
    }

    #[test]
    fn the_known_errors_over_the_colorchecker_are_found() {
        // Mean ΔE00 against sums by 1 nm: Meyer 3.2 under E, 2.9 under D65, 9.4 under A; the product of
        // sRGB 4.2 under A; weights solved for A 2.3.
        for (representation, name, known) in [
            (Representation::Meyer, "E", 3.2),
            (Representation::Meyer, "D65", 2.9),
            (Representation::Meyer, "A", 9.4),
            (Representation::Rgb, "A", 4.2),
            (Representation::MeyerAdapted, "A", 2.3),
        ] {
            let found = mean(representation, name);
            assert!((found - known).abs() < 0.5, "{representation:?} under {name}: {found}, not {known}");
        }
        // The white of sRGB is given with four digits, which is what is left.
        assert!(mean(Representation::Rgb, "D65") < 1e-2, "the product of sRGB is made for D65");
    }
}
