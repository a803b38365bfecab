//! Spectra in text tables: `.csv`, `.tsv`, `.txt`.
//!
//! A column of wavelengths and one of values for each spectrum, or a row for each spectrum under a row
//! of wavelengths. Separators are tab, semicolon, comma or blanks; with all but the comma, numbers may
//! have a decimal comma. Lines that begin with `#` and empty ones are skipped. The last line before the
//! first number is the header, from which names, quantities and units come (`Wavelength (µm)`,
//! `sample 1 reflectance (%)`); lines above it are skipped, with a remark. A field without a value is a
//! wavelength at which that spectrum was not measured.

use super::error::{clean, excerpt};
use super::named::{note, settle_percent};
use super::text::{Separator, decode, expect_number, fields, lines, number};
use super::units::{Column, LIKELY_NM, MAX_NAME, Scale, terahertz_per_nm};
use super::{NamedSpectrum, Place, Quantity, ReadError};

/// The most spectra of a file.
pub(super) const MOST_SPECTRA: usize = 10_000;

/// Reads the spectra of a text table. `file` is its name for messages, and, without its ending, that of a
/// spectrum that has no other.
///
/// # Errors
///
/// [`ReadError`] tells the line and field that is not as this module says.
pub fn read_csv(bytes: &[u8], file: &str) -> Result<Vec<NamedSpectrum>, ReadError> {
    let text = decode(bytes, file)?;
    let mut notes = Vec::new();
    let content = lines(&text).filter(|(_, line)| !line.trim().is_empty() && !line.trim().starts_with('#'));
    let mut header = None;
    let mut body = content.clone();
    let separator = loop {
        let here = body.clone();
        let Some((at, line)) = body.next() else {
            let found = if header.is_some() { "none" } else { "an empty file" };
            return Err(ReadError::malformed(file, Place::File, "lines of wavelengths and values", found));
        };
        let separator = Separator::of(line);
        if is_wavelength_row(line, separator) {
            return rows(&Source { file, separator, notes }, (at, line), body);
        }
        if fields(line, separator)
            .next()
            .is_some_and(|field| number(field, separator.decimal_comma()).is_some())
        {
            body = here;
            break separator;
        }
        if let Some((skipped, text)) = header.replace((at, line)) {
            note(&mut notes, format!("line {skipped} skipped: {}", excerpt(text)));
        }
    };
    columns(&Source { file, separator, notes }, header, body)
}

/// What is known of a file before its numbers.
struct Source<'a> {
    file: &'a str,
    separator: Separator,
    notes: Vec<String>,
}

impl Source<'_> {
    fn number(&self, text: &str, line: u64, field: usize) -> Result<f64, ReadError> {
        let place = || Place::Field { line, field: field as u64 + 1 };
        expect_number(text, self.separator.decimal_comma(), self.file, place)
    }

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
}

/// The name of a file without folders and ending.
pub(super) fn stem(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    clean(stem, MAX_NAME)
}

/// Whether a line holds a word and then wavelengths: the head of a table with a spectrum in each row.
fn is_wavelength_row(line: &str, separator: Separator) -> bool {
    let mut parts = fields(line, separator);
    let corner = parts.next().unwrap_or("");
    if number(corner, separator.decimal_comma()).is_some() {
        return false;
    }
    let (mut before, mut count) = (0.0, 0);
    for field in parts {
        let Some(nm) = wavelength(field, separator) else { return false };
        if nm <= before || !LIKELY_NM.contains(&nm) {
            return false;
        }
        (before, count) = (nm, count + 1);
    }
    count >= 2
}

/// A wavelength that may have its unit behind it.
fn wavelength(field: &str, separator: Separator) -> Option<f64> {
    number(field.strip_suffix("nm").unwrap_or(field), separator.decimal_comma())
}

