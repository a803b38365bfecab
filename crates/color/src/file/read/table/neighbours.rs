//! Lines beside a table that should belong to it.

use super::axes::Axis;
use super::head::Head;
use super::lines::{Cell, Line, Run, cells};
use super::{MOST_SPECTRA, Source, reshape};
use crate::file::read::error::excerpt;
use crate::file::read::text::{Separator, fields};
use crate::file::read::units::LIKELY_NM;
use crate::file::read::{Place, ReadError};

/// One line too wide, or with a word in it, in the middle of a table must not end it silently.
pub(super) fn check_neighbours(
    source: &Source<'_>,
    separator: Separator,
    run: Run,
    head: &Head,
    axis: &Axis,
    values: &[Vec<f64>],
) -> Result<(), ReadError> {
    let known: Vec<f64> = values[axis.column].iter().copied().filter(|value| value.is_finite()).collect();
    let (Some(&first), Some(&last)) = (known.first(), known.last()) else { return Ok(()) };
    let step = (last - first).abs() / (known.len() - 1).max(1) as f64;
    // Wavelengths a few steps beyond an end belong to the table; where it has no steps, all that may be wavelengths.
    let continues = |value: f64, beyond: f64| match last - first {
        0.0 => value != first && axis.scale.is_likely(value),
        way => {
            let end = if beyond > 0.0 { last } else { first };
            (0.0..=20.0 * step).contains(&(beyond * way.signum() * (value - end)))
        }
    };
    let before = source.content[..run.first].iter().rev().find(|line| !line.is_comment);
    let after = source.content[run.end..].iter().find(|line| !line.is_comment);
    for (line, beyond) in [(before, -1.0), (after, 1.0)] {
        let Some(line) = line else { continue };
        let row = cells(line.text, separator, head.columns.len());
        let wavelength = row.get(axis.column).and_then(|cell| cell.value());
        if wavelength.is_some_and(|value| continues(value, beyond)) {
            check_row(source, separator, line, &row, run.width.max(head.columns.len()))?;
        }
    }
    Ok(())
}

/// Tells what is wrong with a line that should be one of numbers.
fn check_row(
    source: &Source<'_>,
    separator: Separator,
    line: &Line<'_>,
    row: &[Cell],
    width: usize,
) -> Result<(), ReadError> {
    if row.len() < 2 {
        return Err(ReadError::malformed(
            source.file,
            Place::Line(line.number),
            "a wavelength and at least one value",
            "one field",
        ));
    }
    if let Some(word) = row.iter().position(|cell| *cell == Cell::Word) {
        let text = fields(line.text, separator).nth(word).unwrap_or_default();
        let place = Place::Field { line: line.number, field: word as u64 + 1 };
        return Err(ReadError::malformed(source.file, place, "a number from -1e30 to 1e30", excerpt(text)));
    }
    let (expected, found) = match row.len() > width {
        true => (format!("at most {width} fields"), "more".to_owned()),
        false => (format!("{width} fields"), row.len().to_string()),
    };
    Err(ReadError::malformed(source.file, Place::Line(line.number), expected, found))
}

/// Why there is no table: the first line that begins like one tells, if there is one.
pub(super) fn no_numbers(source: &Source<'_>) -> ReadError {
    if reshape::is_values_alone(source) {
        let expected = "a wavelength beside each value; where the wavelengths are a file of their own, as in the USGS's library splib07, \
                        join both line by line: paste wavelengths.txt values.txt > both.txt";
        return ReadError::malformed(source.file, Place::File, expected, "one number in each line");
    }
    for line in source.content.iter().filter(|line| !line.is_comment) {
        let separator = Separator::of(line.text);
        let row = cells(line.text, separator, MOST_SPECTRA);
        let begins = row.first().and_then(|cell| cell.value()).is_some_and(|nm| LIKELY_NM.contains(&nm));
        if begins && let Err(error) = check_row(source, separator, line, &row, row.len()) {
            return error;
        }
    }
    let found = if source.content.is_empty() { "an empty file" } else { "none" };
    ReadError::malformed(source.file, Place::File, "lines of wavelengths and values", found)
}
