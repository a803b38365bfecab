//! Text tables of n and k.

use super::{HALVES, NamedIor};
use crate::file::read::table::{parse as parse_table, stem};
use crate::file::read::text::decode;
use crate::file::read::{NamedSpectrum, Place, ReadError, Scale};

/// Headers of the real part.
const REAL: [&str; 10] =
    ["n", "eta", "η", "ior", "index", "refractive index", "index of refraction", "re", "real", "nd"];

/// Headers of the extinction coefficient.
const EXTINCTION: [&str; 7] = ["k", "kappa", "κ", "extinction", "extinction coefficient", "im", "imag"];

/// All wavelengths below this, in nm, are in µm: X-rays have no refractive index of these tables.
const LEAST_NM: f64 = 100.0;

/// Reads tables of n and k, one beside the other or one below the other.
pub(super) fn parse(text: &str, file: &str) -> Result<NamedIor, ReadError> {
    let mut medium = NamedIor { name: stem(file), ..NamedIor::default() };
    let mut eta = None;
    let parts = sections(text);
    for part in &parts {
        let spectra = table(part, file)?;
        let is_bare = spectra.iter().all(|spectrum| part_of(&spectrum.name).is_none());
        if is_bare && parts.len() == 1 {
            return bare(spectra, file, medium);
        }
        for spectrum in spectra {
            match part_of(&spectrum.name) {
                Some(Part::Real) if eta.is_none() => eta = Some(spectrum),
                Some(Part::Extinction) if medium.k.is_none() => medium.k = Some(spectrum),
                _ => medium.notes.push(format!("column '{}' is neither n nor k: left out", spectrum.name)),
            }
        }
    }
    medium.eta = eta.ok_or_else(|| {
        let found = if medium.k.is_some() { "a column of k alone" } else { "none" };
        ReadError::malformed(file, Place::File, "a column named n", found)
    })?;
    for part in [Some(&medium.eta), medium.k.as_ref()].into_iter().flatten() {
        for note in &part.notes {
            if !medium.notes.contains(note) {
                medium.notes.push(note.clone());
            }
        }
    }
    Ok(medium)
}

/// The only column of a file.
pub(super) fn only(bytes: &[u8], file: &str, notes: &mut Vec<String>) -> Result<NamedSpectrum, ReadError> {
    let mut spectra = table(&decode(bytes, file)?, file)?;
    match (spectra.len(), spectra.pop()) {
        (1, Some(spectrum)) => {
            notes.extend(spectrum.notes.iter().map(|note| format!("{file}: {note}")));
            Ok(spectrum)
        }
        (count, _) => {
            let found = format!("{count} columns");
            Err(ReadError::malformed(file, Place::File, "one column beside that of wavelengths", &*found))
        }
    }
}

/// A table whose columns have no names, or none of n and k: n, and k if there is a second column.
fn bare(mut spectra: Vec<NamedSpectrum>, file: &str, mut medium: NamedIor) -> Result<NamedIor, ReadError> {
    let lower = stem(file).to_ascii_lowercase();
    if HALVES.iter().any(|(_, k)| lower.ends_with(k)) {
        let expected = "the file of n, whose name ends in 'eta' where this one ends in 'k'";
        return Err(ReadError::malformed(file, Place::File, expected, "the file of k"));
    }
    let is_other = spectra.iter().any(|spectrum| spectrum.quantity != Default::default());
    match (spectra.len(), is_other) {
        (1 | 2, false) => {}
        (count, _) => {
            let names: Vec<_> = spectra.iter().take(4).map(|spectrum| spectrum.name.as_str()).collect();
            let found = format!("{count} without: {}", names.join(", "));
            return Err(ReadError::malformed(file, Place::File, "columns named n and k", &*found));
        }
    }
    let notes = std::mem::take(&mut spectra[0].notes);
    medium.notes.extend(notes);
    medium.notes.push(match spectra.len() {
        1 => "one column without a name: taken as n, and k as 0".to_owned(),
        _ => "two columns without names: taken as n and k".to_owned(),
    });
    medium.k = if spectra.len() == 2 { spectra.pop() } else { None };
    medium.eta = spectra.remove(0);
    Ok(medium)
}

/// What a column is.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Real,
    Extinction,
}

fn part_of(header: &str) -> Option<Part> {
    let lower = header.trim().to_lowercase();
    let bare = lower.split(['(', '[', ',']).next().unwrap_or_default().trim_matches(['"', ' ', '_']);
    match (REAL.contains(&bare), EXTINCTION.contains(&bare)) {
        (true, _) => Some(Part::Real),
        (_, true) => Some(Part::Extinction),
        _ => None,
    }
}

/// The parts of a text that begin with a header of wavelength and n, or k, of their own.
fn sections(text: &str) -> Vec<String> {
    let is_header = |line: &str| {
        let mut fields = line.split([',', ';', '\t', ' ']).map(str::trim).filter(|field| !field.is_empty());
        let axis = fields.next().unwrap_or_default();
        let begins = axis.chars().next().is_some_and(char::is_alphabetic);
        begins && fields.next().is_some_and(|field| part_of(field).is_some())
    };
    let mut parts: Vec<String> = Vec::new();
    for line in text.lines() {
        if parts.is_empty()
            || (is_header(line) && parts.last().is_some_and(|part| part.lines().any(is_header)))
        {
            parts.push(String::new());
        }
        if let Some(part) = parts.last_mut() {
            part.push_str(line);
            part.push('\n');
        }
    }
    parts
}

/// The spectra of a table, in µm where they can be nothing else.
fn table(text: &str, file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    const UNSAID: &str = "no unit of wavelength given";
    let is_unsaid = |one: &NamedSpectrum| one.notes.iter().any(|note| note.starts_with(UNSAID));
    let as_nm = parse_table(text, file, None);
    if let Ok(spectra) = &as_nm
        && !spectra.iter().any(|one| is_unsaid(one) && one.nm.iter().all(|nm| *nm < LEAST_NM))
    {
        return as_nm;
    }
    match parse_table(text, file, Some(Scale::Micrometres)) {
        Ok(mut spectra) if spectra.iter().all(|one| one.nm.iter().all(|nm| *nm >= LEAST_NM)) => {
            for one in &mut spectra {
                one.notes.retain(|note| !note.starts_with(UNSAID));
                one.notes.push("no unit of wavelength given: taken as µm".to_owned());
            }
            Ok(spectra)
        }
        _ => as_nm,
    }
}
