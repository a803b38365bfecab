//! What both readers share.

use glanz_color::Matrix3;
use glanz_color::models::RgbSpace;
use glanz_color::read::{Place, ReadError};

use crate::memory::environment_bytes;
use crate::read::ReadOptions;
use crate::read::notes::Notes;

/// Twice the least area of a triangle of primaries.
const LEAST_AREA: f64 = 1e-4;

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
        // Decoding takes less: the picture beside its planes, 24 bytes a pixel.
        let bytes = environment_bytes(width, height);
        let what = format_args!("an environment of {width}×{height} pixels");
        self.options.memory.check(what, bytes).map_err(|over| ReadError::memory(self.file, Place::File, over))
    }

    /// Brings CIE XYZ to linear sRGB. These are colours as they are: there is no white that they were balanced for.
    pub(super) fn convert_xyz(&mut self, pixels: &mut [[f32; 3]]) {
        let matrix = RgbSpace::LINEAR_SRGB.from_xyz_matrix();
        for pixel in pixels {
            *pixel = matrix.apply(pixel.map(f64::from)).map(|value| value as f32);
        }
        self.notes.add("the channels are CIE XYZ; the colours are converted");
    }

    /// Brings pixels of other primaries to those of sRGB; their white becomes D65. Primaries that span no colours are
    /// ignored, with a remark.
    pub(super) fn convert_to_srgb(&mut self, pixels: &mut [[f32; 3]], space: &RgbSpace) {
        if space.to_linear_srgb_matrix().is_none() {
            return;
        }
        let Some(matrix) = conversion(space) else {
            self.notes.add("the chromaticities of primaries and white span no colours and are ignored");
            return;
        };
        for pixel in pixels {
            *pixel = matrix.apply(pixel.map(f64::from)).map(|value| value as f32);
        }
        self.notes.add("the primaries are not those of sRGB; the colours are converted");
    }
}

/// The most that a chromaticity of a primary is from 0: those of cameras are beyond the spectral locus.
const MOST_CHROMATICITY: f64 = 3.0;

/// Linear components of a space to those of linear sRGB; `None` where its primaries span no colours.
pub(super) fn conversion(space: &RgbSpace) -> Option<Matrix3> {
    let [x, y] = space.white;
    let is_white = x >= 0.0 && y > 0.0 && x + y <= 1.0;
    let is_near = space.primaries.as_flattened().iter().all(|value| value.abs() <= MOST_CHROMATICITY);
    let [[rx, ry], [gx, gy], [bx, by]] = space.primaries;
    let area = (gx - rx) * (by - ry) - (bx - rx) * (gy - ry);
    if !is_white || !is_near || area.abs() < LEAST_AREA {
        return None;
    }
    let matrix = space.to_linear_srgb_matrix().unwrap_or(Matrix3::IDENTITY);
    matrix.0.iter().flatten().all(|value| value.is_finite()).then_some(matrix)
}
