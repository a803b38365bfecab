//! The lines of a table and their cells: where in a file the numbers are.

use crate::file::read::PowerUnit;
use crate::file::read::text::{Separator, fields, number};
use crate::file::read::units::photons;

/// A line with something in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'a> {
    /// Its number, from 1.
    pub(super) number: u64,
    /// Its text, without the mark of a comment.
    pub(super) text: &'a str,
    /// Whether it is a comment.
    pub(super) is_comment: bool,
}

/// All lines that hold something; rows of separators alone, as spreadsheets write them, are empty.
pub(super) fn content<'a>(lines: impl Iterator<Item = (u64, &'a str)>) -> Vec<Line<'a>> {
    let is_empty = |line: &str| line.chars().all(|c| c.is_whitespace() || ",;\"".contains(c));
    lines.filter(|(_, line)| !is_empty(line)).map(|(number, line)| of(number, line)).collect()
}

/// Comments begin with `#` (gnuplot, NumPy), `%` (MATLAB), `!`, `//`, or with a `;` that is no separator.
fn of(number: u64, line: &str) -> Line<'_> {
    let trimmed = line.trim_start();
    let body = ["#", "%", "!", "//"].iter().find_map(|mark| trimmed.strip_prefix(mark));
    let body = body.or_else(|| trimmed.strip_prefix(';').filter(|rest| !rest.contains(';')));
    match body {
        Some(text) => {
            Line { number, text: text.trim_start_matches(['#', '%', '!', '/', ';']), is_comment: true }
        }
        None => Line { number, text: line, is_comment: false },
    }
}

/// A field of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// A number.
    Number(f64),
    /// A wavelength with its unit, such as `380nm`, `380 nm` or `Spectral Data 380[nm]`.
    Nanometres(f64),
    /// No value: an empty field, or a word for one.
    Missing,
    /// Anything else.
    Word,
}

/// Words by which programs say that there is no value; −1.23e34 is that of the USGS for a deleted channel (Data Series 1035).
const MISSING: [&str; 14] = [
    "-1.23e34",
    "-1.23e+34",
    "-1.2300000e+34",
    "nan",
    "na",
    "n/a",
    "#n/a",
    "#div/0!",
    "null",
    "none",
    "-",
    "--",
    "---",
    ".",
];

impl Cell {
    /// What a field is.
    pub(super) fn of(field: &str, separator: Separator) -> Self {
        let field = field.trim();
        if field.is_empty() || MISSING.iter().any(|word| field.eq_ignore_ascii_case(word)) {
            return Self::Missing;
        }
        match number(field, separator.decimal_comma()) {
            Some(value) => Self::Number(value),
            None => nanometres(field, separator).map_or(Self::Word, Self::Nanometres),
        }
    }

    /// The number in it.
    pub(super) fn value(self) -> Option<f64> {
        match self {
            Self::Number(value) | Self::Nanometres(value) => Some(value),
            Self::Missing | Self::Word => None,
        }
    }
}

/// The unit of the values that stands in brackets behind the wavelength of a line, as in `380(mW/m2/nm),0.5`.
pub(super) fn unit_behind(line: &str, separator: Separator) -> Option<&str> {
    let field = fields(line, separator).next()?;
    let (number, unit) = field.split_once(['(', '['])?;
    let unit = unit.strip_suffix([')', ']'])?.trim();
    let is_wavelength = number.trim().parse::<f64>().is_ok();
    (is_wavelength && (PowerUnit::parse(unit).is_some() || photons(unit).is_some())).then_some(unit)
}

/// A wavelength that has its unit behind it, or that of the values, and maybe words before.
fn nanometres(field: &str, separator: Separator) -> Option<f64> {
    if unit_behind(field, separator).is_some() {
        return number(field.split(['(', '[']).next()?, separator.decimal_comma());
    }
    let open = field.trim_end_matches([']', ')']);
    let bare = open.get(..open.len().checked_sub(2)?)?;
    if !open.get(bare.len()..)?.eq_ignore_ascii_case("nm") {
        return None;
    }
    let bare = bare.trim_end_matches(['[', '(', ' ', '_']);
    let digits = |c: char| c.is_ascii_digit() || c == '.' || (c == ',' && separator.decimal_comma());
    let start = bare.len() - bare.chars().rev().take_while(|c| digits(*c)).count();
    number(&bare[start..], separator.decimal_comma())
}

