//! Text: decoding, lines, numbers, fields.

use std::borrow::Cow;

use super::error::excerpt;
use super::{Place, ReadError};

/// The greatest file of spectra that is read: ten thousand spectra at 1 nm. A reader's memory is a small
/// multiple of it.
pub(in crate::file::read) const MAX_BYTES: usize = 16 << 20;
/// No quantity of light is greater; sums of such values stay finite.
const GREATEST: f64 = 1e30;

/// The text of a file: UTF-8 with or without a mark, UTF-16 with one or as its zero bytes show, else Latin-1, as older
/// instruments write `µm`. Other bytes of 0, with which some instruments fill their heads, are blanks.
pub(in crate::file::read) fn decode<'a>(bytes: &'a [u8], file: &str) -> Result<Cow<'a, str>, ReadError> {
    if bytes.len() > MAX_BYTES {
        let (limit, found) = (MAX_BYTES as u64, bytes.len() as u64);
        let (file, place) = (file.to_owned(), Place::File);
        return Err(ReadError::TooLarge { file, place, limit, unit: "bytes", found });
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if let Some(text) = utf16(bytes) {
        return Ok(Cow::Owned(text));
    }
    let text = match core::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|&byte| char::from(byte)).collect()),
    };
    Ok(if text.contains('\0') { Cow::Owned(text.replace('\0', " ")) } else { text })
}

/// The text of a file in UTF-16: with a mark of byte order, or without one where every other byte of its beginning is 0, as it
/// is in Western text. What is no character becomes U+FFFD.
fn utf16(bytes: &[u8]) -> Option<String> {
    let beginning = &bytes[..bytes.len().min(512)];
    let zeros = |first: usize| {
        let every_other = beginning.iter().skip(first).step_by(2);
        every_other.len() > 2
            && every_other.clone().filter(|byte| **byte == 0).count() * 10 > every_other.len() * 9
    };
    let little = match beginning {
        [0xFF, 0xFE, ..] => true,
        [0xFE, 0xFF, ..] => false,
        _ if zeros(1) && !zeros(0) => true,
        _ if zeros(0) && !zeros(1) => false,
        _ => return None,
    };
    let units = bytes.chunks_exact(2).map(|pair| match little {
        true => u16::from_le_bytes([pair[0], pair[1]]),
        false => u16::from_be_bytes([pair[0], pair[1]]),
    });
    let text = char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER));
    Some(text.filter(|c| *c != '\u{FEFF}').map(|c| if c == '\0' { ' ' } else { c }).collect())
}

/// The lines of a text with their numbers, counted from 1. Lines end with LF, CR LF or CR.
pub(in crate::file::read) fn lines(text: &str) -> impl Iterator<Item = (u64, &str)> + Clone {
    let mut rest = Some(text);
    let lines = core::iter::from_fn(move || {
        let text = rest?;
        match text.find(['\n', '\r']) {
            None => rest = None,
            Some(end) => {
                let skip = if text[end..].starts_with("\r\n") { 2 } else { 1 };
                rest = Some(&text[end + skip..]);
                return Some(&text[..end]);
            }
        }
        Some(text)
    });
    (1..).zip(lines)
}

/// A decimal number, with a comma for its point where that is allowed. NaN, infinity and what is no
/// number of any quantity are none.
pub(in crate::file::read) fn number(text: &str, decimal_comma: bool) -> Option<f64> {
    let text = text.trim();
    let value: f64 = match text.split_once(',') {
        Some((whole, part)) if decimal_comma && !part.is_empty() && !text.contains('.') => {
            format!("{whole}.{part}").parse().ok()?
        }
        _ => text.parse().ok()?,
    };
    (value.abs() <= GREATEST).then_some(value)
}

/// A number that must be there.
pub(in crate::file::read) fn expect_number(
    text: &str,
    decimal_comma: bool,
    file: &str,
    place: impl FnOnce() -> Place,
) -> Result<f64, ReadError> {
    number(text, decimal_comma)
        .ok_or_else(|| ReadError::malformed(file, place(), "a number from -1e30 to 1e30", excerpt(text)))
}

