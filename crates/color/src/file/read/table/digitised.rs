//! Curves taken from figures, in pixels, with points whose place is known, as the R package colorSpec keeps them.
//!
//! Under `[Control]` stand at least three points, each with its pixel and what it means (`Xpx Ypx X Y`); under every other line in
//! brackets the pixels of a curve. Pixels are turned into wavelengths and values by the affine map that fits the points best.

use super::reshape::Reshaped;
use crate::file::read::text::{lines, number};

/// The line above the points whose place is known.
const MARK: &str = "[control]";

/// A value as 1, x and y have a part in it.
type Plane = [f64; 3];

/// The curves of a text, in wavelengths and values; nothing of a text that holds none, and none where no map fits.
pub(super) fn curves(text: &str) -> Option<Vec<Reshaped>> {
    let all: Vec<&str> = lines(text).map(|(_, line)| line).collect();
    let is_section = |at: &usize| all[*at].trim().starts_with('[') && all[*at].trim().ends_with(']');
    let sections: Vec<usize> = (0..all.len()).filter(is_section).collect();
    let control = sections.iter().position(|at| all[*at].trim().eq_ignore_ascii_case(MARK))?;
    let end = |index: usize| sections.get(index + 1).copied().unwrap_or(all.len());
    let known = all[sections[control] + 1..end(control)].iter().filter_map(|line| numbers::<4>(line));
    let Some((wavelength, value)) = fit(&known.collect::<Vec<_>>()) else { return Some(Vec::new()) };
    let curve = |index: usize| {
        let (first, end) = (sections[index], end(index));
        let line = |(at, text): (usize, &&str)| match numbers::<2>(text) {
            Some([x, y]) if (first..end).contains(&at) => {
                let of = |plane: Plane| plane[0] + plane[1] * x + plane[2] * y;
                format!("{}\t{}", of(wavelength), of(value))
            }
            _ if at == first => format!("wavelength\t{}", text.trim().trim_matches(['[', ']'])),
            _ if text.trim_start().starts_with('#') => (*text).to_owned(),
            _ => String::new(),
        };
        let text = all.iter().enumerate().map(line).collect::<Vec<_>>().join("\n");
        let note = format!(
            "pixels turned into wavelengths and values by the points from line {} on",
            sections[control] + 1
        );
        Reshaped { name: None, text, note }
    };
    Some((0..sections.len()).filter(|index| *index != control).map(curve).collect())
}

/// The numbers of a line that has so many, before a comment.
fn numbers<const N: usize>(line: &str) -> Option<[f64; N]> {
    let words = line.split('#').next().unwrap_or_default().split_whitespace();
    let found: Option<Vec<f64>> = words.map(|word| number(word, false)).collect();
    found?.try_into().ok()
}

/// The planes of least squares through X and through Y over the pixels.
fn fit(points: &[[f64; 4]]) -> Option<(Plane, Plane)> {
    let sum = |of: &dyn Fn(&[f64; 4]) -> f64| points.iter().map(of).sum::<f64>();
    let basis = |point: &[f64; 4], i: usize| if i == 0 { 1.0 } else { point[i - 1] };
    let row = |i: usize| [0, 1, 2].map(|j| sum(&|point| basis(point, i) * basis(point, j)));
    let matrix = [row(0), row(1), row(2)];
    let right = |of: usize| [0, 1, 2].map(|i| sum(&|point| basis(point, i) * point[of]));
    (points.len() >= 3).then_some(())?;
    Some((solve(matrix, right(2))?, solve(matrix, right(3))?))
}

/// The solution of three equations, by Cramer's rule; none where they depend on each other.
fn solve(matrix: [[f64; 3]; 3], right: [f64; 3]) -> Option<Plane> {
    let determinant = |m: [[f64; 3]; 3]| {
        let minor = |a: usize, b: usize| m[1][a] * m[2][b] - m[1][b] * m[2][a];
        m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)
    };
    let whole = determinant(matrix);
    let with = |column: usize| {
        let mut changed = matrix;
        (0..3).for_each(|row| changed[row][column] = right[row]);
        determinant(changed) / whole
    };
    Some([0, 1, 2].map(with)).filter(|plane| plane.iter().all(|part| part.is_finite()))
}
