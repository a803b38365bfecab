//! Spectra over the band of the spectral colours.

use glanz_color::Spectrum;

use crate::chart::{Curve, WavelengthChart};
use crate::page::{curve_color, curve_dash};
use crate::words::Lang;

/// A spectrum and what it is called.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSpectrum {
    /// The name.
    pub name: String,
    /// Its values on the grid.
    pub spectrum: Spectrum,
}

/// The plot of one spectrum or of several.
///
/// ```
/// use glanz_plot::{Figure, NamedSpectrum, spectra};
///
/// let lamp = NamedSpectrum { name: "A".to_owned(), spectrum: glanz_color::light("A")? };
/// let chart = spectra("An incandescent lamp", "CIE illuminant A", "relative power", &[lamp]);
/// assert!(chart.svg()?.starts_with("<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn spectra(title: &str, subtitle: &str, label: &str, spectra: &[NamedSpectrum]) -> WavelengthChart {
    let curves = spectra.iter().enumerate().map(|(index, named)| Curve {
        name: named.name.clone(),
        points: named.spectrum.points().collect(),
        color: if spectra.len() == 1 { crate::page::style::INK } else { curve_color(index) },
        dash: curve_dash(index),
    });
    WavelengthChart {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        label: label.to_owned(),
        range_nm: (glanz_color::FIRST_NM, glanz_color::LAST_NM),
        curves: curves.collect(),
        marked: Vec::new(),
        lang: Lang::En,
    }
}
