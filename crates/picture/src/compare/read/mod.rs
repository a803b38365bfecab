//! Pictures from files.

mod error;
mod exr;
mod limits;
mod png;
mod source;
#[cfg(test)]
mod tests;

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

pub use error::ReadError;
pub use limits::{MAX_PIXELS, MAX_SIDE};

use glanz_math::MemoryBudget;

use super::Picture;
use source::Source;

/// The most bytes of a file: [`MAX_PIXELS`] of eight `f32` channels, not compressed.
const MAX_FILE: u64 = (MAX_PIXELS * 8 * 4) as u64;
/// What a pixel of a picture takes: three floats.
const PLANES: u64 = 12;
/// How a PNG begins (ISO/IEC 15948, 5.2).
const PNG: [u8; 8] = *b"\x89PNG\r\n\x1a\n";
/// How an OpenEXR file begins: 20000630, low byte first.
const EXR: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];

/// Reads a PNG file, or with the feature `exr` an OpenEXR file; its first bytes tell which.
///
/// Of a PNG, 1 to 16 bits per sample are taken as sRGB codes and straight alpha. Of OpenEXR, the half or
/// float channels R, G, B of the first part that has them are taken, else the first layer `name.R`, … that
/// has them; they are premultiplied with alpha, linear, and of the primaries that the file names. The
/// compressions B44 and B44A and deep data are not read.
///
/// Memory grows with what the file holds, not with what it claims, up to [`MAX_PIXELS`] and the default budget.
pub fn read_picture(path: impl AsRef<Path>) -> Result<Picture, ReadError> {
    read_picture_within(path, &mut MemoryBudget::default())
}

/// The same within a budget, off which the picture is taken.
pub fn read_picture_within(path: impl AsRef<Path>, memory: &mut MemoryBudget) -> Result<Picture, ReadError> {
    let path = path.as_ref();
    let failed = |source: io::Error| ReadError::File { path: path.to_owned(), source };
    let name = path.display().to_string();
    let mut file = File::open(path).map_err(failed)?;
    let mut bytes = Vec::new();
    // The first bytes alone at first: a device may go on for ever.
    Read::by_ref(&mut file).take(PNG.len() as u64).read_to_end(&mut bytes).map_err(failed)?;
    if !bytes.starts_with(&PNG) && !bytes.starts_with(&EXR) {
        return Err(ReadError::Format { name });
    }
    file.take(MAX_FILE).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > MAX_FILE {
        return Err(ReadError::FileTooLarge { path: path.to_owned(), limit: MAX_FILE });
    }
    decode_picture_within(&bytes, &name, memory)
}

/// The same from the bytes of a file that is called `name` in messages.
pub fn decode_picture(bytes: &[u8], name: &str) -> Result<Picture, ReadError> {
    decode_picture_within(bytes, name, &mut MemoryBudget::default())
}

/// The same within a budget, off which the picture is taken.
pub fn decode_picture_within(
    bytes: &[u8],
    name: &str,
    memory: &mut MemoryBudget,
) -> Result<Picture, ReadError> {
    let source = Source { bytes, name, memory: *memory };
    let picture = if bytes.starts_with(&PNG) {
        png::decode(&source)?
    } else if bytes.starts_with(&EXR) {
        exr::decode(&source)?
    } else {
        return Err(ReadError::Format { name: name.to_owned() });
    };
    source.check_finite(&picture)?;
    let what = format_args!("a picture of {}×{} pixels", picture.width, picture.height);
    memory.take(what, PLANES * picture.pixels() as u64).map_err(|over| source.over(over))?;
    Ok(picture)
}
