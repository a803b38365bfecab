//! What both readers share.

use glanz_math::{MemoryBudget, OverBudget};

use super::PLANES;
use super::error::ReadError;
use super::limits::{MAX_PIXELS, MAX_SIDE};
use crate::compare::Picture;

/// A file in memory.
pub(super) struct Source<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) name: &'a str,
    /// What may be taken.
    pub(super) memory: MemoryBudget,
}

impl Source<'_> {
    pub(super) fn content(&self, expected: impl ToString, found: impl ToString) -> ReadError {
        ReadError::Content {
            name: self.name.to_owned(),
            expected: expected.to_string(),
            found: found.to_string(),
        }
    }

    /// That a picture of this size is within the limits and not more than the file can hold, whose every
    /// byte stands for at most `pixels_per_byte`.
    pub(super) fn check_size(
        &self,
        width: usize,
        height: usize,
        pixels_per_byte: usize,
    ) -> Result<(), ReadError> {
        self.check_limits(width, height)?;
        let held = self.bytes.len().saturating_mul(pixels_per_byte);
        if width.saturating_mul(height) > held {
            let expected = format!("at most the {held} pixels that {} bytes can hold", self.bytes.len());
            return Err(self.content(expected, format_args!("a claim of {width}×{height}")));
        }
        Ok(())
    }

    pub(super) fn over(&self, over: OverBudget) -> ReadError {
        ReadError::Memory { name: self.name.to_owned(), over }
    }

    /// That there is memory for a picture of this size, of which a decoder holds so many bytes a pixel beside the picture.
    pub(super) fn check_memory(&self, width: usize, height: usize, decoder: u64) -> Result<(), ReadError> {
        let bytes = (width as u64 * height as u64).saturating_mul(PLANES + decoder);
        let what = format_args!("a picture of {width}×{height} pixels");
        self.memory.check(what, bytes).map_err(|over| self.over(over))
    }

    /// That a picture of this size is within the limits.
    pub(super) fn check_limits(&self, width: usize, height: usize) -> Result<(), ReadError> {
        if width > MAX_SIDE || height > MAX_SIDE || width.saturating_mul(height) > MAX_PIXELS {
            return Err(ReadError::TooLarge { name: self.name.to_owned(), width, height });
        }
        Ok(())
    }

    pub(super) fn check_finite(&self, picture: &Picture) -> Result<(), ReadError> {
        for plane in &picture.rgb {
            if let Some(i) = plane.iter().position(|value| !value.is_finite()) {
                let (x, y) = (i % picture.width, i / picture.width);
                return Err(ReadError::NotFinite { name: self.name.to_owned(), x, y, value: plane[i] });
            }
        }
        Ok(())
    }
}
