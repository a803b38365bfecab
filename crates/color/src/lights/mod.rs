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

pub(crate) mod formulas;
mod list;

use std::sync::LazyLock;

use thiserror::Error;

use crate::names::{UnknownName, plain};
use crate::observers::kept;
use crate::spectra::table::Table;
use crate::spectra::{FIRST_NM, FineSpectrum, LAST_NM, Outside, Sampled, Spectrum};

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
/// ```
/// use glanz_color::light;
///
/// assert_eq!(light("D65")?.at(560.0), 1.0);
/// // A lamp for fluorescence: as much ultraviolet as daylight.
/// let mixture = light("D65 + UV365")?;
/// assert!((mixture.integral() / light("D65")?.integral() - 1.0).abs() < 1e-12);
/// let error = light("FL22").unwrap_err();
/// assert_eq!(error.to_string(), "there is no light 'FL22'; did you mean 'FL2' or 'FL12'?");
/// # Ok::<_, glanz_color::UnknownName>(())
/// ```
///
/// # Errors
///
/// [`UnknownName`] suggests near names, or says which numbers are possible.
pub fn light(name: &str) -> Result<Spectrum, UnknownName> {
    sampled(name)
}

/// The same by 1 nm, for numbers: formulas at each nm, the CIE's tables interpolated (Sprague, CIE 167:2005).
///
/// # Errors
///
/// [`UnknownName`], as for [`light`].
pub fn fine_light(name: &str) -> Result<FineSpectrum, UnknownName> {
    sampled(name)
}

/// A light, as it is drawn or by 1 nm.
fn sampled<S: Sampled>(name: &str) -> Result<S, UnknownName> {
    let parts: Vec<&str> = name.split('+').collect();
    match parts[..] {
        [one] => single(one),
        _ if parts.len() > MOST_PARTS => {
            Err(wrong(name, format!("at most {MOST_PARTS} lights in a mixture")))
        }
        _ => mixture(&parts),
    }
}

/// The temperatures for which [`planck`] gives a spectrum, in K.
pub const PLANCK_RANGE_K: [f64; 2] = [500.0, 1e6];

/// The correlated colour temperatures for which daylight is defined, in K (CIE 15:2018, section 4.1.2).
pub const DAYLIGHT_RANGE_K: [f64; 2] = [4_000.0, 25_000.0];

/// Why there is no light of a temperature.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("expected {quantity} of {} to {} K, found {kelvin}", .range_k[0], .range_k[1])]
pub struct KelvinError {
    /// What the number should be.
    pub quantity: &'static str,
    /// The least and the greatest temperature, in K.
    pub range_k: [f64; 2],
    /// The number.
    pub kelvin: f64,
}

impl KelvinError {
    fn check(quantity: &'static str, range_k: [f64; 2], kelvin: f64) -> Result<f64, Self> {
        match (range_k[0]..=range_k[1]).contains(&kelvin) {
            true => Ok(kelvin),
            false => Err(Self { quantity, range_k, kelvin }),
        }
    }
}

/// The relative spectral power, per nm, of a black body of a temperature in K: 1 at 560 nm (Planck 1900, in vacuum, with
/// c₂ = 1.438776877·10⁷ nm K, SI 2019).
///
/// ```
/// use glanz_color::{light, planck};
///
/// let bulb = planck(2700.0)?;
/// assert_eq!(bulb.at(560.0), 1.0);
/// // The wavelength of the greatest power is 2897772 nm K over the temperature (Wien).
/// let sun = planck(5800.0)?;
/// let (peak_nm, _) = sun.points().max_by(|a, b| a.1.total_cmp(&b.1)).expect("97 points");
/// assert_eq!(peak_nm, 500.0);
/// // Illuminant A is the black body of 2856 K.
/// assert!((planck(2855.54)? - light("A")?).max() < 1e-4);
/// assert_eq!(
///     planck(20.0).unwrap_err().to_string(),
///     "expected a temperature of 500 to 1000000 K, found 20"
/// );
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// A temperature beyond [`PLANCK_RANGE_K`], or no number.
pub fn planck(kelvin: f64) -> Result<Spectrum, KelvinError> {
    KelvinError::check("a temperature", PLANCK_RANGE_K, kelvin).map(formulas::blackbody)
}

