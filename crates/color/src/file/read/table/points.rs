//! The points of a spectrum, by rising wavelength.

use super::Source;
use crate::file::read::named::note;
use crate::file::read::units::Scale;
use crate::file::read::{NamedSpectrum, Place, ReadError};
use crate::spectra::{FIRST_NM, LAST_NM};

/// Where the numbers of a spectrum come from.
pub(super) struct Table<'a> {
    pub(super) source: &'a Source<'a>,
    /// The lines' numbers in the file.
    pub(super) lines: &'a [u64],
    pub(super) scale: Scale,
}

impl Table<'_> {
    /// Gives a spectrum its points, by rising wavelength.
    pub(super) fn fill(
        &self,
        spectrum: &mut NamedSpectrum,
        axis: &[f64],
        values: &[f64],
    ) -> Result<(), ReadError> {
        let mut points = Vec::with_capacity(values.len());
        let mut without = 0;
        for ((number, value), line) in axis.iter().zip(values).zip(self.lines) {
            match (number.is_finite(), value.is_finite()) {
                (true, true) => {
                    let nm = self
                        .scale
                        .nm(*number, self.source.file, || Place::Field { line: *line, field: 1 })?;
                    points.push((nm, *value, *line));
                }
                (false, true) => without += 1,
                (_, false) => {}
            }
        }
        if without > 0 {
            note(&mut spectrum.notes, format!("{without} values without a wavelength are left out"));
        }
        if points.first().zip(points.last()).is_some_and(|(first, last)| first.0 > last.0) {
            points.reverse();
        }
        let points = self.merged(self.ordered(points, &mut spectrum.notes)?, &mut spectrum.notes);
        (spectrum.nm, spectrum.values) = points.into_iter().map(|(nm, value, _)| (nm, value)).unzip();
        Ok(())
    }

    /// Wavelengths must rise, or fall, where they are used; beyond the visible band those that do not are left out.
    fn ordered(&self, points: Vec<Point>, notes: &mut Vec<String>) -> Result<Vec<Point>, ReadError> {
        let wrong = |points: &[Point]| points.windows(2).position(|pair| pair[0].0 > pair[1].0);
        if wrong(&points).is_none() {
            return Ok(points);
        }
        let in_band = |point: &Point| (FIRST_NM..=LAST_NM).contains(&point.0);
        let kept: Vec<Point> = points.iter().copied().filter(in_band).collect();
        match wrong(&kept) {
            None if kept.len() > 1 => {
                let left_out = points.len() - kept.len();
                note(notes, format!("{left_out} values beyond 300 to 780 nm are out of order and left out"));
                Ok(kept)
            }
            _ => {
                let at = wrong(&points).unwrap_or_default();
                let ((a, _, line), (b, _, other)) = (points[at], points[at + 1]);
                let (a, b, line) = if line < other { (a, b, other) } else { (b, a, line) };
                let order = if points[0].2 < points[points.len() - 1].2 { "rising" } else { "falling" };
                let found = format!("{b} nm after {a} nm");
                let expected = format!("wavelengths in {order} order, each once");
                Err(ReadError::malformed(self.source.file, Place::Line(line), expected, found))
            }
        }
    }

    /// Each wavelength once: of several values the mean.
    fn merged(&self, points: Vec<Point>, notes: &mut Vec<String>) -> Vec<Point> {
        let mut merged: Vec<Point> = Vec::with_capacity(points.len());
        let (mut twice, mut same) = (0, 1.0);
        for point in points {
            match merged.last_mut() {
                Some(last) if last.0 == point.0 => {
                    (twice, same) = (twice + 1, same + 1.0);
                    last.1 += (point.1 - last.1) / same;
                }
                _ => {
                    same = 1.0;
                    merged.push(point);
                }
            }
        }
        if twice > 0 {
            note(
                notes,
                format!("{twice} wavelengths stand there more than once: the mean of their values is taken"),
            );
        }
        merged
    }
}

/// A wavelength in nm, a value, and its line.
type Point = (f64, f64, u64);
