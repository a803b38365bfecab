//! Pictures of environments: Radiance HDR and OpenEXR in equirectangular projection.

mod exr;
mod radiance;
#[cfg(test)]
pub(super) mod tests;

use glanz_color::models::RgbSpace;
use glanz_color::read::{Place, ReadError, excerpt};

use super::ReadOptions;
use super::notes::Notes;
use crate::EnvironmentMap;

/// How an OpenEXR file begins: 20000630, low byte first.
const EXR: &[u8] = &[0x76, 0x2f, 0x31, 0x01];
/// How a Radiance picture begins; the name of the program that wrote it follows.
const RADIANCE: &[u8] = b"#?";
/// Bytes of a pixel in memory.
const PIXEL: u64 = 12;
/// The most bytes of pixels: those of 16384×8192.
const MAX_BYTES: u64 = 16_384 * 8192 * PIXEL;
/// The most that a channel may be; sums of squares of it must fit into `f32`.
const MAX_VALUE: f32 = 1e12;

/// Reads a Radiance HDR or OpenEXR picture as an environment; its first bytes tell which. `file` is its name
/// for messages. Sides and memory are limited by `max_texture_side` and `max_texture_bytes` of `options`,
/// and to 16384×8192 pixels.
///
/// Of OpenEXR the half or float channels R, G and B of the first part that has them are taken. Primaries
/// other than those of sRGB are converted. The answer has what was left out or changed, in words.
///
/// # Errors
///
/// [`ReadError`] where the file is neither, breaks its format, or is too large.
pub fn read_environment(
    bytes: &[u8],
    file: &str,
    options: &ReadOptions,
) -> Result<(EnvironmentMap, Vec<String>), ReadError> {
    let mut source = Source { bytes, file, options, notes: Notes::default() };
    let mut map = if bytes.starts_with(EXR) {
        exr::read(&mut source)?
    } else if bytes.starts_with(RADIANCE) {
        radiance::read(&mut source)?
    } else {
        let start = excerpt(&bytes[..bytes.len().min(8)]);
        let expected = "a Radiance HDR or OpenEXR picture";
        return Err(ReadError::unsupported(file, Place::File, expected, start));
    };
    clean(&mut map.pixels, &mut source.notes);
    if map.width != 2 * map.height {
        source.notes.add(&format!(
            "the picture of {}×{} pixels is stretched to all directions; one of them is twice as wide as high",
            map.width, map.height
        ));
    }
    Ok((map, source.notes.into_strings()))
}

/// Makes every value usable.
fn clean(pixels: &mut [[f32; 3]], notes: &mut Notes) {
    let (mut negative, mut large, mut none) = (0, 0, 0);
    for pixel in pixels {
        let [a, b, c] = *pixel;
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            none += 1;
            *pixel = [0.0; 3];
            continue;
        }
        negative += u64::from(a.min(b).min(c) < 0.0);
        large += u64::from(a.max(b).max(c) > MAX_VALUE);
        // `max` also makes 0 of −0.
        *pixel = pixel.map(|value| if value > 0.0 { value.min(MAX_VALUE) } else { 0.0 });
    }
    notes.add_times("a pixel that is not finite is taken as black", none);
    notes.add_times("a pixel below 0 is taken as 0 in that channel", negative);
    notes.add_times(&format!("a pixel above {MAX_VALUE:e} is taken as that"), large);
}

/// What both readers share.
struct Source<'a> {
    bytes: &'a [u8],
    /// The file's name, for messages.
    file: &'a str,
    options: &'a ReadOptions,
    notes: Notes,
}

impl Source<'_> {
    fn malformed(&self, place: Place, expected: impl Into<String>, found: impl ToString) -> ReadError {
        ReadError::malformed(self.file, place, expected, found.to_string())
    }

    fn unsupported(&self, expected: impl Into<String>, found: impl ToString) -> ReadError {
        ReadError::unsupported(self.file, Place::File, expected, found.to_string())
    }

    /// That a picture of this size is within the limits.
    fn check_size(&self, width: usize, height: usize) -> Result<(), ReadError> {
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
    fn convert_to_srgb(&mut self, pixels: &mut [[f32; 3]], space: &RgbSpace) -> Result<(), ReadError> {
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