/// The relative spectral power, per nm, of daylight of a correlated colour temperature in K: 1 at 560 nm (CIE 15:2018,
/// section 4.1.2).
///
/// The factors of S1 and S2 are not rounded, so that there are no steps between near temperatures; the named lights D50,
/// D55, D65 and D75 ([`light`]) have rounded ones, as the CIE's tables do.
///
/// ```
/// use glanz_color::chromaticity::Chromaticity;
/// use glanz_color::temperature::color_temperature;
/// use glanz_color::{daylight, light};
///
/// let noon = daylight(5600.0)?;
/// let xy = Chromaticity::of_light(&noon).expect("it is seen");
/// assert!((color_temperature(xy)?.cct_k - 5600.0).abs() < 3.0);
/// // D65 is of 6504 K.
/// assert!((daylight(6504.0)? - light("D65")?).max() < 2e-3);
/// assert!(daylight(3000.0).is_err(), "the sun is not that red");
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// A temperature beyond [`DAYLIGHT_RANGE_K`], or no number.
pub fn daylight(cct_k: f64) -> Result<Spectrum, KelvinError> {
    KelvinError::check("a colour temperature", DAYLIGHT_RANGE_K, cct_k).map(formulas::daylight)
}

/// [`daylight`] by 1 nm.
pub(crate) fn fine_daylight(cct_k: f64) -> Result<FineSpectrum, KelvinError> {
    KelvinError::check("a colour temperature", DAYLIGHT_RANGE_K, cct_k).map(formulas::daylight)
}

fn mixture<S: Sampled>(parts: &[&str]) -> Result<S, UnknownName> {
    let lights: Vec<S> = parts.iter().map(|part| single(part)).collect::<Result<_, _>>()?;
    let each = lights[0].power() / lights.len() as f64;
    let scaled = |light: S| {
        let power = light.power();
        light * (each / power)
    };
    Ok(lights.into_iter().map(scaled).sum())
}

/// A light that is no mixture.
fn single<S: Sampled>(name: &str) -> Result<S, UnknownName> {
    if let Some(call) = Call::parse(name) {
        return call.light();
    }
    let plain = plain(name);
    match plain.as_str() {
        "a" => return Ok(formulas::illuminant_a()),
        "e" => return Ok(S::build(&|_| 1.0)),
        "uv365" => return Ok(formulas::gaussian(365.0, 20.0)),
        _ => {}
    }
    if let Some(digits) = plain.strip_prefix('d').filter(|rest| rest.bytes().all(|b| b.is_ascii_digit())) {
        match (digits.len(), digits.parse::<f64>()) {
            (2, Ok(hundreds)) if hundreds >= 40.0 => return Ok(formulas::daylight_named(hundreds)),
            (4.., Ok(cct)) => return daylight_by_name(name, cct),
            _ => {}
        }
    }
    tabled(&plain)
        .ok_or_else(|| UnknownName::not_found(KIND, name.trim(), lights().iter().map(|info| info.name)))
}

/// A light from the tables of CIE; `F2` is an older name of `FL2`.
fn tabled<S: Sampled>(plain: &str) -> Option<S> {
    let older = plain.strip_prefix('f').map(|rest| format!("fl{rest}"));
    let is_it = |name: &&str| {
        let known = name.to_lowercase();
        known == plain || older.as_ref() == Some(&known)
    };
    let name = TABLE.names().find(is_it)?;
    let spectrum: S = TABLE.sampled(name, Outside::Zero)?;
    let seen = |light: &S| light.responses(kept("photopic"))[0];
    Some(match name {
        "B" | "C" => spectrum * (1.0 / 100.0),
        _ => {
            let factor = seen(&S::build(&|_| 1.0)) / seen(&spectrum);
            spectrum * factor
        }
    })
}

fn daylight_by_name<S: Sampled>(name: &str, cct_k: f64) -> Result<S, UnknownName> {
    KelvinError::check("a colour temperature", DAYLIGHT_RANGE_K, cct_k)
        .map(formulas::daylight)
        .map_err(|_| wrong(name, "a colour temperature of 4000 to 25000 K".to_owned()))
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

    fn light<S: Sampled>(&self) -> Result<S, UnknownName> {
        let numbers = self.numbers.as_deref().unwrap_or(&[]);
        let grid = FIRST_NM..=LAST_NM;
        match (self.name.as_str(), numbers) {
            ("d", [cct]) => daylight_by_name(self.whole, *cct),
            ("blackbody", [kelvin]) => KelvinError::check("a temperature", PLANCK_RANGE_K, *kelvin)
                .map(formulas::blackbody)
                .map_err(|_| self.wrong()),
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
