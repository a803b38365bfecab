//! Tables of other shapes, brought to lines that each hold a wavelength and its values.
//!
//! Every line keeps its place in the file, so that messages name the lines of the file itself: lines that are joined to the one
//! before them, or left out, become empty.

use super::Source;
use super::lines::{Cell, cells};
use crate::file::read::text::{Separator, fields, lines, number};
use crate::file::read::units::Scale;

/// A table in lines of wavelength and values, and what is to be told of how it came to be.
pub(super) struct Reshaped {
    /// The name of the spectra of this part, if the file gives one.
    pub(super) name: Option<String>,
    pub(super) text: String,
    pub(super) note: String,
}

/// The fewest lines of a table that is read in another shape than the usual one: fewer may be anything.
const FEWEST: usize = 3;
/// The most parts that a table is taken apart into.
const MOST_PARTS: usize = 1000;
/// The most lines of all parts together: each part keeps the place of every line.
const MOST_WORK: usize = 20_000_000;

/// A table whose lines hold one number each, wavelength and value in turn, as Macam's spectroradiometers write them.
pub(super) fn alternating(text: &str) -> Option<Reshaped> {
    let all: Vec<&str> = lines(text).map(|(_, line)| line).collect();
    let run = longest(all.len(), |at| single(all[at]).is_some() || all[at].trim().is_empty())?;
    let numbers: Vec<(usize, f64)> = run.filter_map(|at| Some((at, single(all[at])?))).collect();
    let nm: Vec<f64> = numbers.iter().step_by(2).map(|(_, number)| *number).collect();
    let is_axis = nm.windows(2).all(|pair| pair[0] < pair[1]) || nm.windows(2).all(|pair| pair[0] > pair[1]);
    // Numbers that rise from each to the next are wavelengths alone.
    let is_one_column = numbers.windows(2).all(|pair| pair[0].1 < pair[1].1);
    if is_one_column
        || nm.len() < FEWEST
        || !numbers.len().is_multiple_of(2)
        || !is_axis
        || !nm.iter().all(|nm| Scale::Unknown.is_likely(*nm))
    {
        return None;
    }
    let mut joined: Vec<String> = all.iter().map(|line| (*line).to_owned()).collect();
    for pair in numbers.chunks_exact(2) {
        joined[pair[0].0] = format!("{} {}", all[pair[0].0].trim(), all[pair[1].0].trim());
        joined[pair[1].0].clear();
    }
    let note = format!(
        "each wavelength stands in a line and its value in the next one, from line {} on",
        numbers.first().map_or(0, |(at, _)| at + 1)
    );
    Some(Reshaped { name: None, text: joined.join("\n"), note })
}

/// Whether lines hold one number each, and no wavelengths: values whose wavelengths are in another file.
pub(super) fn is_values_alone(source: &Source<'_>) -> bool {
    let content = source.content;
    let is_one = |at: usize| match cells(content[at].text, Separator::Blanks, 2).as_slice() {
        [cell] => *cell != Cell::Word,
        _ => false,
    };
    longest(content.len(), is_one).is_some_and(|run| run.len() > FEWEST)
}

/// The number of a line that holds but that.
fn single(line: &str) -> Option<f64> {
    number(line, true)
}

/// The longest run of places for which something holds.
fn longest(count: usize, holds: impl Fn(usize) -> bool) -> Option<core::ops::Range<usize>> {
    let (mut best, mut start) = (0..0, 0);
    for at in 0..count {
        if !holds(at) {
            start = at + 1;
        } else if at + 1 - start > best.len() {
            best = start..at + 1;
        }
    }
    Some(best).filter(|best| !best.is_empty())
}

/// A table with words, dates or times in the same columns of every line: those columns are left out, and where they name one sample
/// after another (a "long" table), each sample is a part of its own. None where
/// no more than so many lines are of such a table.
pub(super) fn labelled(text: &str, than: usize) -> Vec<Reshaped> {
    let all: Vec<&str> = lines(text).map(|(_, line)| line).collect();
    let found = Separator::ALL.into_iter().filter_map(|separator| Labelled::find(&all, separator));
    let best = found.max_by_key(|found| found.run.len());
    best.filter(|found| found.run.len() > than).map_or_else(Vec::new, |found| found.parts(&all))
}

