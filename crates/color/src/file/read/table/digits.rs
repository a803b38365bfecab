//! Numbers with separators of thousands, and with decimal commas between commas: which is which is settled for a whole file.

use std::borrow::Cow;

use super::number_like::is_date;
use crate::file::read::error::excerpt;
use crate::file::read::text::lines;
use crate::file::read::{Place, ReadError};

/// How numbers of a file are written, where that differs from `1234.5`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Style {
    /// What stands between thousands.
    group: Option<char>,
    /// What stands before the decimals.
    point: char,
}

/// What may stand between thousands.
const GROUPS: [char; 6] = [',', '.', '\'', '’', '\u{a0}', '\u{202f}'];

/// A text, with what became of its numbers.
#[derive(Debug)]
pub(super) struct Written<'a> {
    /// The text, with its numbers as `1234.5`, if it is clear which way they are written.
    pub(super) text: Cow<'a, str>,
    /// What is told of it.
    pub(super) told: Option<String>,
    /// Why nothing was changed, though a number has separators of thousands.
    pub(super) unsettled: Option<Unsettled>,
}

/// Two numbers of a table that are not written in one way.
#[derive(Debug)]
pub(super) struct Unsettled {
    one: String,
    other: String,
    /// The line of the other one.
    line: u64,
}

impl Unsettled {
    /// The error where the table cannot be read for it.
    pub(super) fn error(&self, file: &str) -> ReadError {
        let expected =
            format!("separators of thousands in one way throughout, or none: {} has one", excerpt(&self.one));
        ReadError::malformed(file, Place::Line(self.line), expected, excerpt(&self.other))
    }
}

/// The text with all its numbers as `1234.5`, and what is told of it. Only fields in quotes, and those of lines with tabs or
/// semicolons, are looked at: elsewhere a comma parts fields.
///
/// A number such as `1,234` alone tells nothing: it stays as it is.
pub(super) fn plain(text: &str) -> Written<'_> {
    let as_it_is = |unsettled| Written { text: Cow::Borrowed(text), told: None, unsettled };
    let of_table = || {
        let lines = lines(text).filter(|(_, line)| is_of_table(line));
        lines.flat_map(|(number, line)| candidates(line).map(move |field| (number, line, field)))
    };
    let mut found: Option<(Style, &str)> = None;
    for (line, text, field) in of_table().filter(|(.., field)| !is_date(field)) {
        let Some(style) = style_of(field, text) else { continue };
        match found {
            Some((known, one)) if known != style && known.group.is_some() == style.group.is_some() => {
                // Both ways in one file: nothing is settled.
                return as_it_is(Some(Unsettled { one: one.to_owned(), other: field.to_owned(), line }));
            }
            Some((known, _)) if known.group.is_some() => {}
            _ => found = Some((style, field)),
        }
    }
    let Some((style, example)) = found else { return as_it_is(None) };
    let against = of_table().find(|(.., field)| !is_date(field) && contradicts(field, style));
    if let Some((line, _, field)) = against {
        return as_it_is(Some(Unsettled { one: example.to_owned(), other: field.to_owned(), line }));
    }
    let plain = lines(text).map(|(_, line)| rewritten(line, style)).collect::<Vec<_>>().join("\n");
    let what = match style.group {
        Some(group) => format!("'{group}' is taken for a separator of thousands, as in {example}"),
        None => format!("the comma within quotes is taken for a decimal comma, as in \"{example}\""),
    };
    Written { text: Cow::Owned(plain), told: Some(what), unsettled: None }
}

/// Whether a line holds more than one field that begins as numbers do: a version or a date of a head tells nothing of numbers.
fn is_of_table(line: &str) -> bool {
    let begins = |field: &str| {
        field.trim_start_matches(['-', '+', '"', ' ']).starts_with(|c: char| c.is_ascii_digit())
    };
    line.split(['\t', ';', '"']).filter(|field| begins(field)).count() > 1
}

/// The fields of a line in which a comma or a point may part thousands: those in quotes, or all between tabs or semicolons.
fn candidates(line: &str) -> impl Iterator<Item = &str> {
    let is_parted = line.contains(['\t', ';']);
    let parts = line.split(move |c: char| if is_parted { "\t;\"".contains(c) } else { c == '"' });
    // Outside of quotes, every other part is between quoted ones.
    let quoted = parts.enumerate().filter(move |(index, _)| is_parted || index % 2 == 1);
    quoted.map(|(_, field)| field.trim()).filter(|field| field.contains(|c| GROUPS.contains(&c)))
}

