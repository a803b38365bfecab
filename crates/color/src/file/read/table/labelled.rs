//! Tables with words, dates or times in the same columns of every line.
//!
//! Those columns are left out, and where they name one sample after another (a "long" table), each sample is a part of its own.

use std::borrow::Cow;
use std::collections::HashMap;

use super::axes::is_in_micrometres;
use super::head::names_axis;
use super::lines::{Cell, cells};
use super::number_like::is_like_number;
use super::reshape::{FEWEST, Reshaped};
use crate::file::read::error::excerpt;
use crate::file::read::text::{Separator, fields, lines, number};
use crate::file::read::units::LIKELY_NM;
use crate::file::read::{Place, Quantity, ReadError};

/// The most parts that a table is taken apart into.
const MOST_PARTS: usize = 1000;
/// How many bytes of the lines above the table, and of those below it, each of several parts is read with: those next to it.
const MOST_AROUND: usize = 16 << 10;
/// The first columns, among which that of the wavelengths is looked for.
const FIRST_COLUMNS: usize = 24;

/// The parts of a table with words in it, one at a time; none where no more than so many lines are of such a table.
///
/// # Errors
///
/// Where the only column that says what it is of holds no number.
pub(super) fn parts<'a>(
    text: &'a str,
    than: usize,
    file: &str,
) -> Result<Box<dyn Iterator<Item = Reshaped<'a>> + 'a>, ReadError> {
    let all: Vec<&str> = lines(text).map(|(_, line)| line).collect();
    let mut found: Vec<Labelled> =
        Separator::ALL.into_iter().filter_map(|separator| Labelled::find(&all, separator)).collect();
    // The row of headers has the separator of its table.
    if found.iter().any(|one| one.header(&all).is_some()) {
        found.retain(|one| one.header(&all).is_some());
    }
    // Of equal ones the first: a comma may be that of decimals.
    let best = found.into_iter().rev().max_by_key(|found| found.run.len());
    match best.filter(|found| found.run.len() > than) {
        Some(found) => {
            found.check_left_out(&all, file)?;
            Ok(found.parts(all))
        }
        None => Ok(Box::new(core::iter::empty())),
    }
}

/// The lines of a table with words in it.
struct Labelled {
    separator: Separator,
    run: core::ops::Range<usize>,
    /// The columns that hold words, which may name samples.
    labels: Vec<usize>,
    /// The columns that hold no number, though they begin like one: `<5`.
    unread: Vec<usize>,
}

impl Labelled {
    fn find(all: &[&str], separator: Separator) -> Option<Self> {
        let shapes: Vec<Vec<usize>> = all.iter().map(|line| words(line, separator)).collect();
        let mut best = 0..0;
        let mut start = 0;
        for at in 0..all.len() {
            if shapes[at] != shapes[start] {
                start = at;
            }
            if !shapes[at].is_empty() && at + 1 - start > best.len() {
                best = start..at + 1;
            }
        }
        if best.len() < FEWEST {
            return None;
        }
        let mut is_unread = vec![false; shapes[best.start].len()];
        for line in &all[best.clone()] {
            let mut row = fields(line, separator).enumerate();
            for (index, column) in shapes[best.start].iter().enumerate() {
                let field = row.find(|(at, _)| at == column).map_or("", |(_, field)| field);
                is_unread[index] |= is_like_number(field);
            }
        }
        let of = |wanted: bool| {
            let columns = shapes[best.start].iter().zip(&is_unread);
            columns.filter(|(_, unread)| **unread == wanted).map(|(column, _)| *column).collect()
        };
        Some(Self { separator, labels: of(false), unread: of(true), run: best })
    }

    /// The place of the row of headers: the line above the table, if it has as many fields.
    fn header(&self, all: &[&str]) -> Option<usize> {
        let above = all[..self.run.start].iter().rposition(|line| !line.trim().is_empty())?;
        let count = |at: usize| fields(all[at], self.separator).count();
        (count(above) == count(self.run.start)).then_some(above)
    }

    /// What a column is called in messages.
    fn called(&self, all: &[&str], column: usize) -> String {
        let header = self.header(all).and_then(|at| fields(all[at], self.separator).nth(column));
        match header.filter(|header| !header.is_empty()) {
            Some(header) => format!("column {} {}", column + 1, excerpt(header)),
            None => format!("column {}", column + 1),
        }
    }

    /// The columns that begin like numbers may be left out only where another one says what it is of, or none does.
    fn check_left_out(&self, all: &[&str], file: &str) -> Result<(), ReadError> {
        let Some(header) = self.header(all) else { return Ok(()) };
        let says = |header: &str| Quantity::of(header) != Quantity::Unknown;
        let row: Vec<&str> = fields(all[header], self.separator).collect();
        let is_read = |column: &usize| !self.labels.contains(column) && !self.unread.contains(column);
        let read = (0..row.len()).filter(is_read).any(|column| says(row[column]) && !names_axis(row[column]));
        match self.unread.iter().find(|column| says(row[**column]) && !read) {
            Some(&column) => {
                let line = self.run.start;
                let field = fields(all[line], self.separator).nth(column).unwrap_or_default();
                let place = Place::Field { line: line as u64 + 1, field: column as u64 + 1 };
                let expected = format!("numbers in {}", self.called(all, column));
                let found = format!("no value that is a number, such as {}", excerpt(field));
                Err(ReadError::malformed(file, place, expected, found))
            }
            None => Ok(()),
        }
    }