/// The lines of a table with words in it.
struct Labelled {
    separator: Separator,
    run: core::ops::Range<usize>,
    /// The columns that hold the words.
    words: Vec<usize>,
}

impl Labelled {
    fn find(all: &[&str], separator: Separator) -> Option<Self> {
        let words = |line: &str| -> Vec<usize> {
            let row = cells(line, separator, usize::MAX - 1);
            let numbers = row.iter().filter(|cell| cell.value().is_some()).count();
            let words = row.iter().enumerate().filter(|(_, cell)| **cell == Cell::Word).map(|(at, _)| at);
            words.filter(|_| numbers > 1).collect()
        };
        let shapes: Vec<Vec<usize>> = all.iter().map(|line| words(line)).collect();
        let mut best: Option<Self> = None;
        let mut start = 0;
        for at in 0..all.len() {
            if shapes[at] != shapes[start] {
                start = at;
            }
            let run = start..at + 1;
            if !shapes[at].is_empty() && best.as_ref().is_none_or(|best| run.len() > best.run.len()) {
                best = Some(Self { separator, run, words: shapes[at].clone() });
            }
        }
        best.filter(|best| best.run.len() >= FEWEST)
    }

    /// The parts, in the order in which their names appear.
    fn parts(&self, all: &[&str]) -> Vec<Reshaped> {
        let columns = match self.words.len() {
            1 => format!("column {} of words", self.words[0] + 1),
            count => format!("{count} columns of words"),
        };
        let Some((names, of_line)) = self.names(all) else {
            let note = format!("{columns} left out, such as '{}'", self.label(all[self.run.start]));
            return vec![Reshaped { name: None, text: self.without(all, |_| true), note }];
        };
        let part = |(index, name): (usize, &String)| Reshaped {
            name: Some(name.clone()),
            text: self.without(all, |at| of_line[at - self.run.start] == index),
            note: format!("{columns} names {} spectra one after the other", names.len()),
        };
        names.iter().enumerate().map(part).collect()
    }

    /// The words of a line.
    fn label(&self, line: &str) -> String {
        let row = fields(line, self.separator).enumerate();
        let words = row.filter(|(column, _)| self.words.contains(column)).map(|(_, field)| field);
        words.collect::<Vec<_>>().join(" ")
    }

    /// The names of the samples, and which of them each line is of. A word for every few lines names samples; one for each line,
    /// or one alone, says nothing of the spectrum.
    fn names(&self, all: &[&str]) -> Option<(Vec<String>, Vec<usize>)> {
        let mut names: Vec<String> = Vec::new();
        let mut of_line = Vec::with_capacity(self.run.len());
        let most = MOST_PARTS.min(MOST_WORK / all.len()).min(self.run.len() / FEWEST);
        for at in self.run.clone() {
            let name = self.label(all[at]);
            let index = names.iter().rposition(|known| *known == name).unwrap_or(names.len());
            if index == names.len() {
                names.push(name);
            }
            if names.len() > most {
                return None;
            }
            of_line.push(index);
        }
        (names.len() > 1).then_some((names, of_line))
    }

    /// The text with these lines of the table alone, without its columns of words, also of the row of headers.
    fn without(&self, all: &[&str], keeps: impl Fn(usize) -> bool) -> String {
        let mark = match self.separator {
            Separator::Char(c) => c,
            Separator::Blanks => '\t',
        };
        let count = fields(all[self.run.start], self.separator).count();
        let header = self.run.start.checked_sub(1);
        let line = |at: usize| -> String {
            let in_table = self.run.contains(&at);
            let row: Vec<&str> = fields(all[at], self.separator).collect();
            if in_table && !keeps(at) {
                return String::new();
            }
            if !(in_table || header == Some(at) && row.len() == count) {
                return all[at].to_owned();
            }
            let kept = row.iter().enumerate().filter(|(column, _)| !self.words.contains(column));
            let quoted =
                |field: &str| if field.contains(mark) { format!("\"{field}\"") } else { field.to_owned() };
            kept.map(|(_, field)| quoted(field)).collect::<Vec<_>>().join(&mark.to_string())
        };
        (0..all.len()).map(line).collect::<Vec<_>>().join("\n")
    }
}
