//! Re-radiation matrices in text tables.
//!
//! The first line holds a word, or nothing, and then the wavelengths of excitation; each line after it a
//! wavelength of emission and then the values. Separators and comments are as for spectra. The unit of
//! wavelength may stand in the first field (nm if none does), as may `%`. Values are fractions of the incident light per
//! emission band, whose width is the step of the lines.

use crate::file::read::error::excerpt;
use crate::file::read::named::note;
use crate::file::read::reradiation::step;
use crate::file::read::table::stem;
use crate::file::read::text::{Separator, decode, expect_number, fields, lines};
use crate::file::read::units::{Column, Scale};
use crate::file::read::{NamedReradiation, Place, ReadError};
use crate::surfaces::reradiation::MOST_BANDS;

/// Reads a re-radiation matrix from a text table. `file` is its name for messages.
///
/// # Errors
///
/// [`ReadError`] tells the line and field that is not as this module says.
pub fn read_matrix_csv(bytes: &[u8], file: &str) -> Result<NamedReradiation, ReadError> {
    let text = decode(bytes, file)?;
    let mut content =
        lines(&text).filter(|(_, line)| !line.trim().is_empty() && !line.trim().starts_with('#'));
    let Some((line, head)) = content.next() else {
        return Err(ReadError::malformed(file, Place::File, "a line of wavelengths", "an empty file"));
    };
    let separator = Separator::of(head);
    let corner = fields(head, separator).next().unwrap_or("");
    let table = Table { file, separator, scale: Scale::of(corner) };
    let mut matrix = NamedReradiation { name: stem(file), ..Default::default() };
    for (index, field) in fields(head, separator).enumerate().skip(1) {
        table.wavelength(&mut matrix.in_nm, field, line, index)?;
    }
    if matrix.in_nm.is_empty() {
        return Err(ReadError::malformed(
            file,
            Place::Line(line),
            "wavelengths of excitation",
            excerpt(head),
        ));
    }
    for (line, text) in content {
        table.row(&mut matrix, line, text)?;
    }
    settle(&mut matrix, &table, Column::of(corner).is_percent())?;
    Ok(matrix)
}

/// Takes the width of a band from the emission, and brings per cent to fractions.
fn settle(matrix: &mut NamedReradiation, table: &Table<'_>, percent: bool) -> Result<(), ReadError> {
    let Some((band, even)) = step(&matrix.out_nm) else {
        let found = format!("{}", matrix.out_nm.len());
        let expected = "at least 2 wavelengths of emission";
        return Err(ReadError::malformed(table.file, Place::File, expected, found));
    };
    matrix.band_nm = band;
    if !even {
        note(&mut matrix.notes, format!("emission has unequal steps: values are taken per {band} nm"));
    }
    if table.scale == Scale::Unknown {
        note(&mut matrix.notes, "no unit of wavelength given: taken as nm");
    }
    if percent {
        matrix.values.iter_mut().for_each(|value| *value /= 100.0);
    }
    Ok(())
}

/// How the table is written.
struct Table<'a> {
    file: &'a str,
    separator: Separator,
    scale: Scale,
}

impl Table<'_> {
    fn number(&self, field: &str, line: u64, index: usize) -> Result<f64, ReadError> {
        let place = || Place::Field { line, field: index as u64 + 1 };
        expect_number(field, self.separator.decimal_comma(), self.file, place)
    }

    /// Appends a wavelength to an axis.
    fn wavelength(&self, axis: &mut Vec<f64>, field: &str, line: u64, index: usize) -> Result<(), ReadError> {
        let place = || Place::Field { line, field: index as u64 + 1 };
        let nm = self.scale.nm(self.number(field, line, index)?, self.file, place)?;
        if let Some(before) = axis.last().filter(|before| nm <= **before) {
            let found = format!("{nm} nm after {before} nm");
            return Err(ReadError::malformed(self.file, place(), "rising wavelengths", found));
        }
        if axis.len() == MOST_BANDS {
            let (file, limit, found) = (self.file.to_owned(), MOST_BANDS as u64, MOST_BANDS as u64 + 1);
            return Err(ReadError::TooLarge { file, place: place(), limit, unit: "wavelengths", found });
        }
        axis.push(nm);
        Ok(())
    }

    /// Appends a line of values.
    fn row(&self, matrix: &mut NamedReradiation, line: u64, text: &str) -> Result<(), ReadError> {
        let mut parts = fields(text, self.separator).enumerate();
        let (_, first) = parts.next().unwrap_or((0, ""));
        self.wavelength(&mut matrix.out_nm, first, line, 0)?;
        let before = matrix.values.len();
        for (index, field) in parts.take(matrix.in_nm.len() + 1) {
            matrix.values.push(self.number(field, line, index)?);
        }
        let found = matrix.values.len() - before;
        if found != matrix.in_nm.len() {
            let expected = format!("{} values, one for each excitation", matrix.in_nm.len());
            let found = if found > matrix.in_nm.len() { "more".to_owned() } else { found.to_string() };
            return Err(ReadError::malformed(self.file, Place::Line(line), expected, found));
        }
        Ok(())
    }
}
