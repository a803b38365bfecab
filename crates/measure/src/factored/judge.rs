//! How different a table looks with few of its ranks.

use glanz_color::difference::ciede2000;
use glanz_color::models::{D65_XYZ, Lab, RgbSpace, Xyz};
use glanz_color::{Observer, Outside, Spectrum, light, xyz_of_light, xyz_of_reflectance};

use crate::Channels;

/// Lights under which spectra are judged.
const LIGHTS: [&str; 3] = ["D65", "A", "FL11"];

/// Colours of channels under one light, for the CIE 1931 observer.
struct Light {
    white: Xyz,
    /// XYZ of each channel.
    columns: Vec<[f64; 3]>,
}

/// Nodes of a table with the colours that they have.
pub(super) struct Judge {
    lights: Vec<Light>,
    /// Of each node that is looked at the carrier's radiance factor, by channels, and the table's factors.
    nodes: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Judge {
    /// Of nodes with the radiance factors of the carrier and the factors over it.
    pub(super) fn new(channels: &Channels, nodes: Vec<(Vec<f64>, Vec<f64>)>) -> Self {
        Self { lights: lights(channels), nodes }
    }

    /// The ΔE00 that 95 of 100 nodes stay below, if channels are mixed of the chosen ones; of several lights the greatest.
    pub(super) fn difference(&self, chosen: &[usize], mix: &[Vec<f64>]) -> f64 {
        let mut all: Vec<f64> = Vec::with_capacity(self.nodes.len());
        for (carrier, factors) in &self.nodes {
            let exact: Vec<f64> =
                carrier.iter().zip(factors).map(|(carrier, factor)| carrier * factor).collect();
            let mixed: Vec<f64> = (0..carrier.len())
                .map(|c| {
                    let sum = chosen.iter().zip(mix).map(|(own, rank)| factors[*own] * rank[c]);
                    carrier[c] * sum.sum::<f64>()
                })
                .collect();
            let difference = |light: &Light| ciede2000(light.lab(&exact), light.lab(&mixed));
            all.push(self.lights.iter().map(difference).fold(0.0, f64::max));
        }
        all.sort_by(f64::total_cmp);
        all.get(all.len() * 95 / 100).copied().unwrap_or(0.0)
    }
}

impl Light {
    fn lab(&self, values: &[f64]) -> Lab {
        let sum = |i: usize| self.columns.iter().zip(values).map(|(xyz, value)| xyz[i] * value).sum::<f64>();
        // What no light is there of has the colour of black.
        Lab::for_white(Xyz([0, 1, 2].map(|i| sum(i).max(0.0))), self.white)
    }
}

fn lights(channels: &Channels) -> Vec<Light> {
    let one = |columns: Vec<[f64; 3]>| vec![Light { white: Xyz(D65_XYZ), columns }];
    match channels {
        Channels::Luminance => one(vec![D65_XYZ]),
        Channels::Xyz => one(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        Channels::Rgb => {
            let to_xyz = RgbSpace::LINEAR_SRGB.to_xyz_matrix();
            one([0, 1, 2].map(|c| to_xyz.apply([0, 1, 2].map(|i| f64::from(u8::from(i == c))))).to_vec())
        }
        Channels::Wavelengths(nm) => LIGHTS.iter().filter_map(|name| of_wavelengths(nm, name)).collect(),
    }
}

fn of_wavelengths(nm: &[f64], name: &str) -> Option<Light> {
    let (light, observer) = (light(name).ok()?, Observer::default());
    let column = |c: usize| {
        let values: Vec<f64> = (0..nm.len()).map(|i| f64::from(u8::from(i == c))).collect();
        let spectrum = Spectrum::from_table(nm, &values, Outside::Hold).unwrap_or(Spectrum::ZERO);
        xyz_of_reflectance(&spectrum, &light, &observer)
    };
    Some(Light { white: Xyz(xyz_of_light(&light, &observer)), columns: (0..nm.len()).map(column).collect() })
}
