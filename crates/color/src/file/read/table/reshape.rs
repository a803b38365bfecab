//! Tables of other shapes, brought to lines that each hold a wavelength and its values.
//!
//! Every line keeps its number, so that messages name the lines of the file itself.

use std::borrow::Cow;

use super::Source;
use super::lines::{Cell, cells};
use crate::file::read::text::{Separator, lines, number};
use crate::file::read::units::Scale;

/// A table in lines of wavelength and values, and what is to be told of how it came to be.
pub(super) struct Reshaped<'a> {
    /// The name of the spectra of this part, if the file gives one.
    pub(super) name: Option<String>,
    /// The lines with their numbers in the file.
    pub(super) lines: Vec<(u64, Cow<'a, str>)>,
    pub(super) notes: Vec<String>,
}

/// The fewest lines of a table that is read in another shape than the usual one: fewer may be anything.
pub(super) const FEWEST: usize = 3;

/// A table whose lines hold one number each, wavelength and value in turn, as Macam's spectroradiometers write them.
pub(super) fn alternating(text: &str) -> Option<Reshaped<'_>> {
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
    let mut joined: Vec<(u64, Cow<'_, str>)> = lines(text).map(|(at, line)| (at, line.into())).collect();
    for pair in numbers.chunks_exact(2) {
        joined[pair[0].0].1 = format!("{} {}", all[pair[0].0].trim(), all[pair[1].0].trim()).into();
        joined[pair[1].0].1 = "".into();
    }
    let note = format!(
        "each wavelength stands in a line and its value in the next one, from line {} on",
        numbers.first().map_or(0, |(at, _)| at + 1)
    );
    Some(Reshaped { name: None, lines: joined, notes: vec![note] })
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
