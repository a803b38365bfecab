//! Records of the refractiveindex.info database: YAML with a list `DATA` of tables and dispersion formulas.

use saphyr::{LoadableYamlNode, Yaml};

use super::NamedIor;
use super::dispersion_formula::Formula;
use crate::file::read::error::{clean, excerpt};
use crate::file::read::table::stem;
use crate::file::read::{NamedSpectrum, Place, ReadError};
use crate::spectra::{FIRST_NM, LAST_NM, STEP_NM};

/// The most characters of a record: the database's longest has 0.6 million.
const MOST_CHARACTERS: usize = 4 << 20;

/// The most characters of the publication that are kept.
const MOST_SOURCE: usize = 400;

/// Deeper lists are no record.
const MOST_NESTING: usize = 64;

/// Whether a text is a record: a line is its key `DATA`.
pub(super) fn is_record(text: &str) -> bool {
    text.lines().any(|line| line.trim_end() == "DATA:" || line.starts_with("DATA: "))
}

/// Reads a record.
pub(super) fn parse(text: &str, file: &str) -> Result<NamedIor, ReadError> {
    let wrong = |expected: &str, found: &str| Err(ReadError::malformed(file, Place::File, expected, found));
    let depth = |open: char| text.chars().filter(|c| *c == open).count();
    if text.len() > MOST_CHARACTERS || depth('[').max(depth('{')) > MOST_NESTING {
        return wrong("a record of the refractiveindex.info database", "a longer or deeper one");
    }
    let documents = match Yaml::load_from_str(text) {
        Ok(documents) => documents,
        Err(error) => {
            let place = Place::Line(error.marker().line() as u64);
            return Err(ReadError::malformed(file, place, "YAML", error.info()));
        }
    };
    let root = documents.first();
    let Some(data) = root.and_then(|root| root.as_mapping_get("DATA")).and_then(Yaml::as_sequence) else {
        return wrong("a list 'DATA'", "none");
    };
    let mut medium = NamedIor { name: stem(file), source: source(root), ..NamedIor::default() };
    let mut eta = None;
    for entry in data {
        let part = Entry::read(entry, file)?;
        keep(&mut eta, part.n, "n", &mut medium.notes);
        keep(&mut medium.k, part.k, "k", &mut medium.notes);
    }
    match eta {
        Some(eta) => Ok(NamedIor { eta, ..medium }),
        None if medium.k.is_some() => wrong("a table or formula of n", "k alone"),
        None => wrong("a table or formula of n", "none"),
    }
}

/// Of several entries, that which knows most of the band counts.
fn keep(kept: &mut Option<NamedSpectrum>, new: Option<NamedSpectrum>, what: &str, notes: &mut Vec<String>) {
    let Some(new) = new else { return };
    let Some(old) = kept else {
        *kept = Some(new);
        return;
    };
    let is_wider = covered(&new) > covered(old);
    notes.push(format!("{what} is given more than once: that which covers most of 300 to 780 nm is taken"));
    if is_wider {
        *kept = Some(new);
    }
}

fn covered(part: &NamedSpectrum) -> f64 {
    let end = |nm: Option<&f64>| nm.map_or(FIRST_NM, |nm| nm.clamp(FIRST_NM, LAST_NM));
    end(part.nm.last()) - end(part.nm.first())
}

/// The publication, without the database's marks.
fn source(root: Option<&Yaml<'_>>) -> String {
    let text =
        root.and_then(|root| root.as_mapping_get("REFERENCES")).and_then(Yaml::as_str).unwrap_or_default();
    let mut plain = String::new();
    let mut is_mark = false;
    for c in text.chars() {
        match c {
            '<' => is_mark = true,
            '>' if is_mark => is_mark = false,
            _ if is_mark => {}
            c => plain.push(c),
        }
    }
    clean(&plain.split_whitespace().collect::<Vec<_>>().join(" "), MOST_SOURCE)
}

/// What an entry of `DATA` gives.
struct Entry {
    n: Option<NamedSpectrum>,
    k: Option<NamedSpectrum>,
}