/// Reads one spectrum per row.
fn rows<'a>(
    source: &Source<'_>,
    (_, head): (u64, &str),
    body: impl Iterator<Item = (u64, &'a str)>,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let separator = source.separator;
    let nm: Vec<f64> =
        fields(head, separator).skip(1).filter_map(|field| wavelength(field, separator)).collect();
    let corner = Column::of(fields(head, separator).next().unwrap_or(""));
    let mut notes = source.notes.clone();
    if Scale::of(head) == Scale::Unknown
        && !fields(head, separator).skip(1).any(|field| field.ends_with("nm"))
    {
        note(&mut notes, "no unit of wavelength given: taken as nm");
    }
    let mut spectra = Vec::new();
    for (line, text) in body {
        let mut spectrum = row(source, &nm, line, text)?;
        if spectrum.name.is_empty() {
            spectrum.name = format!("{} {}", stem(source.file), spectra.len() + 1);
        }
        spectra.push(NamedSpectrum { quantity: corner.quantity, notes: notes.clone(), ..spectrum });
        source.check_count(spectra.len(), line)?;
    }
    if spectra.is_empty() {
        return Err(ReadError::malformed(source.file, Place::File, "lines with a name and values", "none"));
    }
    finish(&mut spectra, corner.is_percent());
    Ok(spectra)
}

/// Reads the spectrum of a row.
fn row(source: &Source<'_>, nm: &[f64], line: u64, text: &str) -> Result<NamedSpectrum, ReadError> {
    let malformed =
        |expected: &str, found: &str| ReadError::malformed(source.file, Place::Line(line), expected, found);
    let mut parts = fields(text, source.separator);
    let name = clean(parts.next().unwrap_or(""), MAX_NAME);
    let mut spectrum = NamedSpectrum { name, ..Default::default() };
    for (index, field) in parts.enumerate() {
        let Some(&nm) = nm.get(index) else {
            return Err(malformed(&format!("{} values, one for each wavelength", nm.len()), "more"));
        };
        if !field.is_empty() {
            spectrum.nm.push(nm);
            spectrum.values.push(source.number(field, line, index + 1)?);
        }
    }
    match spectrum.nm.is_empty() {
        true => Err(malformed("at least one value", &format!("none for {}", excerpt(&spectrum.name)))),
        false => Ok(spectrum),
    }
}

/// Reads one spectrum per column.
fn columns<'a>(
    source: &Source<'_>,
    header: Option<(u64, &str)>,
    body: impl Iterator<Item = (u64, &'a str)> + Clone,
) -> Result<Vec<NamedSpectrum>, ReadError> {
    let first = body.clone().next().unwrap_or((0, ""));
    let (scale, columns) = layout(source, header.map_or("", |(_, text)| text), first)?;
    let spectrum = |(index, column): (usize, &Column)| NamedSpectrum {
        name: match column.name.as_str() {
            "" => source.unnamed(index, columns.len()),
            name => name.to_owned(),
        },
        quantity: column.quantity,
        unit: if column.is_percent() { String::new() } else { column.unit.clone() },
        notes: source.notes.clone(),
        ..Default::default()
    };
    let mut spectra: Vec<NamedSpectrum> = columns.iter().enumerate().map(spectrum).collect();
    let mut order = Order::default();
    for (line, text) in body {
        let mut parts = fields(text, source.separator);
        let value = source.number(parts.next().unwrap_or(""), line, 0)?;
        let nm = scale.nm(value, source.file, || Place::Field { line, field: 1 })?;
        order.check(nm, source.file, line)?;
        for (index, field) in parts.enumerate().filter(|(_, field)| !field.is_empty()) {
            let Some(spectrum) = spectra.get_mut(index) else {
                let expected = format!("at most {} fields", columns.len() + 1);
                return Err(ReadError::malformed(source.file, Place::Line(line), expected, "more"));
            };
            spectrum.nm.push(nm);
            spectrum.values.push(source.number(field, line, index + 1)?);
        }
    }
    for (spectrum, column) in spectra.iter_mut().zip(&columns) {
        settle_column(spectrum, column, scale, order.falling());
    }
    drop_empty(&mut spectra, source.file)?;
    settle_percent(&mut spectra);
    Ok(spectra)
}

