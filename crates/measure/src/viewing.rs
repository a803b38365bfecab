//! Colours of channels as they are seen: under a light, for the CIE 1931 observer.

use glanz_color::models::{D65_XYZ, Lab, RgbSpace, Xyz};
use glanz_color::{Observer, Outside, Spectrum, light, xyz_of_light, xyz_of_reflectance};

use crate::Channels;

/// Lights under which spectra are judged.
const LIGHTS: [&str; 3] = ["D65", "A", "FL11"];

/// Colours of channels under one light, for the CIE 1931 observer. The perfect diffuser that faces the light is white, Y = 1.
pub(crate) struct Viewing {
    white: Xyz,
    /// XYZ of each channel.
    columns: Vec<[f64; 3]>,
}

impl Viewing {
    /// Under D65. Channels that are no wavelengths have colours under D65 alone.
    pub(crate) fn under_d65(channels: &Channels) -> Self {
        let one = |columns: Vec<[f64; 3]>| Self { white: Xyz(D65_XYZ), columns };
        match channels {
            Channels::Luminance => one(vec![D65_XYZ]),
            Channels::Xyz => one(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            Channels::Rgb => {
                let to_xyz = RgbSpace::LINEAR_SRGB.to_xyz_matrix();
                one([0, 1, 2].map(|c| to_xyz.apply([0, 1, 2].map(|i| f64::from(u8::from(i == c))))).to_vec())
            }
            Channels::Wavelengths(nm) => Self::of_wavelengths(nm, LIGHTS[0]),
        }
    }

    /// Under each light that spectra are judged under.
    pub(crate) fn under_all(channels: &Channels) -> Vec<Self> {
        match channels {
            Channels::Wavelengths(nm) => LIGHTS.map(|name| Self::of_wavelengths(nm, name)).into(),
            other => vec![Self::under_d65(other)],
        }
    }

    fn of_wavelengths(nm: &[f64], name: &str) -> Self {
        let light = light(name).expect("it is a light of the catalogue");
        let observer = Observer::default();
        let column = |c: usize| {
            let values: Vec<f64> = (0..nm.len()).map(|i| f64::from(u8::from(i == c))).collect();
            let spectrum = Spectrum::from_table(nm, &values, Outside::Hold).unwrap_or(Spectrum::ZERO);
            xyz_of_reflectance(&spectrum, &light, &observer)
        };
        Self { white: Xyz(xyz_of_light(&light, &observer)), columns: (0..nm.len()).map(column).collect() }
    }

    /// X, Y and Z of each channel, where its radiance factor is 1 and those of the others are 0.
    pub(crate) fn columns(&self) -> &[[f64; 3]] {
        &self.columns
    }

    /// X, Y and Z of radiance factors, by channels.
    pub(crate) fn xyz(&self, factors: impl Iterator<Item = f64>) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (column, factor) in self.columns.iter().zip(factors) {
            sum.iter_mut().zip(column).for_each(|(sum, xyz)| *sum += xyz * factor);
        }
        sum
    }

    /// The colour of X, Y and Z. What no light is there of has the colour of black; above white nothing is cut off.
    pub(crate) fn lab(&self, xyz: [f64; 3]) -> Lab {
        Lab::for_white(Xyz(xyz.map(|value| value.max(0.0))), self.white)
    }
}
