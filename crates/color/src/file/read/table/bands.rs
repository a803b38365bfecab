//! Bands that a table gives by their ends: the middles are the wavelengths.

use super::axes::Axis;
use super::head::Head;
use crate::file::read::Quantity;
use crate::file::read::named::note;
use crate::file::read::units::Column;

/// The fewest lines by which ends of bands are told from values.
const FEWEST: usize = 3;
/// How far the ends of a band may be apart, by the mean step from one band to the next: bands may overlap.
const WIDEST: f64 = 4.0;
/// Two wavelengths that are nearer than this, by the same step, are no ends of a band, but two scales: in air and in vacuum.
const NARROWEST: f64 = 0.05;
/// Below this, values such as fractions of light may lie near the wavelengths, in µm or eV.
const LEAST_APART: f64 = 100.0;
/// How near such an end must be to the beginning of the next band, by the step.
const TOUCHING: f64 = 0.05;

/// Columns beside one of wavelengths that are near these in each line: the ends of bands, or their ends and middles. The last one
/// becomes an axis, with the middles.
pub(super) fn find(axes: &mut Vec<Axis>, head: &Head, values: &mut [Vec<f64>], notes: &mut Vec<String>) {
    let mut at = 0;
    while at < axes.len() {
        let (first, scale) = (axes[at].column, axes[at].scale);
        let near = (first + 1..values.len().saturating_sub(1)).take(2);
        let ends = near.take_while(|column| is_end(head, values, first, *column)).count();
        axes.retain(|axis| !(first + 1..=first + ends).contains(&axis.column));
        if ends > 0 {
            let middles = middles(&values[first..=first + ends]);
            let width = middles.iter().map(|(_, width)| *width).fold(0.0, f64::max);
            // Both are wavelengths, and neither is a spectrum; those beside the values count.
            if width >= NARROWEST * step(&values[first]) {
                values[first + ends] = middles.into_iter().map(|(middle, _)| middle).collect();
                note(notes, "bands by the wavelengths of their ends: their middles are taken");
            } else {
                note(notes, "two columns of wavelengths beside each other: the second one is taken");
            }
            let added = (first + 1..=first + ends).map(|column| Axis { column, scale });
            axes.splice(at + 1..at + 1, added);
        }
        at += 1 + ends;
    }
}

/// The middle and the width of each band, by the least and the greatest of its wavelengths.
fn middles(columns: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let band = |line: usize| {
        let ends = columns.iter().map(|column| column[line]);
        let (low, high) = (ends.clone().fold(f64::MAX, f64::min), ends.fold(f64::MIN, f64::max));
        if columns[0][line].is_finite() { (0.5 * (low + high), high - low) } else { (f64::NAN, 0.0) }
    };
    (0..columns[0].len()).map(band).collect()
}

/// The mean step from one wavelength to the next.
fn step(axis: &[f64]) -> f64 {
    let mut known = axis.iter().filter(|value| value.is_finite());
    match (known.clone().next(), known.next_back()) {
        (Some(first), Some(last)) => (last - first).abs() / (axis.len().max(2) - 1) as f64,
        _ => 0.0,
    }
}

/// Whether a column holds the other end, or the middle, of the bands of a column of wavelengths: it rises or falls with them,
/// always above them or always below, and never by more than a few steps.
fn is_end(head: &Head, values: &[Vec<f64>], axis: usize, column: usize) -> bool {
    let said = head.title.is_none().then(|| Column::of(&head.columns[column]));
    if said.is_some_and(|said| said.quantity != Quantity::Unknown || said.is_percent()) {
        return false;
    }
    let (axis, ends) = (&values[axis], &values[column]);
    let points: Vec<(f64, f64)> =
        axis.iter().copied().zip(ends.iter().copied()).filter(|(nm, _)| nm.is_finite()).collect();
    let step = step(axis);
    let pairs = || points.windows(2).map(|pair| (pair[0], pair[1]));
    let is_near = |(nm, end): &(f64, f64)| end.is_finite() && (end - nm).abs() <= WIDEST * step;
    let rises = pairs().all(|(a, b)| a.0 < b.0 && a.1 < b.1);
    let falls = pairs().all(|(a, b)| a.0 > b.0 && a.1 > b.1);
    let is_above = points.iter().all(|(nm, end)| end > nm);
    let is_below = points.iter().all(|(nm, end)| end < nm);
    let touches = |(a, b): ((f64, f64), (f64, f64))| {
        (a.1 - b.0).abs().min((a.0 - b.1).abs()) <= TOUCHING * (a.0 - b.0).abs()
    };
    points.len() >= FEWEST
        && (rises || falls)
        && (is_above || is_below)
        && points.iter().all(is_near)
        && (points.iter().all(|(nm, _)| *nm >= LEAST_APART) || pairs().all(touches))
}