/// What stands between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::file::read) enum Separator {
    /// This character; a field may be empty.
    Char(char),
    /// Any number of blanks.
    Blanks,
}

impl Separator {
    /// All of them, in the order in which they are tried.
    pub(in crate::file::read) const ALL: [Self; 4] =
        [Self::Char('\t'), Self::Char(';'), Self::Char(','), Self::Blanks];

    /// The separator that a line uses: tab, semicolon or comma, in this order, else blanks.
    pub(in crate::file::read) fn of(line: &str) -> Self {
        ['\t', ';', ',']
            .into_iter()
            .find(|&c| fields(line, Self::Char(c)).nth(1).is_some())
            .map_or(Self::Blanks, Self::Char)
    }

    /// Whether numbers may be written with a comma.
    pub(in crate::file::read) fn decimal_comma(self) -> bool {
        self != Self::Char(',')
    }
}

/// The fields of a line, without blanks around them. A field in double quotes may hold the separator.
pub(in crate::file::read) fn fields(line: &str, separator: Separator) -> impl Iterator<Item = &str> {
    let mut rest = Some(line);
    core::iter::from_fn(move || {
        let text = match separator {
            Separator::Char('\t') => rest?.trim_matches(' '),
            Separator::Char(_) => rest?.trim(),
            Separator::Blanks => Some(rest?.trim()).filter(|text| !text.is_empty())?,
        };
        let is_end = |c: char| match separator {
            Separator::Char(wanted) => c == wanted,
            Separator::Blanks => c.is_whitespace(),
        };
        let quoted = text.strip_prefix('"').and_then(|text| text.split_once('"'));
        // What stands between a closing quote and the separator is no part of the field.
        let (field, after) = quoted.map_or((None, text), |(field, after)| (Some(field), after));
        let (plain, after) = match after.find(is_end) {
            Some(end) => (&after[..end], Some(&after[end..])),
            None => (after, None),
        };
        rest = after.map(|after| after.strip_prefix(is_end).unwrap_or(after));
        Some(field.unwrap_or(plain).trim())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways() {
        let all: Vec<_> = lines("a\r\nb\rc\n\nd").collect();
        assert_eq!(all, [(1, "a"), (2, "b"), (3, "c"), (4, ""), (5, "d")]);
    }

    #[test]
    fn numbers_are_finite_and_may_have_a_comma() {
        assert_eq!(number(" -1.5e2 ", false), Some(-150.0));
        assert_eq!(number("0,25", true), Some(0.25));
        for text in ["0,25", "nan", "inf", "1e31", "1e999", "", "1x"] {
            assert_eq!(number(text, false), None, "{text}");
        }
        assert_eq!(number("1.000,5", true), None);
    }

    #[test]
    fn fields_are_separated_in_four_ways() {
        let split = |line| fields(line, Separator::of(line)).collect::<Vec<_>>();
        assert_eq!(split("a, \"b, c\" ,,d,"), ["a", "b, c", "", "d", ""]);
        assert_eq!(split("1,5;2,5"), ["1,5", "2,5"]);
        assert_eq!(split("a b\t\tc"), ["a b", "", "c"]);
        assert_eq!(split("  380   0.5 "), ["380", "0.5"]);
        assert_eq!(split("\"no end, b"), ["\"no end", "b"]);
        assert_eq!(split(""), Vec::<&str>::new());
    }

    #[test]
    fn text_is_utf_8_utf_16_or_latin_1() {
        assert_eq!(decode(b"\xEF\xBB\xBFnm", "f").unwrap(), "nm");
        assert_eq!(decode(b"\xB5m", "f").unwrap(), "µm");
        let little: Vec<u8> = "µm\t1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = "\u{FEFF}µm\t1\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
        assert_eq!(decode(&little, "f").unwrap(), "µm\t1\n");
        assert_eq!(decode(&big, "f").unwrap(), "µm\t1\n");
        assert_eq!(decode(&[&[0xFF, 0xFE][..], &little].concat(), "f").unwrap(), "µm\t1\n");
        assert_eq!(decode(b"head\0\0\0\n400 1", "f").unwrap(), "head   \n400 1");
        assert!(decode(&vec![b'1'; MAX_BYTES + 1], "f").is_err());
    }
}
