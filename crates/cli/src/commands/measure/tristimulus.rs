//! The channels of data as those of a format.

use glanz_color::models::RgbSpace;
use glanz_color::{Observer, Spectrum, light, xyz_of_reflectance};
use glanz_measure::Channels;

/// A linear map from some channels to others.
#[derive(Debug)]
pub(super) struct Conversion {
    pub(super) channels: Channels,
    /// Nothing where the channels stay as they are.
    rows: Option<Vec<Vec<f64>>>,
    /// What it takes the channels to be.
    pub(super) note: Option<String>,
}

const SRGB_NOTE: &str = "red, green and blue are taken as those of linear sRGB";

impl Conversion {
    /// To tristimulus values; one channel stays one.
    pub(super) fn to_xyz(from: &Channels) -> Self {
        let rows = match from {
            Channels::Luminance | Channels::Xyz => {
                return Self { channels: from.clone(), rows: None, note: None };
            }
            Channels::Rgb => matrix(RgbSpace::LINEAR_SRGB.to_xyz_matrix().0),
            Channels::Wavelengths(nm) => xyz_of_spectra(nm),
        };
        let note = match from {
            Channels::Rgb => SRGB_NOTE,
            _ => "X, Y and Z are those under D65, for the CIE 1931 observer",
        };
        Self { channels: Channels::Xyz, rows: Some(rows), note: Some(note.to_owned()) }
    }

    /// To red, green and blue of linear sRGB; one channel becomes three that are the same.
    pub(super) fn to_rgb(from: &Channels) -> Self {
        let from_xyz = RgbSpace::LINEAR_SRGB.from_xyz_matrix().0;
        let (rows, note) = match from {
            Channels::Rgb => return Self { channels: Channels::Rgb, rows: None, note: None },
            Channels::Luminance => (vec![vec![1.0]; 3], None),
            Channels::Xyz => (matrix(from_xyz), Some(SRGB_NOTE.to_owned())),
            Channels::Wavelengths(nm) => {
                let xyz = xyz_of_spectra(nm);
                let row = |row: [f64; 3]| {
                    (0..nm.len()).map(|i| (0..3).map(|c| row[c] * xyz[c][i]).sum()).collect::<Vec<f64>>()
                };
                (from_xyz.map(row).to_vec(), Some(SRGB_NOTE.to_owned()))
            }
        };
        Self { channels: Channels::Rgb, rows: Some(rows), note }
    }

    /// To what RGL's files have: colours or wavelengths.
    pub(super) fn to_rgl(from: &Channels) -> Self {
        match from {
            Channels::Wavelengths(_) => Self { channels: from.clone(), rows: None, note: None },
            _ => Self::to_rgb(from),
        }
    }

    /// The values of the channels.
    pub(super) fn apply(&self, values: Vec<f64>) -> Vec<f64> {
        let Some(rows) = &self.rows else { return values };
        rows.iter().map(|row| row.iter().zip(&values).map(|(weight, value)| weight * value).sum()).collect()
    }
}

fn matrix(rows: [[f64; 3]; 3]) -> Vec<Vec<f64>> {
    rows.iter().map(|row| row.to_vec()).collect()
}

/// X, Y and Z of reflectance spectra that are linear between wavelengths: rows of weights.
fn xyz_of_spectra(nm: &[f64]) -> Vec<Vec<f64>> {
    let d65 = light("D65").expect("D65 is a light of the catalogue");
    let observer = Observer::default();
    let columns: Vec<[f64; 3]> = (0..nm.len())
        .map(|i| xyz_of_reflectance(&Spectrum::from_fn(|at| share(nm, i, at)), &d65, &observer))
        .collect();
    (0..3).map(|c| columns.iter().map(|column| column[c]).collect()).collect()
}

/// How much a wavelength of a list counts at another one: from neighbour to neighbour, and beyond the ends of the list.
fn share(nm: &[f64], i: usize, at: f64) -> f64 {
    let own = nm[i];
    let neighbour = if at < own { i.checked_sub(1).map(|i| nm[i]) } else { nm.get(i + 1).copied() };
    neighbour.map_or(1.0, |other| (1.0 - (at - own) / (other - own)).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_perfect_diffuser_is_white_in_all_channels() {
        let nm: Vec<f64> = (0..36).map(|i| 380.0 + 10.0 * f64::from(i)).collect();
        for channels in [Channels::Rgb, Channels::Wavelengths(nm), Channels::Wavelengths(vec![550.0])] {
            let ones = vec![1.0; channels.count()];
            let [x, y, z] = Conversion::to_xyz(&channels).apply(ones.clone())[..] else {
                panic!("X, Y and Z")
            };
            assert!(
                (y - 1.0).abs() < 1e-6 && (x - 0.9505).abs() < 1e-3 && (z - 1.089).abs() < 2e-3,
                "{x} {y} {z}"
            );
            let rgb = Conversion::to_rgb(&channels).apply(ones);
            assert!(rgb.iter().all(|value| (value - 1.0).abs() < 2e-3), "{rgb:?}");
        }
        assert_eq!(Conversion::to_xyz(&Channels::Luminance).channels, Channels::Luminance);
        assert_eq!(Conversion::to_rgb(&Channels::Luminance).apply(vec![0.5]), [0.5; 3]);
    }
}
