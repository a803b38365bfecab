//! Text, line by line.

use std::io::{BufRead, Read, Result as IoResult};

use glanz_color::read::{Place, ReadError, excerpt};

/// The longest line that is read: a file without line ends would else fill the memory.
const MAX_LINE: u64 = 64 << 20;

/// The byte order mark of UTF-8, which some programs write before a text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// How lines end.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ending {
    /// With LF or CR LF; a CR elsewhere is a blank.
    Lf,
    /// The first one ends with CR alone, so that any CR and any LF ends one.
    Cr,
}

/// A reader of lines that counts them. Lines end with LF, CR LF, CR alone, or the file.
pub(super) struct Lines<'a, R> {
    reader: R,
    file: &'a str,
    line: u64,
    bytes: Vec<u8>,
    /// Known from the end of the first line on.
    ending: Option<Ending>,
}

impl<'a, R: BufRead> Lines<'a, R> {
    pub(super) fn new(reader: R, file: &'a str) -> Self {
        Self::from_line(reader, file, 0)
    }

    /// A reader of what follows after so many lines.
    pub(super) fn from_line(reader: R, file: &'a str, line: u64) -> Self {
        Self { reader, file, line, bytes: Vec::new(), ending: None }
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

    /// Goes to the next line; where it ends with a backslash, the following ones are appended. Comments, from a word
    /// that begins with `#` on, never are continued.
    pub(super) fn advance_joined(&mut self) -> Result<bool, ReadError> {
        if !self.advance()? {
            return Ok(false);
        }
        while self.bytes.last() == Some(&b'\\') && !words(&self.bytes).any(|word| word.starts_with(b"#")) {
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

    /// An error at the line about a part of it.
    pub(super) fn malformed(&self, expected: impl Into<String>, found: impl Into<String>) -> ReadError {
        ReadError::malformed(self.file, self.place(), expected, found)
    }

    /// An error at the line.
    pub(super) fn expected(&self, what: impl Into<String>) -> ReadError {
        ReadError::malformed(self.file, self.place(), what, excerpt(&self.bytes))
    }

    /// Appends the next line to the buffer.
    fn append(&mut self) -> Result<bool, ReadError> {
        let place = Place::Line(self.line + 1);
        let before = self.bytes.len();
        let read = match self.ending {
            Some(Ending::Lf) => self.append_until_lf(),
            _ => self.append_until_any(),
        };
        let ended = match read {
            Ok(ended) => ended,
            Err(source) => return Err(ReadError::Io { file: self.file.to_owned(), place, source }),
        };
        if self.bytes.len() == before && !ended {
            return Ok(false);
        }
        if self.line == 0 && self.bytes.starts_with(BYTE_ORDER_MARK) {
            self.bytes.drain(..BYTE_ORDER_MARK.len());
        }
        self.line += 1;
        let found = self.bytes.len() as u64;
        if found > MAX_LINE {
            let (file, limit, unit) = (self.file.to_owned(), MAX_LINE, "bytes in a line");
            return Err(ReadError::TooLarge { file, place, limit, unit, found });
        }
        Ok(true)
    }

    /// How many bytes a line may still get: one more than it may have.
    fn room(&self) -> u64 {
        (MAX_LINE + 2).saturating_sub(self.bytes.len() as u64)
    }

    /// Appends what comes before the next LF; whether there was one.
    fn append_until_lf(&mut self) -> IoResult<bool> {
        let room = self.room();
        (&mut self.reader).take(room).read_until(b'\n', &mut self.bytes)?;
        let ended = self.bytes.last() == Some(&b'\n');
        if ended {
            self.bytes.pop();
            if self.bytes.last() == Some(&b'\r') {
                self.bytes.pop();
            }
        }
        Ok(ended)
    }

    /// Appends what comes before the next LF or CR; whether there was one. The first one tells how lines end.
    fn append_until_any(&mut self) -> IoResult<bool> {
        while self.room() > 0 {
            let held = self.reader.fill_buf()?;
            if held.is_empty() {
                return Ok(false);
            }
            let end = held.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            let Some(end) = end else {
                self.bytes.extend_from_slice(held);
                let read = held.len();
                self.reader.consume(read);
                continue;
            };
            self.bytes.extend_from_slice(&held[..end]);
            let is_lf = held[end] == b'\n';
            self.reader.consume(end + 1);
            if self.ending.is_none() {
                let lf_follows = !is_lf && self.reader.fill_buf()?.first() == Some(&b'\n');
                if lf_follows {
                    self.reader.consume(1);
                }
                self.ending = Some(if is_lf || lf_follows { Ending::Lf } else { Ending::Cr });
            }
            return Ok(true);
        }
        Ok(false)
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

/// The words of a line of numbers up to a comment, which begins with `#` wherever that is. Where a `.` stands before it,
/// it is of a number that some programs write for none, such as `1.#QNAN`.
pub(super) fn values(line: &[u8]) -> impl Iterator<Item = &[u8]> + Clone {
    let is_comment =
        |at: usize| line[at] == b'#' && at.checked_sub(1).map(|before| line[before]) != Some(b'.');
    words(&line[..(0..line.len()).find(|&at| is_comment(at)).unwrap_or(line.len())])
}

/// A name without the comment behind it; `None` where there is none.
pub(super) fn without_comment(name: &str) -> Option<&str> {
    let at = name.match_indices('#').map(|(at, _)| at).find(|&at| name[..at].ends_with([' ', '\t']))?;
    Some(name[..at].trim_ascii_end())
}

/// A decimal number, or what programs write for none. What overflows is infinite.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| {
        let lower = text.trim_start_matches(['-', '+']).to_ascii_lowercase();
        let is_none = lower.starts_with("nan") || lower.contains(".#");
        is_none.then_some(f64::NAN)
    })
}

/// A number for a 32-bit float, or NaN or infinity.
pub(super) fn real(word: &[u8]) -> Option<f32> {
    match std::str::from_utf8(word).ok()?.parse() {
        Ok(value) => Some(value),
        Err(_) => number(word).map(|value| value as f32),
    }
}

/// A coordinate, or NaN or infinity.
pub(super) fn coordinate(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok().or_else(|| number(word))
}

/// A finite number for a 32-bit float.
pub(super) fn float(word: &[u8]) -> Option<f32> {
    real(word).filter(|value| value.is_finite())
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
    fn the_first_end_of_a_line_tells_what_ends_lines() {
        let all = |text: &[u8]| -> Vec<String> {
            let mut lines = Lines::new(std::io::BufReader::with_capacity(2, text), "f");
            let mut found = Vec::new();
            while lines.advance().unwrap() {
                found.push(String::from_utf8_lossy(lines.line()).into_owned());
            }
            assert_eq!(lines.count(), found.len() as u64);
            found
        };
        assert_eq!(all(b"a\rb\r\rc"), ["a", "b", "", "c"]);
        assert_eq!(all(b"a\rb\nc\r"), ["a", "b", "c"]);
        assert_eq!(all(b"a\r\nb\rc\r\n"), ["a", "b\rc"]);
        assert_eq!(all(b"\xef\xbb\xbfa\n\xef\xbb\xbf\n"), ["a", "\u{feff}"]);
        assert_eq!(all(b"abc"), ["abc"]);
        assert_eq!(all(b"\n"), [""]);
        assert_eq!(all(b""), [""; 0]);
    }

    #[test]
    fn comments_are_cut_off_and_never_continued() {
        let mut lines = Lines::new(&b"# a\\\nb # c\\\nd\\\ne#f\\\ng"[..], "f");
        let mut found = Vec::new();
        while lines.advance_joined().unwrap() {
            found.push(String::from_utf8_lossy(lines.line()).into_owned());
        }
        assert_eq!(found, ["# a\\", "b # c\\", "d e#f g"]);
        let all = |line: &'static str| values(line.as_bytes()).collect::<Vec<_>>();
        assert_eq!(all("v 1 2#3 4"), [&b"v"[..], b"1", b"2"]);
        assert_eq!(all("v 1.#IND # 3"), [&b"v"[..], b"1.#IND"]);
        assert_eq!(all("# v"), [b""; 0]);
        assert_eq!(without_comment("red # the red one"), Some("red"));
        assert_eq!((without_comment("no#1.png"), without_comment("#1")), (None, None));
    }

    #[test]
    fn a_line_without_end_is_refused() {
        let mut lines = Lines::new(std::io::BufReader::new(std::io::repeat(b'x')), "f");
        let error = lines.advance().unwrap_err();
        assert!(matches!(error, ReadError::TooLarge { limit: MAX_LINE, .. }), "{error}");
    }

    #[test]
    fn numbers_that_are_none_are_told_from_words() {
        assert_eq!((float(b"-1.5e2"), number(b"1e300")), (Some(-150.0), Some(1e300)));
        for word in [
            "nan",
            "NaN",
            "-nan(ind)",
            "nan(0x8000)",
            "1.#QNAN",
            "-1.#IND00",
            "1.#INF",
            "inf",
            "1e39",
            "-Infinity",
        ] {
            let value = real(word.as_bytes());
            assert!(value.is_some_and(|value| !value.is_finite()), "{word}: {value:?}");
            assert_eq!(float(word.as_bytes()), None, "{word}");
        }
        for word in [&b""[..], b"1x", b"\xff", b"#", b"1,5"] {
            assert_eq!(real(word), None);
        }
        assert_eq!(number(b"1e309"), Some(f64::INFINITY));
    }
}
