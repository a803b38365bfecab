//! Curves taken from figures, in pixels, with points whose place is known, as the R package colorSpec keeps them.
//!
//! Under `[Control]` stand at least three points, each with its pixel and what it means (`Xpx Ypx X Y`); under every other line in
//! brackets the pixels of a curve. Pixels are turned into wavelengths and values by the affine map that fits the points best.

use std::borrow::Cow;

use super::reshape::Reshaped;
use crate::file::read::text::{lines, number};
use crate::file::read::{Place, ReadError};

/// The line above the points whose place is known.
const MARK: &str = "[control]";
/// The most lines in brackets of a file.
const MOST_SECTIONS: usize = 256;
/// The most bytes of the comments of the head, which each curve is read with.
const MOST_COMMENTS: usize = 16 << 10;
/// The least spread of the points across the line that fits them best, by that along it.
const LEAST_SPREAD: f64 = 0.01;
/// How far points may lie from the map that fits them best, by their range: less may be the width of a figure's lines, more is a
/// wrong number.
const MOST_RESIDUAL: f64 = 0.02;
/// What is told.
const TOLD_RESIDUAL: f64 = 0.005;

/// A value as 1, x and y have a part in it.
type Plane = [f64; 3];

/// The curves of a text, in wavelengths and values, one at a time; nothing of a text that holds none.
///
/// # Errors
///
/// Where there are too many, or no map fits the points.
pub(super) fn curves<'a>(
    text: &'a str,
    file: &str,
) -> Option<Result<impl Iterator<Item = Reshaped<'a>> + use<'a>, ReadError>> {
    let all: Vec<&str> = lines(text).map(|(_, line)| line).collect();
    let is_section = |at: &usize| all[*at].trim().starts_with('[') && all[*at].trim().ends_with(']');
    let sections: Vec<usize> = (0..all.len()).filter(is_section).collect();
    let control = sections.iter().position(|at| all[*at].trim().eq_ignore_ascii_case(MARK))?;
    if sections.len() > MOST_SECTIONS {
        let (file, limit, found) = (file.to_owned(), MOST_SECTIONS as u64, sections.len() as u64);
        return Some(Err(ReadError::TooLarge { file, place: Place::File, limit, unit: "curves", found }));
    }
    let end = |index: usize| sections.get(index + 1).copied().unwrap_or(all.len());
    let known: Vec<_> =
        all[sections[control] + 1..end(control)].iter().filter_map(|line| numbers::<4>(line)).collect();
    let line = sections[control] as u64 + 1;
    if sections.len() < 2 {
        let expected = "a curve under another line in brackets than [Control]";
        return Some(Err(ReadError::malformed(file, Place::Line(line), expected, "none")));
    }
    let map = match Map::of(&known) {
        Ok(map) => map,
        Err((expected, found)) => {
            return Some(Err(ReadError::malformed(file, Place::Line(line), expected, found)));
        }
    };
    let ranges: Vec<_> = (0..sections.len())
        .filter(|index| *index != control)
        .map(|index| (sections[index], end(index)))
        .collect();
    let comments = comments(&all[..sections[0]]);
    let mut notes =
        vec![format!("pixels turned into wavelengths and values by the points from line {line} on")];
    notes.extend(map.told.clone());
    Some(Ok(ranges.into_iter().map(move |(first, end)| {
        let lines = (first..end).map(|at| (at as u64 + 1, map.line(all[at], at == first)));
        Reshaped { name: None, lines: comments.iter().cloned().chain(lines).collect(), notes: notes.clone() }
    })))
}

/// The comments of a head, the last ones where they are many.
fn comments<'a>(head: &[&'a str]) -> Vec<(u64, Cow<'a, str>)> {
    let mut bytes = 0;
    let all = head.iter().enumerate().rev().filter(|(_, line)| line.trim_start().starts_with('#'));
    let near = all.take_while(|(_, line)| {
        bytes += line.len();
        bytes <= MOST_COMMENTS
    });
    let mut comments: Vec<_> = near.map(|(at, line)| (at as u64 + 1, Cow::Borrowed(*line))).collect();
    comments.reverse();
    comments
}

