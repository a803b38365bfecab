//! Pictures of environments: Radiance HDR and OpenEXR in equirectangular projection.

mod exr;
mod radiance;
mod source;
#[cfg(test)]
pub(super) mod tests;

use glanz_color::read::{Place, ReadError, excerpt};

use super::ReadOptions;
use super::notes::Notes;
use crate::EnvironmentMap;
use source::Source;

/// How an OpenEXR file begins: 20000630, low byte first.
const EXR: &[u8] = &[0x76, 0x2f, 0x31, 0x01];
/// How a Radiance picture begins; the name of the program that wrote it follows.
const RADIANCE: &[u8] = b"#?";
/// What the header of one has that begins in another way.
const RADIANCE_FORMAT: &[u8] = b"\nFORMAT=32-bit_rle_";
/// How far into a file that is looked for.
const HEADER: usize = 4096;
/// The most that a channel may be; sums of squares of it must fit into `f32`.
const MAX_VALUE: f32 = 1e12;

/// Reads a Radiance HDR or, with the feature `exr`, an OpenEXR picture as an environment; its first bytes tell which. `file` is its name
/// for messages. Sides and memory are limited by `max_texture_side` and `memory` of `options`.
///
/// Of OpenEXR the half or float channels R, G and B of the first part that has them are taken, else those of a layer,
/// else Y as grey. Primaries other than those of sRGB are converted, CIE XYZ too. The answer has what was left out or changed, in words.
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
    } else if is_radiance(bytes) {
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

fn is_radiance(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(HEADER)];
    bytes.starts_with(RADIANCE) || head.windows(RADIANCE_FORMAT.len()).any(|line| line == RADIANCE_FORMAT)
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
