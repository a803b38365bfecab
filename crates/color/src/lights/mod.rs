//! Lights by name.
//!
//! | name | scale |
//! |---|---|
//! | A, B, C, D50 … D75, `D(cct)`, E, `blackbody(T)` | CIE's, over 100: 1 at 560 nm (B 1.028, C 1.053) |
//! | FL1 … FL12, FL3.1 … FL3.15, HP1 … HP5, LED-… | as bright as E: ∫ S V = ∫ V (CIE gives no common scale) |
//! | `gaussian(nm, fwhm)`, UV365 | peak 1 |
//! | `line(nm)` | power 1 |
//! | mixtures, `D65+UV365` | equal power of each part within the grid, together that of the first |
//!
//! Sources of CIE that begin at 380 nm (FL, HP, LED) or 320 nm (B) are zero below; A and the D series
//! are real down to 300 nm. [`lights`] says it of each.

mod formulas;
mod list;

use std::sync::LazyLock;

use crate::names::{UnknownName, plain};
use crate::observers::photopic;
use crate::spectra::table::Table;
use crate::spectra::{FIRST_NM, LAST_NM, Outside, Spectrum};

pub use list::{LightInfo, lights};

const KIND: &str = "light";

/// The most parts of a mixture.
const MOST_PARTS: usize = 16;

static TABLE: LazyLock<Table> = LazyLock::new(|| Table::parse(include_str!("../../data/lights.csv")));

/// The relative spectrum of a light: power per nm, on the scale that this module's first page gives.
///
/// Names are those of [`lights`], in capital or small letters; names joined by `+` are a mixture in which
/// each part has the same radiant power within 300 … 780 nm.
///
/// # Errors
///
/// [`UnknownName`] suggests near names, or says which numbers are possible.
pub fn light(name: &str) -> Result<Spectrum, UnknownName> {
    let parts: Vec<&str> = name.split('+').collect();
    match parts[..] {
        [one] => single(one),
        _ if parts.len() > MOST_PARTS => {
            Err(wrong(name, format!("at most {MOST_PARTS} lights in a mixture")))
        }
        _ => mixture(&parts),
    }
}

fn mixture(parts: &[&str]) -> Result<Spectrum, UnknownName> {
    let lights = parts.iter().map(|part| single(part)).collect::<Result<Vec<_>, _>>()?;
    let each = lights[0].integral() / lights.len() as f64;
    Ok(lights.into_iter().map(|light| light * (each / light.integral())).fold(Spectrum::ZERO, |a, b| a + b))
}

/// A light that is no mixture.
fn single(name: &str) -> Result<Spectrum, UnknownName> {
    if let Some(call) = Call::parse(name) {
        return call.light();
    }
    let plain = plain(name);
    match plain.as_str() {
        "a" => return Ok(formulas::illuminant_a()),
        "e" => return Ok(Spectrum::ONE),
        "uv365" => return Ok(formulas::gaussian(365.0, 20.0)),
        _ => {}
    }
    if let Some(digits) = plain.strip_prefix('d').filter(|rest| rest.bytes().all(|b| b.is_ascii_digit())) {
        match (digits.len(), digits.parse::<f64>()) {
            (2, Ok(hundreds)) if hundreds >= 40.0 => return Ok(formulas::daylight_named(hundreds)),
            (4.., Ok(cct)) => return daylight(name, cct),
            _ => {}
        }
    }
    tabled(&plain)
        .ok_or_else(|| UnknownName::not_found(KIND, name.trim(), lights().iter().map(|info| info.name)))
}

/// A light from the tables of CIE; `F2` is an older name of `FL2`.
fn tabled(plain: &str) -> Option<Spectrum> {
    let older = plain.strip_prefix('f').map(|rest| format!("fl{rest}"));
    let is_it = |name: &&str| {
        let known = name.to_lowercase();
        known == plain || older.as_ref() == Some(&known)
    };
    let name = TABLE.names().find(is_it)?;
    let spectrum = TABLE.spectrum(name, Outside::Zero)?;
    Some(match name {
        "B" | "C" => spectrum * (1.0 / 100.0),
        _ => spectrum * (photopic().integral() / spectrum.dot(photopic())),
    })
}

fn daylight(name: &str, cct_k: f64) -> Result<Spectrum, UnknownName> {
    match (4000.0..=25000.0).contains(&cct_k) {
        true => Ok(formulas::daylight(cct_k)),
        false => Err(wrong(name, "a colour temperature of 4000 to 25000 K".to_owned())),
    }
}

fn wrong(name: &str, expected: String) -> UnknownName {
    UnknownName::Parameter { kind: KIND, name: name.trim().to_owned(), expected }
}

/// A name with numbers in brackets.
struct Call<'a> {
    whole: &'a str,
    name: String,
    numbers: Option<Vec<f64>>,
}

impl<'a> Call<'a> {
    fn parse(whole: &'a str) -> Option<Self> {
        let (name, rest) = whole.split_once('(')?;
        let inner = rest.trim_end().strip_suffix(')');
        let numbers = inner.and_then(|inner| inner.split(',').map(|cell| cell.trim().parse().ok()).collect());
        Some(Self { whole, name: plain(name), numbers })
    }

    fn light(&self) -> Result<Spectrum, UnknownName> {
        let numbers = self.numbers.as_deref().unwrap_or(&[]);
        let grid = FIRST_NM..=LAST_NM;
        match (self.name.as_str(), numbers) {
            ("d", [cct]) => daylight(self.whole, *cct),
            ("blackbody", [kelvin]) if (500.0..=1e6).contains(kelvin) => Ok(formulas::blackbody(*kelvin)),
            ("gaussian", [nm, fwhm]) if grid.contains(nm) && (0.01..=1000.0).contains(fwhm) => {
                Ok(formulas::gaussian(*nm, *fwhm))
            }
            ("line", [nm]) if grid.contains(nm) => Ok(formulas::line(*nm)),
            _ => Err(self.wrong()),
        }
    }

    fn wrong(&self) -> UnknownName {
        let is_known = ["d", "blackbody", "gaussian", "line"].contains(&self.name.as_str());
        if is_known && !self.whole.trim_end().ends_with(')') {
            return wrong(self.whole, format!("a closing bracket, as in '{})'", self.whole.trim()));
        }
        let expected = match self.name.as_str() {
            "d" => "D(cct) with a colour temperature of 4000 to 25000 K",
            "blackbody" => "blackbody(T) with a temperature of 500 to 1000000 K",
            "gaussian" => "gaussian(nm, fwhm) with a centre of 300 to 780 nm and a width of 0.01 to 1000 nm",
            "line" => "line(nm) with a wavelength of 300 to 780 nm",
            _ => {
                return UnknownName::not_found(
                    KIND,
                    self.whole.trim(),
                    lights().iter().map(|info| info.name),
                );
            }
        };
        wrong(self.whole, expected.to_owned())
    }
}

#[cfg(test)]
mod tests;
