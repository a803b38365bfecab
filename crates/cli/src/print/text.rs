//! Numbers as text, and as JSON.

use std::borrow::Cow;
use std::fmt::{Arguments, Write};

use glanz_color::dominant::Dominant;

/// A text with a question mark for every byte of a character that could steer a terminal: names and excerpts of files
/// may hold any. Ends of lines and tabs stay.
pub(crate) fn harmless(text: &str) -> Cow<'_, str> {
    let steers = |c: char| (c.is_control() && !matches!(c, '\n' | '\t')) || is_direction(c);
    if !text.contains(steers) {
        return Cow::Borrowed(text);
    }
    let mut clean = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '\r' if rest.peek() == Some(&'\n') => clean.push(c),
            // As many bytes as before, so that places in the text stay.
            c if steers(c) => clean.extend(std::iter::repeat_n('?', c.len_utf8())),
            c => clean.push(c),
        }
    }
    Cow::Owned(clean)
}

/// Whether a character turns the direction of writing, by which a name can be shown as another one.
fn is_direction(c: char) -> bool {
    matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}')
}

/// A number for programs, which have no infinity: null in its place.
pub(crate) fn finite(value: f64) -> Option<f64> {
    Some(value).filter(|value| value.is_finite())
}

/// Numbers with so many decimals each, between blanks.
pub(crate) fn decimals(values: &[f64], decimals: usize) -> String {
    let texts: Vec<_> = values.iter().map(|value| fixed(*value, decimals)).collect();
    texts.join(" ")
}

/// A number with so many decimals; one that would need very many digits in powers of ten. No minus before 0.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    if value.abs() >= 1e7 {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text,
    }
}

/// A dominant wavelength: `580.2 nm`, or `purple, complement of 520.1 nm`.
pub(crate) fn wavelength(dominant: &Dominant) -> String {
    match dominant.is_purple() {
        true => format!("purple, complement of {:.1} nm", -dominant.nm),
        false => format!("{:.1} nm", dominant.nm),
    }
}

/// Adds a line.
pub(crate) fn line(text: &mut String, line: Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_a_file_steers_a_terminal() {
        assert_eq!(harmless("a\u{1b}[2Jb\rc\r\nd\te\u{9b}\u{202e}"), "a?[2Jb?c\r\nd\te?????");
        assert!(matches!(harmless("Größe 1.5 µm\n"), Cow::Borrowed(_)));
    }

    #[test]
    fn numbers_have_no_minus_before_nothing() {
        assert_eq!(decimals(&[-0.000_01, 1.25, -3.0], 2), "0.00 1.25 -3.00");
        assert_eq!(fixed(2.5e9, 4), "2.500e9");
    }
}
