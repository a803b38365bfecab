//! Re-radiation matrices of the Labsphere BFC-450, a bispectrometer: `.BFC`.
//!
//! Twelve lines of header: a vector's name and size, `BFC-450 Matrix File`, eight remarks behind
//! semicolons (file, sample, operator, …; they are skipped), the axes (`380 780 10 49 300 10`: first, last and step of
//! emission in nm; number, first and step of excitation), the wavelengths of excitation behind `r:c:`. Then
//! a line for each wavelength of emission, and `EOD`. Fields are separated by tabs. Values are per
//! emission band of the stated step; noise below 0 is left in (`Reradiation::from_measured` cuts it).

use crate::file::read::error::excerpt;
use crate::file::read::table::stem;
use crate::file::read::text::{Separator, decode, expect_number, fields, lines};
use crate::file::read::{NamedReradiation, Place, ReadError};
use crate::surfaces::reradiation::MOST_BANDS;

/// The line that tells the format, the second.
const MARK: &str = "BFC-450 Matrix File";
/// How far a wavelength may be from where the axes put it, in nm.
const SAME_NM: f64 = 0.01;

/// Reads the matrix of a BFC-450. `file` is its name for messages and, without its ending, the matrix's.
///
/// # Errors
///
/// [`ReadError`] tells the line and field that is not as this module says.
pub fn read_bfc(bytes: &[u8], file: &str) -> Result<NamedReradiation, ReadError> {
    let text = decode(bytes, file)?;
    let mut lines = Lines { file, rest: lines(&text), line: 0 };
    lines.next("the name and size of a vector")?;
    let mark = lines.next("'BFC-450 Matrix File'")?;
    if mark.trim() != MARK {
        return Err(lines.error("'BFC-450 Matrix File'", excerpt(mark)));
    }
    let axes = loop {
        let line = lines.next("a remark or the axes")?;
        if !line.starts_with(';') {
            break lines.axes(line)?;
        }
    };
    let Axes { out_nm, in_nm, band_nm } = axes;
    let head = lines.next("the wavelengths of excitation")?;
    let mut parts = fields(head, Separator::Char('\t'));
    if parts.next() != Some("r:c:") {
        return Err(lines.error("'r:c:' and the wavelengths of excitation", excerpt(head)));
    }
    lines.same(parts, &in_nm)?;
    let mut values = Vec::new();
    for out in &out_nm {
        let line = lines.next("a wavelength of emission and its values")?;
        lines.same(fields(line, Separator::Char('\t')).take(1), core::slice::from_ref(out))?;
        lines.values(line, in_nm.len(), &mut values)?;
    }
    let end = lines.next("EOD")?;
    match end.trim() {
        "EOD" => Ok(NamedReradiation { name: stem(file), out_nm, in_nm, values, band_nm, notes: Vec::new() }),
        _ => Err(lines.error("EOD after the last emission", excerpt(end))),
    }
}

/// The axes that the header tells.
struct Axes {
    out_nm: Vec<f64>,
    in_nm: Vec<f64>,
    band_nm: f64,
}

/// The file, line by line.
struct Lines<'a, I> {
    file: &'a str,
    rest: I,
    line: u64,
}

impl<'a, I: Iterator<Item = (u64, &'a str)>> Lines<'a, I> {
    /// The next line, which must be there.
    fn next(&mut self, expected: &str) -> Result<&'a str, ReadError> {
        match self.rest.next() {
            Some((line, text)) => {
                self.line = line;
                Ok(text)
            }
            None => Err(ReadError::malformed(self.file, Place::File, expected, "the end of the file")),
        }
    }

    fn error(&self, expected: impl Into<String>, found: impl Into<String>) -> ReadError {
        ReadError::malformed(self.file, Place::Line(self.line), expected, found)
    }

    /// The numbers of a line of fields.
    fn numbers(&self, line: &str) -> impl Iterator<Item = Result<f64, ReadError>> {
        let parts = fields(line, Separator::Char('\t')).enumerate();
        parts.filter(|(_, field)| !field.is_empty()).map(|(index, field)| {
            expect_number(field, false, self.file, || Place::Field {
                line: self.line,
                field: index as u64 + 1,
            })
        })
    }

    fn axes(&self, line: &str) -> Result<Axes, ReadError> {
        let expected = "first, last and step of emission, number, first and step of excitation";
        let numbers: Vec<f64> = self.numbers(line).take(7).collect::<Result<_, _>>()?;
        let Ok([first, last, step, count, in_first, in_step]) = <[f64; 6]>::try_from(numbers) else {
            return Err(self.error(expected, excerpt(line)));
        };
        let good = |first: f64, step: f64| first >= 10.0 && (0.1..=100.0).contains(&step);
        let rows = libm::round((last - first) / step) + 1.0;
        let bands = 2.0..=MOST_BANDS as f64;
        if !(good(first, step) && good(in_first, in_step) && bands.contains(&rows) && bands.contains(&count))
        {
            return Err(self.error(format!("{expected}, in nm, at most {MOST_BANDS}"), excerpt(line)));
        }
        let axis = |first: f64, step: f64, count: f64| {
            (0..count as usize).map(|i| first + step * i as f64).collect()
        };
        Ok(Axes { out_nm: axis(first, step, rows), in_nm: axis(in_first, in_step, count), band_nm: step })
    }

    /// Checks that fields are these wavelengths.
    fn same<'b>(&self, fields: impl Iterator<Item = &'b str>, axis: &[f64]) -> Result<(), ReadError> {
        let mut found = 0;
        for (index, field) in fields.filter(|field| !field.is_empty()).enumerate() {
            let place = || Place::Line(self.line);
            let nm = expect_number(field, false, self.file, place)?;
            match axis.get(index) {
                Some(expected) if (expected - nm).abs() <= SAME_NM => found += 1,
                Some(expected) => return Err(self.error(format!("{expected} nm"), format!("{nm}"))),
                None => return Err(self.error(format!("{} wavelengths", axis.len()), "more")),
            }
        }
        if found == axis.len() {
            Ok(())
        } else {
            Err(self.error(format!("{} wavelengths", axis.len()), found.to_string()))
        }
    }

    /// Appends the values behind the wavelength of a line.
    fn values(&self, line: &str, count: usize, values: &mut Vec<f64>) -> Result<(), ReadError> {
        let before = values.len();
        for value in self.numbers(line).skip(1).take(count + 1) {
            values.push(value?);
        }
        let found = values.len() - before;
        if found == count { Ok(()) } else { Err(self.error(format!("{count} values"), found.to_string())) }
    }
}
