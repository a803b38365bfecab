//! What both readers share.

use glanz_color::models::RgbSpace;
use glanz_color::read::{Place, ReadError};

use crate::read::ReadOptions;
use crate::read::notes::Notes;

/// Bytes of a pixel in memory.
pub(super) const PIXEL: u64 = 12;
/// The most bytes of pixels: those of 16384×8192.
const MAX_BYTES: u64 = 16_384 * 8192 * PIXEL;

/// A file in memory, how it is read, and what is said of it.
pub(super) struct Source<'a> {
    pub(super) bytes: &'a [u8],
    /// The file's name, for messages.
    pub(super) file: &'a str,
    pub(super) options: &'a ReadOptions,
    pub(super) notes: Notes,
}

impl Source<'_> {
    pub(super) fn malformed(
        &self,
        place: Place,
        expected: impl Into<String>,
        found: impl ToString,
    ) -> ReadError {
        ReadError::malformed(self.file, place, expected, found.to_string())
    }

    pub(super) fn unsupported(&self, expected: impl Into<String>, found: impl ToString) -> ReadError {
        ReadError::unsupported(self.file, Place::File, expected, found.to_string())
    }

    /// That a picture of this size is within the limits.
    pub(super) fn check_size(&self, width: usize, height: usize) -> Result<(), ReadError> {
        let side = self.options.max_texture_side as usize;
        if !(1..=side).contains(&width) || !(1..=side).contains(&height) {
            let expected = format!("a picture of 1 to {side} pixels along each side");
            return Err(self.malformed(Place::File, expected, format!("{width}×{height}")));
        }
        let (found, limit) =
            (width as u64 * height as u64 * PIXEL, self.options.max_texture_bytes.min(MAX_BYTES));
        if found > limit {
            let (file, place, unit) = (self.file.to_owned(), Place::File, "bytes of pixels");
            return Err(ReadError::TooLarge { file, place, limit, unit, found });
        }
        Ok(())
    }

    /// Brings pixels of other primaries to those of sRGB; their white becomes D65.
    pub(super) fn convert_to_srgb(
        &mut self,
        pixels: &mut [[f32; 3]],
        space: &RgbSpace,
    ) -> Result<(), ReadError> {
        let Some(matrix) = space.to_linear_srgb_matrix() else { return Ok(()) };
        if !matrix.0.iter().flatten().all(|value| value.is_finite()) {
            let expected = "chromaticities of three primaries and a white";
            let found = format!("{:?} and {:?}", space.primaries, space.white);
            return Err(self.malformed(Place::File, expected, found));
        }
        for pixel in pixels {
            *pixel = matrix.apply(pixel.map(f64::from)).map(|value| value as f32);
        }
        self.notes.add("the primaries are not those of sRGB; the colours are converted");
        Ok(())
    }
}
