//! Spectra in text tables: `.csv`, `.tsv`, `.txt`, and what instruments call otherwise.
//!
//! The table is the longest run of lines that hold numbers only, as many in each; all else is head or foot. A spectrum is a
//! column beside one of wavelengths, or a row under a row of wavelengths. Separators are tab, semicolon, comma or blanks; with
//! all but the comma, numbers may have a decimal comma. Comments begin with `#`, `%`, `!`, `//` or `;`.
//!
//! Names, quantities and units come from the lines right above the numbers (`Wavelength (µm)`, `sample 1 reflectance
//! (%)`), a row of units of its own among them, and, where those say nothing, from what is said further up. A field without a
//! value is a wavelength at which that spectrum was not measured. A line that continues the table, but has a word or more fields
//! in it, is an error; what else is left out is told in a remark.

mod axes;
mod bands;
mod columns;
mod digitised;
mod digits;
mod head;
mod labelled;
mod lines;
mod neighbours;
mod number_like;
mod pieces;
mod points;
mod reshape;
mod rows;

use super::error::clean;
use super::named::note;
use super::units::{MAX_NAME, Scale};
use super::{NamedSpectrum, Place, Quantity, ReadError, read_as};
use crate::file::read::error::excerpt;
use crate::file::read::text::lines as text_lines;
use lines::Line;
use reshape::Reshaped;

/// Keys of the heads of meters that only light has.
const OF_LIGHT: [&str; 13] = [
    "ev",
    "lv",
    "tcp",
    "lux",
    "illuminance",
    "cct",
    "duv",
    "ppfd",
    "pfd",
    "cri",
    "fc",
    "foot candle",
    "correlated color temperature",
];

/// The most spectra of a file.
pub(super) const MOST_SPECTRA: usize = 10_000;

/// Reads the spectra of a text table. `file` is its name for messages, and, without its ending, that of a
/// spectrum that has no other.
///
/// # Errors
///
/// [`ReadError`] tells the line and field that is not as this module says.
pub fn read_csv(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    read_as(bytes, file, |text, file| parse(text, file, None))
}

/// The spectra of a text as the file has them, before their scale is settled.
pub(super) fn parse(text: &str, file: &str, unit: Option<Scale>) -> Result<Vec<NamedSpectrum>, ReadError> {
    let written = digits::plain(text);
    let text = &*written.text;
    if let Some(curves) = digitised::curves(text, file) {
        return spectra_of(curves?, file, Some(Scale::Nanometres));
    }
    let mut spectra = match (of_lines(&lines::content(text_lines(text)), file, unit), written.unsettled) {
        (Ok(spectra), _) => spectra,
        (Err(_), Some(unsettled)) => return Err(unsettled.error(file)),
        (Err((error, count)), None) => {
            let spectra = of_other_shape(text, file, unit, count)?;
            spectra.ok_or_else(|| with_told(error, written.told.as_deref()))?
        }
    };
    for spectrum in &mut spectra {
        written.told.iter().for_each(|told| note(&mut spectrum.notes, told.clone()));
    }
    Ok(spectra)
}

/// An error with what was made of the numbers: that may be why.
fn with_told(mut error: ReadError, told: Option<&str>) -> ReadError {
    if let (ReadError::Malformed { found, .. }, Some(told)) = (&mut error, told) {
        found.push_str(&format!(" ({told})"));
    }
    error
}

/// The spectra of lines that each hold a wavelength and its values, or all values of a spectrum. An error comes with the number
/// of lines that hold numbers alone.
fn of_lines(
    content: &[Line<'_>],
    file: &str,
    unit: Option<Scale>,
) -> Result<Vec<NamedSpectrum>, (ReadError, usize)> {
    let source = Source { file, content, unit };
    let found = lines::find(content);
    let (first, count) = found.map_or((0, 0), |(_, run)| (run.first, run.count));
    // Three numbers in the head of a long table are no wavelengths of rows.
    let is_table = |rows: &rows::Rows| {
        count < 3 || (rows.wavelengths() > 2 && (first <= rows.below() || count <= rows.wavelengths()))
    };
    let read = match (rows::find(content, unit).filter(is_table), found) {
        (Some(rows), _) => rows.read(&source),
        (None, Some((separator, run))) => columns::read(&source, separator, run),
        (None, None) => Err(neighbours::no_numbers(&source)),
    };
    read.map_err(|error| (error, count))
}

/// The spectra of a table of another shape, if it is one that is known; `count` lines hold numbers alone.
///
/// # Errors
///
/// Where the shape is known, but what it holds cannot be meant.
fn of_other_shape(
    text: &str,
    file: &str,
    unit: Option<Scale>,
    count: usize,
) -> Result<Option<Vec<NamedSpectrum>>, ReadError> {
    let spectra = match reshape::alternating(text) {
        Some(whole) => spectra_of([whole], file, unit),
        None => spectra_of(labelled::parts(text, count, file)?, file, unit),
    };
    Ok(spectra.ok().filter(|spectra| !spectra.is_empty()))
}

/// The spectra of the parts of a table.
fn spectra_of<'a>(
    parts: impl IntoIterator<Item = Reshaped<'a>>,
    file: &str,
    unit: Option<Scale>,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let mut spectra = Vec::new();
    for part in parts {
        let content = lines::content(part.lines.iter().map(|(number, line)| (*number, &**line)));
        for mut spectrum in of_lines(&content, file, unit).map_err(|(error, _)| error)? {
            spectrum.name = part.name.clone().map_or(spectrum.name, |name| clean(&name, MAX_NAME));
            spectrum.notes.splice(0..0, part.notes.iter().cloned());
            spectra.push(spectrum);
        }
        if spectra.len() > MOST_SPECTRA {
            let (file, limit, found) = (file.to_owned(), MOST_SPECTRA as u64, spectra.len() as u64);
            return Err(ReadError::TooLarge { file, place: Place::File, limit, unit: "spectra", found });
        }
    }
    Ok(spectra)
}

