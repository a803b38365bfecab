//! Classic and photometric units.

use std::ops::Range;

use glanz_color::{photometry, rgb_spectra};

use super::builder::Builder;
use crate::LightColor;
use crate::file::error::Problem;
use crate::file::tables::scene::AmbientTable;
use crate::file::tables::values::At;

impl Builder {
    pub(super) fn ambient(&mut self, table: &At<AmbientTable>) -> Result<LightColor, Problem> {
        let color = match (&table.color, &table.spectrum) {
            (Some(color), None) => self.light_color(color)?,
            (None, Some(spectrum)) => self.light_spectrum(spectrum)?,
            (None, None) => return Err(Problem::at(&table.span, "'color' is missing in [ambient]")),
            (Some(_), Some(spectrum)) => {
                let message = "'spectrum' beside 'color': only one can be the colour";
                return Err(Problem::at(&spectrum.span, message));
            }
        };
        match &table.luminance_cd_m2 {
            Some(luminance) => {
                self.units.photometric.push(luminance.span.clone());
                Ok(color.scaled(for_luminance(&color, luminance.0, &luminance.span)?))
            }
            None => {
                self.units.classic.extend((!color.is_black()).then(|| table.span.clone()));
                Ok(color)
            }
        }
    }

    /// Whether all light is in physical units; an error where some is and some is not.
    pub(super) fn one_kind_of_unit(&self, explicit: Option<&At<bool>>) -> Result<bool, Problem> {
        match (explicit, self.units.photometric.first()) {
            (Some(At { value: true, .. }), _) => return Ok(true),
            (Some(At { value: false, span }), Some(_)) => {
                return Err(Problem::at(
                    span,
                    "'photometric' is false, but there is light in lx, cd, W/sr or cd/m²",
                ));
            }
            _ => {}
        }
        let (Some(_), Some(classic)) = (self.units.photometric.first(), self.units.classic.first()) else {
            return Ok(!self.units.photometric.is_empty());
        };
        let message = "light in classic units beside light in lx, cd, W/sr or cd/m²";
        Err(Problem::at(classic, message)
            .help("give every light, the ambient one and all emission in physical units, or none"))
    }
}

/// The factor that gives light a luminance, or what makes one.
pub(super) fn for_luminance(color: &LightColor, value: f64, span: &Range<usize>) -> Result<f64, Problem> {
    color.luminance().map(|own| value / own).ok_or_else(|| {
        Problem::at(span, "light that the eye hardly sees cannot be given in photometric units")
            .help("give its radiant_intensity_w_sr, or the classic intensity")
    })
}

/// The factor that gives light a radiant power; as luminance of what it falls on, it counts in lumens.
pub(super) fn for_power(color: &LightColor, watts: f64) -> f64 {
    let power = match color {
        LightColor::Rgb(rgb) => rgb_spectra::spectrum_of_light(*rgb).integral(),
        LightColor::Spectrum(spectrum) => spectrum.integral(),
    };
    photometry::PHOTOPIC_LM_PER_W * watts / power
}