impl Entry {
    fn read(entry: &Yaml<'_>, file: &str) -> Result<Self, ReadError> {
        let kind = entry.as_mapping_get("type").and_then(Yaml::as_str).unwrap_or_default();
        let words: Vec<&str> = kind.split_whitespace().collect();
        match words[..] {
            ["tabulated", "n"] => Ok(Self { n: Some(column(entry, 1, 2, file)?), k: None }),
            ["tabulated", "k"] => Ok(Self { n: None, k: Some(column(entry, 1, 2, file)?) }),
            ["tabulated", "nk"] => {
                Ok(Self { n: Some(column(entry, 1, 3, file)?), k: Some(column(entry, 2, 3, file)?) })
            }
            ["formula", number] => Ok(Self { n: Some(formula(entry, number, file)?), k: None }),
            // Thermal and other data stand beside those of the index.
            _ => {
                let expected =
                    "'type: tabulated nk', 'tabulated n', 'tabulated k' or 'formula 1' to 'formula 9'";
                Err(ReadError::malformed(file, Place::File, expected, excerpt(kind)))
            }
        }
    }
}

/// A column of a table of so many columns, of which the first has wavelengths in µm.
fn column(entry: &Yaml<'_>, column: usize, width: usize, file: &str) -> Result<NamedSpectrum, ReadError> {
    let text = entry.as_mapping_get("data").and_then(Yaml::as_str).unwrap_or_default();
    let mut points = Vec::new();
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        let row: Option<Vec<f64>> = line
            .split([' ', '\t', ','])
            .filter(|field| !field.is_empty())
            .map(|field| field.parse().ok().filter(|value: &f64| value.is_finite()))
            .collect();
        let Some(row) = row.filter(|row| row.len() == width) else {
            let expected = format!("lines of {width} numbers in 'data'");
            return Err(ReadError::malformed(file, Place::File, &*expected, excerpt(line)));
        };
        points.push((row[0] * 1e3, row[column]));
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by(|a, b| a.0 == b.0);
    let (nm, values) = points.into_iter().unzip();
    Ok(NamedSpectrum { nm, values, ..NamedSpectrum::default() })
}

/// A dispersion formula at the grid's wavelengths within its range, and at the ends of the range.
fn formula(entry: &Yaml<'_>, number: &str, file: &str) -> Result<NamedSpectrum, ReadError> {
    let wrong =
        |expected: &str, found: &str| Err(ReadError::malformed(file, Place::File, expected, excerpt(found)));
    let get = |key: &str| entry.as_mapping_get(key).map(numbers);
    let coefficients = get("coefficients").unwrap_or_default();
    let Some(formula) = number.parse().ok().and_then(|number| Formula::new(number, coefficients)) else {
        return wrong("a formula from 1 to 9 with 'coefficients'", number);
    };
    let range = get("wavelength_range").or_else(|| get("range")).unwrap_or_default();
    let (first, last) = match range[..] {
        [first, last] if first < last => (first * 1e3, last * 1e3),
        [] => (FIRST_NM, LAST_NM),
        _ => return wrong("'wavelength_range' of two rising numbers in µm", "others"),
    };
    let steps = ((LAST_NM - FIRST_NM) / STEP_NM) as usize;
    let inner = (0..=steps).map(|i| FIRST_NM + STEP_NM * i as f64).filter(|nm| *nm > first && *nm < last);
    let nm: Vec<f64> = [first].into_iter().chain(inner).chain([last]).collect();
    let values = nm.iter().map(|nm| formula.at(*nm)).collect();
    Ok(NamedSpectrum { nm, values, ..NamedSpectrum::default() })
}

/// The numbers of a value: one, or several between blanks.
fn numbers(value: &Yaml<'_>) -> Vec<f64> {
    match (value.as_str(), value.as_floating_point(), value.as_integer()) {
        (Some(text), ..) => text.split_whitespace().map_while(|word| word.parse().ok()).collect(),
        (_, Some(number), _) => vec![number],
        (.., Some(number)) => vec![number as f64],
        _ => Vec::new(),
    }
}
