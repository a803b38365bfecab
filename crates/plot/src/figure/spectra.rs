//! Spectra over the band of the spectral colours.

use glanz_color::Spectrum;

use super::curves::{Curve, Curves};
use super::picture::Picture;
use super::style::{curve, dash};

/// A spectrum and what it is called.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedCurve {
    /// The name.
    pub name: String,
    /// Its values on the grid.
    pub spectrum: Spectrum,
}

/// The plot of one spectrum or of several.
pub fn spectra(title: &str, subtitle: &str, label: &str, spectra: &[NamedCurve]) -> Picture {
    let curves = spectra.iter().enumerate().map(|(index, named)| Curve {
        name: named.name.clone(),
        points: named.spectrum.points().collect(),
        color: if spectra.len() == 1 { super::style::INK } else { curve(index) },
        dash: dash(index),
    });
    Curves {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        label: label.to_owned(),
        range_nm: (glanz_color::FIRST_NM, glanz_color::LAST_NM),
        curves: curves.collect(),
        marked: Vec::new(),
    }
    .picture()
}