/// The numbers of a line that has so many, before a comment.
fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let words = line.split('#').next().unwrap_or_default().split_whitespace();
    let found: Option<Vec<f64>> = words.take(N + 1).map(|word| number(word, false)).collect();
    found?.try_into().ok()
}

/// How pixels become wavelengths and values.
struct Map {
    wavelength: Plane,
    value: Plane,
    told: Option<String>,
}

impl Map {
    /// The planes of least squares through X and through Y over the pixels; what was expected and found where there are none.
    fn of(points: &[[f64; 4]]) -> Result<Self, (String, String)> {
        if points.len() < 3 {
            let expected = "three points with their pixels under [Control]";
            return Err((expected.to_owned(), points.len().to_string()));
        }
        let planes = plane(points, 2).zip(plane(points, 3));
        let Some((wavelength, value)) = planes else {
            let expected = "three points with their pixels that are not on one line";
            return Err((expected.to_owned(), "points on one line".to_owned()));
        };
        let worst = residual(points, wavelength, 2).max(residual(points, value, 3));
        let far =
            format!("points up to {:.2} % of their range off the map that fits them best", 100.0 * worst);
        if worst > MOST_RESIDUAL {
            return Err(("points of one affine map".to_owned(), far));
        }
        let told = (worst > TOLD_RESIDUAL).then(|| format!("under [Control], {far}"));
        Ok(Self { wavelength, value, told })
    }

    /// A line of a curve: its wavelength and value, or the name of the column.
    fn line<'a>(&self, text: &'a str, is_first: bool) -> Cow<'a, str> {
        match numbers::<2>(text) {
            Some([x, y]) => format!("{}\t{}", at(self.wavelength, x, y), at(self.value, x, y)).into(),
            None if is_first => format!("wavelength\t{}", text.trim().trim_matches(['[', ']'])).into(),
            None if text.trim_start().starts_with('#') => text.into(),
            None => "".into(),
        }
    }
}

/// The value of a plane at a pixel.
fn at(plane: Plane, x: f64, y: f64) -> f64 {
    plane[0] + plane[1] * x + plane[2] * y
}

/// The plane of least squares through one of the numbers of points, over their pixels; none where these lie on one line.
fn plane(points: &[[f64; 4]], of: usize) -> Option<Plane> {
    let mean = |index: usize| points.iter().map(|point| point[index]).sum::<f64>() / points.len() as f64;
    let (x, y, value) = (mean(0), mean(1), mean(of));
    let sum = |a: usize, b: usize| {
        let means = [x, y, value];
        let centred = |point: &[f64; 4], index: usize| point[index] - means[index.min(2)];
        points.iter().map(|point| centred(point, a) * centred(point, b)).sum::<f64>()
    };
    let (xx, xy, yy) = (sum(0, 0), sum(0, 1), sum(1, 1));
    let determinant = xx * yy - xy * xy;
    // The determinant is the product of the squares of both spreads, the trace about that of the greater one.
    let least = LEAST_SPREAD * (xx + yy);
    if determinant.partial_cmp(&(least * least)) != Some(core::cmp::Ordering::Greater) {
        return None;
    }
    let a = (sum(0, of) * yy - sum(1, of) * xy) / determinant;
    let b = (sum(1, of) * xx - sum(0, of) * xy) / determinant;
    Some([value - a * x - b * y, a, b]).filter(|plane| plane.iter().all(|part| part.is_finite()))
}

/// The greatest distance of a point from a plane, by the range of their values.
fn residual(points: &[[f64; 4]], plane: Plane, of: usize) -> f64 {
    let values = || points.iter().map(|point| point[of]);
    let range = values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min);
    let far = points.iter().map(|point| (point[of] - at(plane, point[0], point[1])).abs());
    far.fold(0.0, |most: f64, far| if far > 0.0 { most.max(far / range) } else { most })
}
