//! Text, line by line.

use std::io::{BufRead, Read};

use glanz_color::read::{Place, ReadError, excerpt};

/// The longest line that is read: a file without line ends would else fill the memory.
const MAX_LINE: u64 = 64 << 20;

/// A reader of lines that counts them. Lines end with LF, CR LF, or the file.
pub(super) struct Lines<'a, R> {
    reader: R,
    file: &'a str,
    line: u64,
    bytes: Vec<u8>,
}

impl<'a, R: BufRead> Lines<'a, R> {
    pub(super) fn new(reader: R, file: &'a str) -> Self {
        Self::from_line(reader, file, 0)
    }

    /// A reader of what follows after so many lines.
    pub(super) fn from_line(reader: R, file: &'a str, line: u64) -> Self {
        Self { reader, file, line, bytes: Vec::new() }
    }

    /// How many lines were read.
    pub(super) fn count(&self) -> u64 {
        self.line
    }

    /// Goes to the next line; `false` at the end of the file.
    pub(super) fn advance(&mut self) -> Result<bool, ReadError> {
        self.bytes.clear();
        self.append()
    }

    /// Goes to the next line; where it ends with a backslash, the following ones are appended.
    pub(super) fn advance_joined(&mut self) -> Result<bool, ReadError> {
        if !self.advance()? {
            return Ok(false);
        }
        while self.bytes.last() == Some(&b'\\') {
            self.bytes.pop();
            self.bytes.push(b' ');
            if !self.append()? {
                break;
            }
        }
        Ok(true)
    }

    /// The line without its end.
    pub(super) fn line(&self) -> &[u8] {
        &self.bytes
    }

    /// An error at the line.
    pub(super) fn expected(&self, what: impl Into<String>) -> ReadError {
        ReadError::malformed(self.file, self.place(), what, excerpt(&self.bytes))
    }

    /// Appends the next line to the buffer.
    fn append(&mut self) -> Result<bool, ReadError> {
        let room = (MAX_LINE + 2).saturating_sub(self.bytes.len() as u64);
        let place = Place::Line(self.line + 1);
        let read = (&mut self.reader).take(room).read_until(b'\n', &mut self.bytes);
        let read = match read {
            Ok(read) => read,
            Err(source) => return Err(ReadError::Io { file: self.file.to_owned(), place, source }),
        };
        if read == 0 && room > 0 {
            return Ok(false);
        }
        self.line += 1;
        if self.bytes.last() == Some(&b'\n') {
            self.bytes.pop();
            if self.bytes.last() == Some(&b'\r') {
                self.bytes.pop();
            }
        }
        let found = self.bytes.len() as u64;
        if found > MAX_LINE {
            let (file, limit, unit) = (self.file.to_owned(), MAX_LINE, "bytes in a line");
            return Err(ReadError::TooLarge { file, place, limit, unit, found });
        }
        Ok(true)
    }

    /// The place of the line that was read last.
    pub(super) fn place(&self) -> Place {
        Place::Line(self.line)
    }

    /// The underlying reader, which stands behind the last line.
    pub(super) fn into_inner(self) -> R {
        self.reader
    }
}

/// The words of a line, separated by spaces and tabs.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> + Clone {
    line.split(|byte| byte.is_ascii_whitespace()).filter(|word| !word.is_empty())
}

/// The line after its keyword, as a name.
pub(super) fn rest(line: &[u8]) -> String {
    let line = line.trim_ascii();
    let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
    String::from_utf8_lossy(line[end..].trim_ascii()).into_owned()
}

/// A decimal number. NaN, infinity, and what overflows to it, are none.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    let value: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    value.is_finite().then_some(value)
}

/// A number for a 32-bit float.
pub(super) fn float(word: &[u8]) -> Option<f32> {
    let value: f32 = std::str::from_utf8(word).ok()?.parse().ok()?;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways_and_are_counted() {
        let mut lines = Lines::new(&b"a\r\nb\\\n c\nd"[..], "f");
        assert!(lines.advance_joined().unwrap());
        assert_eq!(lines.line(), b"a");
        assert!(lines.advance_joined().unwrap());
        assert_eq!((lines.line(), lines.place()), (&b"b  c"[..], Place::Line(3)));
        assert!(lines.advance().unwrap());
        assert_eq!(lines.line(), b"d");
        assert!(!lines.advance().unwrap());
    }

    #[test]
    fn a_line_without_end_is_refused() {
        let mut lines = Lines::new(std::io::BufReader::new(std::io::repeat(b'x')), "f");
        let error = lines.advance().unwrap_err();
        assert!(matches!(error, ReadError::TooLarge { limit: MAX_LINE, .. }), "{error}");
    }

    #[test]
    fn numbers_are_finite() {
        assert_eq!(float(b"-1.5e2"), Some(-150.0));
        for word in [&b"nan"[..], b"inf", b"1e39", b"", b"1x", b"\xff"] {
            assert_eq!(float(word), None);
        }
        assert_eq!(number(b"1e309"), None);
    }
}