/// What a field tells of the way in which numbers are written; nothing where it is no number, or may be read in two ways.
fn style_of(field: &str, line: &str) -> Option<Style> {
    if let Some(style) = grouped(field) {
        return Some(style);
    }
    // A decimal comma in quotes, where commas part fields.
    let (whole, part) = field.split_once(',').filter(|_| !line.contains(['\t', ';']))?;
    let is_number = field.replacen(',', ".", 1).parse::<f64>().is_ok() && !part.is_empty();
    let digits = whole.trim_start_matches(['-', '+']);
    let may_be_thousands = part.len() == 3 && (1..4).contains(&digits.len()) && !digits.starts_with('0');
    (is_number && !may_be_thousands).then_some(Style { group: None, point: ',' })
}

/// A number with at least one separator of thousands and a decimal mark, or with two separators of thousands.
fn grouped(field: &str) -> Option<Style> {
    let digits = field.trim_start_matches(['-', '+']);
    let group = digits.chars().find(|c| !c.is_ascii_digit()).filter(|c| GROUPS.contains(c))?;
    let (head, decimals) = match digits.rsplit_once(|c| c != group && (c == '.' || c == ',')) {
        Some((head, decimals)) => (head, Some(decimals)),
        None => (digits, None),
    };
    let parts: Vec<&str> = head.split(group).collect();
    let is_digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let are_groups = (1..4).contains(&parts[0].len())
        && is_digits(parts[0])
        && parts[1..].iter().all(|part| part.len() == 3 && is_digits(part));
    let point = if group == '.' { ',' } else { '.' };
    let point = decimals.map_or(point, |_| digits.chars().nth(head.chars().count()).unwrap_or(point));
    (are_groups && decimals.is_none_or(is_digits) && parts.len() > if decimals.is_some() { 1 } else { 2 })
        .then_some(Style { group: Some(group), point })
}

/// Whether a field is a number in which the mark of thousands stands elsewhere than between thousands: `0.5` beside `1.234.567`.
fn contradicts(field: &str, style: Style) -> bool {
    let Some(group) = style.group else { return false };
    let digits = field.trim_start_matches(['-', '+']);
    let is_number = digits.contains(group)
        && digits.chars().all(|c| c.is_ascii_digit() || c == group || c == style.point);
    let head = digits.split(style.point).next().unwrap_or_default();
    let mut parts = head.split(group);
    let first = parts.next().unwrap_or_default();
    is_number
        && !((1..4).contains(&first.len()) && !first.starts_with('0') && parts.all(|part| part.len() == 3))
}

/// A line with its numbers as `1234.5`.
fn rewritten(line: &str, style: Style) -> String {
    let is_parted = line.contains(['\t', ';']);
    let mut out = String::with_capacity(line.len());
    let mut rest = line;
    let mut in_quotes = false;
    while !rest.is_empty() {
        let is_end = |c: char| c == '"' || is_parted && "\t;".contains(c);
        let end = rest.find(is_end).unwrap_or(rest.len());
        let (field, after) = rest.split_at(end);
        match is_parted || in_quotes {
            true => out.push_str(&number(field, style)),
            false => out.push_str(field),
        }
        let mark = after.chars().next();
        in_quotes ^= mark == Some('"');
        out.extend(mark);
        rest = &after[mark.map_or(0, char::len_utf8)..];
    }
    out
}

/// A field as `1234.5`, if it is a number of this style.
fn number<'a>(field: &'a str, style: Style) -> Cow<'a, str> {
    let may_be =
        |c: char| c.is_ascii_digit() || "+-eE ".contains(c) || c == style.point || Some(c) == style.group;
    if !field.contains(|c: char| c.is_ascii_digit()) || !field.chars().all(may_be) || is_date(field) {
        return Cow::Borrowed(field);
    }
    let plain: String = field.chars().filter(|c| Some(*c) != style.group).collect();
    Cow::Owned(if style.point == ',' { plain.replacen(',', ".", 1) } else { plain })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_of_thousands_are_told_from_decimal_marks_by_the_whole_file() {
        let plain = |text| plain(text).text.into_owned();
        assert_eq!(plain("400;1.234,5\n410;1.000"), "400;1234.5\n410;1000");
        assert_eq!(plain("400\t1,234.5\n410\t2,000"), "400\t1234.5\n410\t2000");
        assert_eq!(plain("400,\"1,234,567\"\n"), "400,\"1234567\"\n");
        assert_eq!(
            plain("\"400,5\",\"0,125\"\n\"401,5\",\"1,125\""),
            "\"400.5\",\"0.125\"\n\"401.5\",\"1.125\""
        );
        // What may be read in two ways stays, and so does a table whose commas part fields.
        for text in [
            "400,\"1,234\"",
            "400;1,234",
            "400,123,456.5",
            "400\t0.5",
            "Date;1.2.2020",
            "Firmware\t1.100.200\n400\t0.123",
        ] {
            assert_eq!(plain(text), text);
        }
        // A date is no number, wherever it stands.
        assert_eq!(plain("Datum;01.02.2026\n400;1.400,5"), "Datum;01.02.2026\n400;1400.5");
        assert_eq!(plain("01.02.26;400;1.400,5"), "01.02.26;400;1400.5");
    }
}
