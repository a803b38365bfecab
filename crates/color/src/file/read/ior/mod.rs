//! Readers of refractive indices: n and k over wavelength, as tables, as records of the refractiveindex.info database, and
//! as pairs of `.spd` files.

mod dispersion_formula;
mod record;
mod tables;
#[cfg(test)]
mod tests;

use super::table::stem;
use super::text::decode;
use super::{NamedSpectrum, Place, ReadError};
use crate::spectra::{FIRST_NM, LAST_NM};
use crate::{Ior, Spectrum};

/// The indices of refraction that are possible.
const POSSIBLE_N: std::ops::RangeInclusive<f64> = 1e-3..=20.0;

/// The extinction coefficients that are possible.
const POSSIBLE_K: std::ops::RangeInclusive<f64> = 0.0..=50.0;

/// Extinction coefficients down to this are noise of ellipsometers.
const NOISE: f64 = -0.02;

/// A complex refractive index n + i k of a file, at the wavelengths at which it was measured.
///
/// ```
/// use glanz_color::read::read_ior;
///
/// let table = "nm,n,k\n450,1.09,1.83\n550,0.53,2.77\n650,0.44,3.69\n";
/// let brass = read_ior(table.as_bytes(), "brass.csv")?;
/// let (medium, remarks) = brass.to_ior()?;
/// assert!((medium.k.at(500.0) - 2.3).abs() < 1e-12);
/// assert_eq!(remarks.len(), 2, "beyond their ends n and k are held: {remarks:?}");
/// # Ok::<(), glanz_color::read::ReadError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedIor {
    /// The file's name without folders and ending.
    pub name: String,
    /// The real part n.
    pub eta: NamedSpectrum,
    /// The extinction coefficient k; `None` if the file has none, as of glasses.
    pub k: Option<NamedSpectrum>,
    /// The publication that the file names; empty if it names none.
    pub source: String,
    /// What the reader had to assume or left out, in words.
    pub notes: Vec<String>,
}

impl NamedIor {
    /// The index on the grid, linear between its wavelengths and held at its ends, and in words where that is assumed.
    ///
    /// # Errors
    /// [`ReadError`] where a value is no refractive index, or none lies between 300 and 780 nm.
    pub fn to_ior(&self) -> Result<(Ior, Vec<String>), ReadError> {
        let mut notes = self.notes.clone();
        let eta = self.on_grid(&self.eta, "n", &POSSIBLE_N, &mut notes)?;
        let k = match &self.k {
            Some(k) => self.on_grid(k, "k", &POSSIBLE_K, &mut notes)?,
            None => Spectrum::ZERO,
        };
        Ok((Ior { name: self.name.clone(), eta, k, source: self.source.clone() }, notes))
    }

    fn on_grid(
        &self,
        part: &NamedSpectrum,
        what: &str,
        possible: &std::ops::RangeInclusive<f64>,
        notes: &mut Vec<String>,
    ) -> Result<Spectrum, ReadError> {
        let wrong = |expected: String, found: String| {
            Err(ReadError::malformed(&self.name, Place::File, &*expected, &*found))
        };
        let (Some(&first), Some(&last)) = (part.nm.first(), part.nm.last()) else {
            return wrong(format!("at least one value of {what}"), "none".to_owned());
        };
        if first > LAST_NM || last < FIRST_NM {
            return wrong(
                format!("{what} at wavelengths of which some lie between {FIRST_NM} and {LAST_NM} nm"),
                format!("{first} to {last} nm"),
            );
        }
        let below = part.values.iter().filter(|value| (NOISE..0.0).contains(*value)).count();
        let values: Vec<f64> =
            part.values.iter().map(|v| if (NOISE..0.0).contains(v) { 0.0 } else { *v }).collect();
        if what == "k" && below > 0 {
            notes.push(format!("{below} values of k below 0 are taken as noise: 0"));
        }
        let used = |nm: f64| (FIRST_NM - 50.0..=LAST_NM + 50.0).contains(&nm);
        let mut points = part.nm.iter().zip(&values);
        if let Some((nm, value)) = points.find(|(nm, value)| used(**nm) && !possible.contains(*value)) {
            let (least, most) = (possible.start(), possible.end());
            return wrong(format!("{what} from {least} to {most}"), format!("{value} at {nm} nm"));
        }
        if first > FIRST_NM || last < LAST_NM {
            let from = first.max(FIRST_NM);
            let to = last.min(LAST_NM);
            notes.push(format!(
                "{what} is known from {from} to {to} nm; beyond, the values at the ends are held"
            ));
        }
        Ok(Spectrum::from_fn(|nm| linear(&part.nm, &values, nm)))
    }
}

