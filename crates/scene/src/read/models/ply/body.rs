//! The values in the body of a PLY file, whichever way they are written.

use std::io::{self, BufRead};

use glanz_color::read::{Place, ReadError, excerpt};

use super::super::lines::{Lines, number};
use crate::read::notes::Notes;

use super::header::{Encoding, Property, Scalar};

/// A reader of values.
pub(super) enum Body<'a, R> {
    Text(Text<'a, R>),
    Binary(Binary<'a, R>),
}

/// Values as words, each record on its line.
pub(super) struct Text<'a, R> {
    lines: Lines<'a, R>,
    /// How much of the line has been read.
    used: usize,
    /// The first line with more values than the header tells, and how many there are.
    overlong: Option<(Place, u64)>,
    file: &'a str,
}

/// Values as bytes.
pub(super) struct Binary<'a, R> {
    reader: R,
    big: bool,
    file: &'a str,
    /// The record that is being read.
    item: (&'static str, u64),
}

impl<'a, R: BufRead> Body<'a, R> {
    /// The body behind a header of so many lines.
    pub(super) fn new(reader: R, encoding: Encoding, file: &'a str, line: u64) -> Self {
        match encoding {
            Encoding::Text => Self::Text(Text {
                lines: Lines::from_line(reader, file, line),
                used: 0,
                overlong: None,
                file,
            }),
            _ => Self::Binary(Binary { reader, big: encoding == Encoding::Big, file, item: ("record", 0) }),
        }
    }

    /// Goes to the next record, which is number `index` of the element `name`.
    pub(super) fn begin(&mut self, name: &str, index: u64) -> Result<(), ReadError> {
        match self {
            Self::Text(text) => text.begin(name, index),
            Self::Binary(binary) => {
                let name = match name {
                    "vertex" => "vertex",
                    "face" => "face",
                    "tristrips" => "strip",
                    _ => "record",
                };
                binary.item = (name, index);
                Ok(())
            }
        }
    }

    /// Ends the record; whether there was no more in its line than the header tells. What is left of it is passed over.
    pub(super) fn end(&mut self) -> bool {
        match self {
            Self::Text(text) if !text.lines.line()[text.used..].trim_ascii().is_empty() => {
                let place = text.lines.place();
                text.overlong.get_or_insert((place, 0)).1 += 1;
                false
            }
            _ => true,
        }
    }

    /// Tells of the lines with more values than the header tells.
    pub(super) fn tell(self, notes: &mut Notes) {
        if let Self::Text(Text { overlong: Some((place, count)), .. }) = self {
            let note =
                format!("PLY: more values in a line than the header tells are passed over ({count} lines)");
            notes.add_at(&note, place);
        }
    }

    /// Where the record is.
    pub(super) fn place(&self) -> Place {
        match self {
            Self::Text(text) => text.lines.place(),
            Self::Binary(binary) => Place::Item(binary.item.0, binary.item.1),
        }
    }

    /// An error at the record.
    pub(super) fn expected(&self, what: &str) -> ReadError {
        match self {
            Self::Text(text) => text.lines.expected(what),
            Self::Binary(binary) => ReadError::malformed(binary.file, self.place(), what, "another value"),
        }
    }

    /// The next value.
    pub(super) fn scalar(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        match self {
            Self::Text(text) => text.scalar(scalar),
            Self::Binary(binary) => binary.scalar(scalar),
        }
    }

    /// Gives the values of the next list, one by one. Errors of `each` say what was expected.
    pub(super) fn list(
        &mut self,
        property: &Property,
        mut each: impl FnMut(f64) -> Result<(), &'static str>,
    ) -> Result<(), ReadError> {
        let length = self.scalar(property.list.unwrap_or(property.scalar))?;
        if length < 0.0 {
            return Err(self.expected("a list whose length is not negative"));
        }
        // However long the list claims to be: the loop ends with the file.
        for _ in 0..length as u64 {
            let value = self.scalar(property.scalar)?;
            if let Err(what) = each(value) {
                return Err(self.expected(what));
            }
        }
        Ok(())
    }
}

impl<R: BufRead> Text<'_, R> {
    fn begin(&mut self, name: &str, index: u64) -> Result<(), ReadError> {
        self.used = 0;
        while self.lines.advance()? {
            if !self.lines.line().trim_ascii().is_empty() {
                return Ok(());
            }
        }
        let expected = format!("{name} {index}, as the header tells");
        Err(ReadError::malformed(self.file, self.lines.place(), expected, "the end of the file"))
    }

    fn scalar(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        let left = &self.lines.line()[self.used..];
        let start = left.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(left.len());
        let word = &left[start..];
        let word = &word[..word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len())];
        let used = self.used + start + word.len();
        let value = number(word).filter(|value| scalar.holds(*value));
        self.used = used;
        value.ok_or_else(|| {
            let what = if scalar.is_integer() {
                "a whole number of the type that the header tells"
            } else {
                "a finite number"
            };
            let found = if word.is_empty() { "the end of the line".to_owned() } else { excerpt(word) };
            ReadError::malformed(self.file, self.lines.place(), what, found)
        })
    }
}

impl<R: BufRead> Binary<'_, R> {
    fn scalar(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        let mut bytes = [0; 8];
        let bytes = &mut bytes[..scalar.size()];
        if let Err(error) = self.reader.read_exact(bytes) {
            let place = Place::Item(self.item.0, self.item.1);
            return Err(match error.kind() {
                io::ErrorKind::UnexpectedEof => {
                    let what = "as many values as the header tells";
                    ReadError::malformed(self.file, place, what, "the end of the file")
                }
                _ => ReadError::Io { file: self.file.to_owned(), place, source: error },
            });
        }
        if self.big {
            bytes.reverse();
        }
        Ok(value(scalar, bytes))
    }
}

/// The number that these little-endian bytes mean.
fn value(scalar: Scalar, bytes: &[u8]) -> f64 {
    let mut wide = [0; 8];
    wide[..bytes.len()].copy_from_slice(bytes);
    let word = u64::from_le_bytes(wide);
    match scalar {
        Scalar::I8 => f64::from(word as i8),
        Scalar::U8 => f64::from(word as u8),
        Scalar::I16 => f64::from(word as i16),
        Scalar::U16 => f64::from(word as u16),
        Scalar::I32 => f64::from(word as i32),
        Scalar::U32 => f64::from(word as u32),
        Scalar::F32 => f64::from(f32::from_bits(word as u32)),
        Scalar::F64 => f64::from_bits(word),
    }
}
