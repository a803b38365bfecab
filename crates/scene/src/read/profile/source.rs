//! What both readers share.

use glanz_color::read::{Place, ReadError, excerpt};

use crate::read::notes::Notes;

/// The most bytes of a file. A profile at every degree of both angles takes half a megabyte.
pub const MAX_PROFILE_BYTES: u64 = 16 << 20;
/// The most that any number of a file may be, in cd, lm or as a factor.
const MAX_VALUE: f64 = 1e12;

/// The name of a file, for messages, and what is said of it.
pub(super) struct Source<'a> {
    pub(super) file: &'a str,
    pub(super) notes: Notes,
}

impl Source<'_> {
    pub(super) fn malformed(
        &self,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> ReadError {
        ReadError::malformed(self.file, place, expected, found)
    }

    /// A number that stands in a line.
    pub(super) fn number(&self, text: &str, line: u64, what: &str) -> Result<f64, ReadError> {
        let number = text.parse().ok().filter(|value: &f64| value.abs() <= MAX_VALUE);
        number.ok_or_else(|| {
            let expected = format!("{what}, a number of at most {MAX_VALUE:e}");
            self.malformed(Place::Line(line), expected, excerpt(text))
        })
    }

    /// A number of things, at least 1.
    pub(super) fn count(&self, value: f64, line: u64, what: &str) -> Result<usize, ReadError> {
        // More would not fit into a file.
        let most = MAX_PROFILE_BYTES;
        match value.fract() == 0.0 && (1.0..=most as f64).contains(&value) {
            true => Ok(value as usize),
            false => Err(self.malformed(
                Place::Line(line),
                format!("{what}, a whole number from 1 to {most}"),
                value.to_string(),
            )),
        }
    }

    /// Intensities without negative ones, which measurements have where there is no light.
    pub(super) fn not_negative(&mut self, candela: &mut [f64]) {
        let negative = candela.iter_mut().filter(|value| **value < 0.0);
        let count = negative.map(|value| *value = 0.0).count();
        self.notes.add_times("an intensity below 0 is taken as 0", count as u64);
    }
}