/// The value at a wavelength, linear between its neighbours. Unlike power or a reflectance, an index is not averaged over the
/// band of a sample: it is no amount of light.
fn linear(nm: &[f64], values: &[f64], at: f64) -> f64 {
    let above = nm.partition_point(|nm| *nm < at);
    match (above.checked_sub(1), nm.get(above)) {
        (Some(below), Some(end)) => {
            let t = (at - nm[below]) / (end - nm[below]);
            values[below] + (values[above] - values[below]) * t
        }
        (None, _) => values[0],
        (Some(last), None) => values[last],
    }
}

/// Reads a refractive index: a text table with a column of n and, of what absorbs, one of k (or one table below the other, as
/// refractiveindex.info exports them), or a record (YAML) of that database, with tables or one of its nine dispersion formulas.
///
/// A table without headers is one of wavelengths, n, and, with a third column, k. Wavelengths are in nm unless the file says
/// otherwise, or all of them are below 100: then they are in µm.
///
/// # Errors
/// [`ReadError`] tells what is missing.
pub fn read_ior(bytes: &[u8], file: &str) -> Result<NamedIor, ReadError> {
    let text = decode(bytes, file)?;
    match record::is_record(&text) {
        true => record::parse(&text, file),
        false => tables::parse(&text, file),
    }
}

/// Reads n from one file and k from another, as pbrt and Mitsuba keep them: `Au.eta.spd` and `Au.k.spd`.
///
/// ```
/// use glanz_color::read::read_ior_pair;
///
/// let (n, k) = ("400 1.5\n700 1.4\n".as_bytes(), "400 1.9\n700 3.9\n".as_bytes());
/// let metal = read_ior_pair((n, "x.eta.spd"), (k, "x.k.spd"))?;
/// assert_eq!(metal.name, "x");
/// # Ok::<(), glanz_color::read::ReadError>(())
/// ```
///
/// # Errors
/// [`ReadError`] of either file.
pub fn read_ior_pair(n: (&[u8], &str), k: (&[u8], &str)) -> Result<NamedIor, ReadError> {
    let mut medium = NamedIor { name: half_name(n.1), ..NamedIor::default() };
    medium.eta = tables::only(n.0, n.1, &mut medium.notes)?;
    medium.k = Some(tables::only(k.0, k.1, &mut medium.notes)?);
    Ok(medium)
}

/// Beginnings or ends of names of files that hold n alone, and those of the files with k beside them.
const HALVES: [(&str, &str); 3] = [(".eta", ".k"), ("-eta", "-k"), ("_eta", "_k")];

/// Whether a file's name is that of n or k alone: `Au.eta.spd`, `Au.k.spd`.
pub(super) fn is_half(file: &str) -> bool {
    let Some((stem, ending)) = file.rsplit_once('.') else { return false };
    let lower = stem.to_ascii_lowercase();
    let is_half = |(n, k): &(&str, &str)| lower.ends_with(n) || lower.ends_with(k);
    ending.eq_ignore_ascii_case("spd") && HALVES.iter().any(is_half)
}

/// The name of the file with k beside one with n alone, by the names that pbrt and Mitsuba give to such files.
///
/// ```
/// use glanz_color::read::ior_partner;
///
/// assert_eq!(ior_partner("ior/Au.eta.spd").as_deref(), Some("ior/Au.k.spd"));
/// assert_eq!(ior_partner("Au.yml"), None);
/// ```
pub fn ior_partner(file: &str) -> Option<String> {
    let (stem, ending) = file.rsplit_once('.')?;
    let lower = stem.to_ascii_lowercase();
    let (n, k) = HALVES.iter().find(|(n, _)| lower.ends_with(n))?;
    let kept = &stem[..stem.len() - n.len()];
    Some(format!("{kept}{k}.{ending}"))
}

/// The name of the medium whose half a file has.
fn half_name(file: &str) -> String {
    let stem = stem(file);
    let lower = stem.to_ascii_lowercase();
    let half = HALVES.iter().find(|(n, _)| lower.ends_with(n));
    half.map_or(stem.clone(), |(n, _)| stem[..stem.len() - n.len()].to_owned())
}
