//! `glanz color wave`: light by its wavelength, frequency, wavenumber, energy and period.

use std::fmt::Write;

use clap::Args;
use glanz_color::units::{
    ELEMENTARY_CHARGE, frequency_hz, lambda_nm_of_energy, lambda_nm_of_frequency, lambda_nm_of_period,
    period_s, photon_energy_j,
};
use schemars::JsonSchema;
use serde::Serialize;

use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color wave 580nm
  glanz color wave 540THz
  glanz color wave 2.1eV 17000/cm 1.85fs --format json

λ = c T = c / f in vacuum, E = h f; c, h and e are those that define the SI (2019). Units: nm, µm
(um), m, Å; PHz, THz, GHz, Hz; 1/cm (cm-1); eV, J; fs, s.";

/// Options of `glanz color wave`.
#[derive(Args, Debug)]
pub(crate) struct WaveArgs {
    /// A number with its unit
    #[arg(value_name = "NUMBER UNIT", required = true)]
    light: Vec<String>,

    #[command(flatten)]
    format: FormatArgs,
}

/// Light of one wavelength.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Wave {
    /// As it was given
    given: String,
    /// Wavelength in vacuum, in nm
    nm: f64,
    /// Frequency in THz
    thz: f64,
    /// Wavenumber in 1/cm
    per_cm: f64,
    /// Energy of a photon in eV
    ev: f64,
    /// Period in fs
    fs: f64,
}

/// Light of each wavelength that was asked for.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    waves: Vec<Wave>,
}

impl WaveArgs {
    /// Tells the numbers.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let waves = joined(&self.light).into_iter().map(wave).collect::<Result<Vec<_>, _>>()?;
        if self.format.is_json() {
            return print::json(&Document { waves });
        }
        let mut text = String::new();
        for wave in &waves {
            writeln!(
                text,
                "{}: {} nm, {} THz, {} 1/cm, {} eV, {} fs",
                wave.given,
                number(wave.nm),
                number(wave.thz),
                number(wave.per_cm),
                number(wave.ev),
                number(wave.fs)
            )
            .expect("a string takes everything");
        }
        print::text(&text)
    }
}

/// The words, with a unit that stands alone put behind its number.
fn joined(words: &[String]) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    for word in words {
        match joined.last_mut() {
            Some(last) if last.parse::<f64>().is_ok() => *last += word,
            _ => joined.push(word.clone()),
        }
    }
    joined
}

fn wave(given: String) -> Result<Wave, Failure> {
    let nm = nanometres(&given).filter(|nm| nm.is_finite() && *nm > 0.0).ok_or_else(|| {
        Failure::Usage(format!(
            "'{given}': expected a number above 0 with its unit, such as 580nm, 540THz, 2.1eV, 17000/cm or 1.85fs"
        ))
    })?;
    Ok(Wave {
        given,
        nm,
        thz: frequency_hz(nm) * 1e-12,
        per_cm: 1e7 / nm,
        ev: photon_energy_j(nm) / ELEMENTARY_CHARGE,
        fs: period_s(nm) * 1e15,
    })
}

/// The wavelength of a number with a unit.
fn nanometres(text: &str) -> Option<f64> {
    let text = text.trim();
    // An `e` belongs to the number where digits follow, to eV where none do.
    let end = (1..=text.len())
        .rev()
        .filter(|end| text.is_char_boundary(*end))
        .find(|end| text[..*end].parse::<f64>().is_ok())?;
    let value: f64 = text[..end].parse().ok()?;
    match text[end..].trim() {
        "nm" => Some(value),
        "µm" | "μm" | "um" => Some(value * 1e3),
        "m" => Some(value * 1e9),
        "Å" | "A" => Some(value * 0.1),
        "PHz" => Some(lambda_nm_of_frequency(value * 1e15)),
        "THz" | "thz" => Some(lambda_nm_of_frequency(value * 1e12)),
        "GHz" => Some(lambda_nm_of_frequency(value * 1e9)),
        "Hz" => Some(lambda_nm_of_frequency(value)),
        "/cm" | "1/cm" | "cm-1" | "cm^-1" | "cm⁻¹" => Some(1e7 / value),
        "eV" | "ev" => Some(lambda_nm_of_energy(value)),
        "J" => Some(lambda_nm_of_energy(value / ELEMENTARY_CHARGE)),
        "fs" => Some(lambda_nm_of_period(value * 1e-15)),
        "s" => Some(lambda_nm_of_period(value)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_their_units() {
        for (text, nm) in [
            ("580nm", 580.0),
            ("0.58 µm", 580.0),
            ("5.8e-7m", 580.0),
            ("5800 Å", 580.0),
            ("540THz", 555.171),
            ("2.1eV", 590.401),
            ("17000/cm", 588.235),
            ("17000 cm-1", 588.235),
            ("1.85fs", 554.616),
        ] {
            let found = nanometres(text).unwrap_or_else(|| panic!("{text}"));
            assert!((found - nm).abs() < 1e-3, "{text}: {found}");
        }
        for text in ["580", "nm", "580 miles", "", "-"] {
            assert_eq!(nanometres(text), None, "{text}");
        }
        assert_eq!(joined(&["2.1".into(), "eV".into(), "580nm".into()]), ["2.1eV", "580nm"]);
    }
}