/// The cells of a line, at most one more than `most`.
pub(super) fn cells(text: &str, separator: Separator, most: usize) -> Vec<Cell> {
    fields(text, separator).take(most + 1).map(|field| Cell::of(field, separator)).collect()
}

/// Lines one after the other that hold numbers only, as many in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    /// The place of the first one among all lines with content.
    pub(super) first: usize,
    /// The place behind the last one.
    pub(super) end: usize,
    /// The most fields of a line up to its last value.
    pub(super) width: usize,
    /// The least fields of a line, with empty ones at its end.
    pub(super) fields: usize,
    /// How many lines it has; comments between them do not count.
    pub(super) count: usize,
}

/// How many fields a line of numbers has, in all and up to its last value; none if it is no such line.
fn shape(line: &Line<'_>, separator: Separator) -> Option<(usize, usize)> {
    let (mut all, mut filled, mut numbers) = (0, 0, 0);
    for field in fields(line.text, separator) {
        all += 1;
        match Cell::of(field, separator) {
            Cell::Word => return None,
            Cell::Missing => {}
            Cell::Number(_) | Cell::Nanometres(_) => {
                numbers += 1;
                filled = all;
            }
        }
    }
    (numbers > 0 && all > 1).then_some((all, filled))
}

/// The longest run of lines of numbers with this separator.
fn longest(content: &[Line<'_>], separator: Separator) -> Option<Run> {
    let (mut best, mut run): (Option<Run>, Option<Run>) = (None, None);
    for (at, line) in content.iter().enumerate().filter(|(_, line)| !line.is_comment) {
        run = match (shape(line, separator), run) {
            (None, _) => None,
            (Some((all, filled)), Some(run)) if filled <= run.fields && run.width <= all => Some(Run {
                end: at + 1,
                width: run.width.max(filled),
                fields: run.fields.min(all),
                count: run.count + 1,
                ..run
            }),
            (Some((all, filled)), _) => {
                Some(Run { first: at, end: at + 1, width: filled, fields: all, count: 1 })
            }
        };
        if let Some(run) = run
            && best.is_none_or(|best| run.count > best.count)
        {
            best = Some(run);
        }
    }
    best
}

/// The separator of the table, and its lines: the longest run of lines of numbers.
pub(super) fn find(content: &[Line<'_>]) -> Option<(Separator, Run)> {
    let mut best: Option<(Separator, Run)> = None;
    for separator in Separator::ALL {
        if let Some(run) = longest(content, separator)
            && best.is_none_or(|(_, best)| run.count > best.count)
        {
            best = Some((separator, run));
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wavelengths_may_have_their_unit_behind_them() {
        let cell = |text| Cell::of(text, Separator::Char('\t'));
        for text in
            ["380nm", "380 nm", "380 NM", "Spectral Data 380[nm]", "Spec. 380 (nm)", "SPEC_380_nm", "380,0nm"]
        {
            assert_eq!(cell(text), Cell::Nanometres(380.0), "{text}");
        }
        for text in ["nm", "peak", "380 nms", "µm"] {
            assert_eq!(cell(text), Cell::Word, "{text}");
        }
        for text in ["", " ", "NaN", "NA", "-", "---", "#N/A"] {
            assert_eq!(cell(text), Cell::Missing, "{text}");
        }
        assert_eq!(cell("-0,5"), Cell::Number(-0.5));
    }

    #[test]
    fn the_longest_run_of_numbers_is_the_table() {
        let text = "Model 7\n3\t4\nx\ty\n# wavelengths\n400\t1\t\n410\t\n\n420\t3\n>>end<<\n1\t2\n";
        let content = content(crate::file::read::text::lines(text));
        let (separator, run) = find(&content).unwrap();
        assert_eq!(separator, Separator::Char('\t'));
        assert_eq!(
            (content[run.first].number, content[run.end - 1].number, run.count, run.width),
            (5, 8, 3, 2)
        );
        assert!(content[3].is_comment && content[3].text == " wavelengths");
    }
}