/// A file, as lines.
struct Source<'a> {
    file: &'a str,
    content: &'a [Line<'a>],
    /// The unit of wavelengths, if it is known from elsewhere.
    unit: Option<Scale>,
}

impl Source<'_> {
    /// The name of a spectrum that has none.
    fn unnamed(&self, index: usize, of: usize) -> String {
        let stem = stem(self.file);
        if of == 1 { stem } else { format!("{stem} {}", index + 1) }
    }

    fn check_count(&self, count: usize, line: u64) -> Result<(), ReadError> {
        if (1..=MOST_SPECTRA).contains(&count) {
            return Ok(());
        }
        if count == 0 {
            let (expected, found) = ("a wavelength and at least one value", "one field");
            return Err(ReadError::malformed(self.file, Place::Line(line), expected, found));
        }
        let (file, place) = (self.file.to_owned(), Place::Line(line));
        let (limit, found) = (MOST_SPECTRA as u64, count as u64);
        Err(ReadError::TooLarge { file, place, limit, unit: "spectra", found })
    }

    /// Tells what is not read, in one remark for the head and one for the foot.
    fn tell_skipped(&self, head: &[Line<'_>], foot: &[Line<'_>], notes: &mut Vec<String>) {
        for (lines, place) in [(head, "above"), (foot, "below")] {
            let skipped = || lines.iter().filter(|line| !line.is_comment);
            let Some(first) = skipped().next() else { continue };
            let text = excerpt(first.text);
            note(
                notes,
                match skipped().count() {
                    1 => format!("line {} skipped: {text}", first.number),
                    count => format!(
                        "{count} lines {place} the table skipped, the first of them line {}: {text}",
                        first.number
                    ),
                },
            );
        }
    }

    /// What the lines of a head say of all spectra, where their columns say nothing: the one quantity that is named.
    fn quantity_of(&self, head: &[Line<'_>]) -> Quantity {
        // What a line states alone comes before words among others, such as the power of a laser.
        let stated = only(head.iter().map(|line| Quantity::stated(line.text)));
        let found = match stated {
            Some(Quantity::Unknown) => {
                let words = head.iter().filter(|line| !is_setting(line.text));
                only(words.map(|line| Quantity::of(line.text)))
            }
            stated => stated,
        };
        // A lamp's irradiance and the reflectance of a standard: it is not said which.
        let Some(found) = found else { return Quantity::Unknown };
        let first =
            |line: &Line<'_>| is_of_light(line.text.split(['\t', ',', ';', ':']).next().unwrap_or_default());
        match found {
            // Only light has an illuminance and a colour temperature.
            Quantity::Unknown if head.iter().filter(|line| first(line)).count() >= 2 => Quantity::Light,
            found => found,
        }
    }
}

/// Whether a line of a head is a setting of the instrument: its laser's power, or what is on or off, as in
/// `Intensity Corrected,False`.
fn is_setting(line: &str) -> bool {
    let lower = line.trim().to_lowercase();
    let value = lower.rsplit([',', ';', '\t', ':', '=']).next().unwrap_or_default().trim();
    lower.starts_with("laser") || ["true", "false", "yes", "no", "on", "off"].contains(&value)
}

/// Whether a key of a meter, such as `CCT [K]`, is one that only light has.
fn is_of_light(key: &str) -> bool {
    let key = key.split(['[', '(']).next().unwrap_or_default().trim();
    OF_LIGHT.iter().any(|word| key.eq_ignore_ascii_case(word))
}

/// The one quantity among several; unknown of none, and nothing of two that differ.
fn only(quantities: impl Iterator<Item = Quantity>) -> Option<Quantity> {
    let mut found = Quantity::Unknown;
    for quantity in quantities.filter(|quantity| *quantity != Quantity::Unknown) {
        if found != Quantity::Unknown && quantity != found {
            return None;
        }
        found = quantity;
    }
    Some(found)
}

/// The name of a file without folders and ending.
pub(super) fn stem(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    clean(stem, MAX_NAME)
}