/// What the header and the first line of numbers say of the columns.
fn layout(
    source: &Source<'_>,
    header: &str,
    (line, first): (u64, &str),
) -> Result<(Scale, Vec<Column>), ReadError> {
    let found = fields(first, source.separator).count();
    let head: Vec<&str> = fields(header, Separator::of(header)).collect();
    // A line of other fields than the table has is a title: it holds for all columns.
    let by_blanks = source.separator == Separator::Blanks;
    let fits = head.len() == found && Separator::of(header) == Separator::Blanks;
    let is_title = head.len() < 2 || (by_blanks && !fits);
    let count = if is_title { found.saturating_sub(1) } else { head.len() - 1 };
    source.check_count(count, line)?;
    let column = |index: usize| match is_title {
        true => Column { name: String::new(), ..Column::of(header) },
        false => Column::of(head[index + 1]),
    };
    let scale = Scale::of(if is_title { header } else { head[0] });
    Ok((scale, (0..count).map(column).collect()))
}

/// Brings the values of a column to fractions and densities per nm, and into ascending order.
fn settle_column(spectrum: &mut NamedSpectrum, column: &Column, scale: Scale, falling: bool) {
    if falling {
        spectrum.nm.reverse();
        spectrum.values.reverse();
    }
    if column.is_percent() {
        spectrum.values.iter_mut().for_each(|value| *value /= 100.0);
        if spectrum.quantity == Quantity::Unknown {
            note(&mut spectrum.notes, "values in per cent, given as fractions");
        }
    }
    if scale == Scale::Unknown {
        note(&mut spectrum.notes, "no unit of wavelength given: taken as nm");
    }
    if column.is_per_terahertz() {
        for (value, nm) in spectrum.values.iter_mut().zip(&spectrum.nm) {
            *value *= terahertz_per_nm(*nm);
        }
        note(&mut spectrum.notes, "densities per THz converted to densities per nm");
    } else if scale == Scale::Terahertz && !spectrum.quantity.is_ratio() && !column.is_percent() {
        note(
            &mut spectrum.notes,
            "values over frequency taken as densities per nm, since no unit says per THz",
        );
    }
}

/// Removes columns without any value; at least one spectrum must stay.
fn drop_empty(spectra: &mut Vec<NamedSpectrum>, file: &str) -> Result<(), ReadError> {
    let empty: Vec<String> = spectra.iter().filter(|s| s.nm.is_empty()).map(|s| excerpt(&s.name)).collect();
    spectra.retain(|spectrum| !spectrum.nm.is_empty());
    if spectra.is_empty() {
        return Err(ReadError::malformed(file, Place::File, "at least one value", "none"));
    }
    for name in empty.iter().take(4) {
        spectra.iter_mut().for_each(|s| note(&mut s.notes, format!("column {name} has no values")));
    }
    Ok(())
}

/// Fractions of a table in per cent, said or seen.
fn finish(spectra: &mut [NamedSpectrum], percent: bool) {
    if percent {
        spectra.iter_mut().flat_map(|spectrum| &mut spectrum.values).for_each(|value| *value /= 100.0);
    } else {
        settle_percent(spectra);
    }
}

/// Watches that wavelengths only rise or only fall.
#[derive(Default)]
struct Order {
    before: Option<f64>,
    falls: Option<bool>,
}

impl Order {
    fn check(&mut self, nm: f64, file: &str, line: u64) -> Result<(), ReadError> {
        if let Some(before) = self.before.replace(nm) {
            let falls = nm < before;
            if nm == before || self.falls.is_some_and(|known| known != falls) {
                let expected = if self.falls == Some(true) { "falling" } else { "rising" };
                let found = format!("{nm} nm after {before} nm");
                let expected = format!("wavelengths in {expected} order, each once");
                return Err(ReadError::malformed(file, Place::Line(line), expected, found));
            }
            self.falls = Some(falls);
        }
        Ok(())
    }

    fn falling(&self) -> bool {
        self.falls == Some(true)
    }
}