    /// What is told of the columns that are left out though they begin like numbers.
    fn told(&self, all: &[&str]) -> Vec<String> {
        let tell = |column: &usize| {
            let field = fields(all[self.run.start], self.separator).nth(*column).unwrap_or_default();
            format!(
                "{} left out: no value of it is a number, such as {}",
                self.called(all, *column),
                excerpt(field)
            )
        };
        self.unread.iter().take(4).map(tell).collect()
    }

    /// The parts, in the order in which their names appear.
    fn parts<'a>(self, all: Vec<&'a str>) -> Box<dyn Iterator<Item = Reshaped<'a>> + 'a> {
        let columns = match self.labels.as_slice() {
            [column] => format!("column {} of words", column + 1),
            columns => format!("{} columns of words", columns.len()),
        };
        let mut notes = self.told(&all);
        let Some((names, of_line)) = self.names(&all) else {
            if !self.labels.is_empty() {
                let label = self.label(all[self.run.start]);
                notes.insert(0, format!("{columns} left out, such as {}", excerpt(&label)));
            }
            let mut lines = self.above(&all, usize::MAX);
            lines.extend(self.run.clone().map(|at| self.line(&all, at)));
            lines.extend((self.run.end..all.len()).map(|at| whole(&all, at)));
            return Box::new(core::iter::once(Reshaped { name: None, lines, notes }));
        };
        notes.insert(0, format!("{columns} names {} spectra one after the other", names.len()));
        let (above, below) = (self.above(&all, MOST_AROUND), self.below(&all));
        if above.first().is_some_and(|(number, _)| *number > 1) {
            notes.push(format!("lines above line {} are not read", above[0].0));
        }
        let mut of_name = vec![Vec::new(); names.len()];
        self.run.clone().zip(of_line).for_each(|(at, name)| of_name[name].push(at));
        Box::new(names.into_iter().zip(of_name).map(move |(name, places)| {
            let mut lines = above.clone();
            lines.extend(places.into_iter().map(|at| self.line(&all, at)));
            lines.extend(below.iter().cloned());
            Reshaped { name: Some(name), lines, notes: notes.clone() }
        }))
    }

    /// The lines next above the table, of at most so many bytes, with the row of headers as its columns are read.
    fn above<'a>(&self, all: &[&'a str], most: usize) -> Vec<(u64, Cow<'a, str>)> {
        let header = self.header(all);
        let mut bytes = 0_usize;
        let is_near = |at: &usize| {
            bytes += all[*at].len() + 1;
            bytes <= most || header == Some(*at)
        };
        let near = (0..self.run.start).rev().take_while(is_near);
        let line = |at| if header == Some(at) { self.line(all, at) } else { whole(all, at) };
        let mut lines: Vec<_> = near.map(line).collect();
        lines.reverse();
        lines
    }

    /// The lines next below the table.
    fn below<'a>(&self, all: &[&'a str]) -> Vec<(u64, Cow<'a, str>)> {
        let mut bytes = 0;
        let is_near = |at: &usize| {
            bytes += all[*at].len() + 1;
            bytes <= MOST_AROUND
        };
        (self.run.end..all.len()).take_while(is_near).map(|at| whole(all, at)).collect()
    }

    /// A line without the columns that are left out.
    fn line<'a>(&self, all: &[&'a str], at: usize) -> (u64, Cow<'a, str>) {
        let mark = match self.separator {
            Separator::Char(c) => c,
            Separator::Blanks => '\t',
        };
        let mut line = String::with_capacity(all[at].len());
        let row = fields(all[at], self.separator).enumerate();
        let is_kept = |column: usize| {
            self.labels.binary_search(&column).is_err() && self.unread.binary_search(&column).is_err()
        };
        for (index, (_, field)) in row.filter(|(column, _)| is_kept(*column)).enumerate() {
            if index > 0 {
                line.push(mark);
            }
            let quote = if field.contains(mark) { "\"" } else { "" };
            line.extend([quote, field, quote]);
        }
        (at as u64 + 1, line.into())
    }

    /// The words of a line.
    fn label(&self, line: &str) -> String {
        let row = fields(line, self.separator).enumerate();
        let words = row.filter(|(column, _)| self.labels.binary_search(column).is_ok());
        words.map(|(_, field)| field).collect::<Vec<_>>().join(" ")
    }

    /// The names of the samples, and which of them each line is of. Words name samples where their wavelengths are the same ones;
    /// where each wavelength stands there once, they say something of it, such as a quality.
    fn names(&self, all: &[&str]) -> Option<(Vec<String>, Vec<usize>)> {
        let mut known: HashMap<String, usize> = HashMap::new();
        let mut names: Vec<String> = Vec::new();
        let mut of_line = Vec::with_capacity(self.run.len());
        let most = MOST_PARTS.min(self.run.len() / FEWEST);
        for at in self.run.clone() {
            let name = self.label(all[at]);
            let index = *known.entry(name).or_insert_with_key(|name| {
                names.push(name.clone());
                names.len() - 1
            });
            if names.len() > most {
                return None;
            }
            of_line.push(index);
        }
        (names.len() > 1 && self.repeats(all, &of_line, names.len())).then_some((names, of_line))
    }

    /// Whether half of the wavelengths of a part, or more, stand in others, too.
    fn repeats(&self, all: &[&str], of_line: &[usize], count: usize) -> bool {
        let Some(nm) = self.wavelengths(all, of_line, count) else { return true };
        // The part in which a wavelength stands; none where there are several.
        let mut parts: HashMap<u64, Option<usize>> = HashMap::new();
        for (nm, part) in nm.iter().zip(of_line) {
            let known = parts.entry(nm.to_bits()).or_insert(Some(*part));
            *known = known.filter(|known| known == part);
        }
        let mut shared = vec![(0_usize, 0_usize); count];
        for (nm, part) in nm.iter().zip(of_line) {
            shared[*part].0 += 1;
            shared[*part].1 += usize::from(parts.get(&nm.to_bits()) == Some(&None));
        }
        shared.iter().any(|(lines, shared)| *lines >= FEWEST && 2 * shared >= *lines)
    }

    /// The wavelengths of the lines: the column whose header says so, else the first that can be, else the first that rises or
    /// falls in each part.
    fn wavelengths(&self, all: &[&str], of_line: &[usize], count: usize) -> Option<Vec<f64>> {
        let row = |at: usize| cells(all[at], self.separator, FIRST_COLUMNS);
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); row(self.run.start).len()];
        for at in self.run.clone() {
            let row = row(at);
            for (index, column) in columns.iter_mut().enumerate() {
                column.push(row.get(index).and_then(|cell| cell.value()).unwrap_or(f64::NAN));
            }
        }
        let header = self.header(all).map(|at| fields(all[at], self.separator).collect::<Vec<_>>());
        let is_read = |column: usize| columns[column].iter().any(|value| value.is_finite());
        let is_named = |column: &usize| {
            let field = header.as_ref().and_then(|row| row.get(*column));
            is_read(*column) && field.is_some_and(|field| names_axis(field))
        };
        let is_ordered = |column: &usize| is_read(*column) && is_ordered(&columns[*column], of_line, count);
        let is_likely = |column: &usize| {
            let values = &columns[*column];
            let first: Vec<f64> =
                (0..values.len()).filter(|at| of_line[*at] == of_line[0]).map(|at| values[at]).collect();
            is_ordered(column)
                && (values.iter().all(|value| LIKELY_NM.contains(value)) || is_in_micrometres(&first))
        };
        let all_columns = || 0..columns.len();
        let found = all_columns().find(is_named).or_else(|| all_columns().find(is_likely));
        found.or_else(|| all_columns().find(is_ordered)).map(|column| columns[column].clone())
    }
}

/// A line as it is.
fn whole<'a>(all: &[&'a str], at: usize) -> (u64, Cow<'a, str>) {
    (at as u64 + 1, Cow::Borrowed(all[at]))
}

/// The columns of a line that hold words, if at least two others hold numbers.
///
/// None where a word has numbers parted by a separator that comes before this one: then that one is it.
fn words(line: &str, separator: Separator) -> Vec<usize> {
    let before = Separator::ALL.into_iter().take_while(|known| *known != separator);
    let marks: Vec<char> =
        before.filter_map(|known| if let Separator::Char(c) = known { Some(c) } else { None }).collect();
    let (mut numbers, mut words) = (0, Vec::new());
    for (column, field) in fields(line, separator).enumerate() {
        match Cell::of(field, separator) {
            Cell::Word if field.contains(&*marks) => {
                if field.split(&*marks).any(|piece| number(piece, true).is_some()) {
                    return Vec::new();
                }
                words.push(column);
            }
            Cell::Word => words.push(column),
            cell => numbers += usize::from(cell.value().is_some()),
        }
    }
    if numbers > 1 { words } else { Vec::new() }
}

/// Whether the values of each part only rise or only fall.
fn is_ordered(values: &[f64], of_line: &[usize], count: usize) -> bool {
    let mut last: Vec<Option<f64>> = vec![None; count];
    let (mut rises, mut falls) = (true, true);
    for (value, part) in values.iter().zip(of_line) {
        if let Some(last) = last[*part].replace(*value) {
            (rises, falls) = (rises && last < *value, falls && last > *value);
        }
    }
    rises || falls
}
