//! JPEG pictures whose data end early: decoders fill what lacks with grey, and say nothing.

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::options::DecoderOptions;

/// What is said of a picture that is cut.
pub(crate) const CUT: &str = "ends early: what lacks of the picture is grey";

/// A baseline picture has at least two bits for each block of 64 pixels.
const PIXELS_PER_BYTE: usize = 256;

/// Whether a JPEG ends before its picture does: after its file was cut, or by a header that claims more than there is.
///
/// Only files without an end are decoded for it.
pub(crate) fn is_cut(bytes: &[u8]) -> bool {
    if !bytes.starts_with(b"\xff\xd8\xff") {
        return false;
    }
    let options = DecoderOptions::default().set_strict_mode(true);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    if decoder.decode_headers().is_err() {
        return false;
    }
    let pixels = decoder.dimensions().map_or(0, |(width, height)| width.saturating_mul(height));
    is_baseline(bytes) && pixels / PIXELS_PER_BYTE > bytes.len()
        || !has_end(bytes) && decoder.decode().is_err()
}

/// Whether the frame is baseline or extended: coefficients one block after the other, none of which takes no bits.
fn is_baseline(bytes: &[u8]) -> bool {
    let mut at = 2;
    while let Some(&[0xff, marker, high, low]) = bytes.get(at..).and_then(|rest| rest.first_chunk()) {
        match marker {
            0xc0 | 0xc1 => return true,
            0xc2..=0xcf if !matches!(marker, 0xc4 | 0xc8 | 0xcc) => return false,
            0xda => return false,
            _ => at += 2 + usize::from(u16::from_be_bytes([high, low])),
        }
    }
    false
}

/// Whether there is an end of the picture after the last scan. Within the data of a scan no byte of 255 is followed by such ones.
fn has_end(bytes: &[u8]) -> bool {
    let last = |marker: [u8; 2]| bytes.windows(2).rposition(|pair| pair == marker);
    last([0xff, 0xd9]) > last([0xff, 0xda])
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use image::{DynamicImage, ImageFormat, RgbImage};

    use super::*;

    fn picture(side: u32) -> Vec<u8> {
        let image =
            RgbImage::from_fn(side, side, |x, y| image::Rgb([(x * 7 % 256) as u8, (y * 5 % 256) as u8, 90]));
        let mut bytes = Cursor::new(Vec::new());
        DynamicImage::from(image).write_to(&mut bytes, ImageFormat::Jpeg).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn whole_pictures_are_whole() {
        let bytes = picture(200);
        assert!(!is_cut(&bytes));
        // Nothing of the picture lacks where the end alone does, or where more follows it.
        assert!(!is_cut(&bytes[..bytes.len() - 2]));
        assert!(!is_cut(&[&bytes[..], &[0; 300]].concat()));
        assert!(!is_cut(b"\x89PNG\r\n\x1a\n"));
    }

    #[test]
    fn cut_pictures_are_cut() {
        let bytes = picture(200);
        for part in [0.3, 0.7, 0.95] {
            assert!(is_cut(&bytes[..(bytes.len() as f64 * part) as usize]), "{part}");
        }
    }

    #[test]
    fn a_header_that_claims_more_than_there_is_is_seen() {
        let mut bytes = picture(16);
        let at = bytes.windows(2).position(|pair| pair == [0xff, 0xc0]).unwrap();
        // Height and width.
        bytes[at + 5..at + 9].copy_from_slice(&[0x07, 0xd0, 0x07, 0xd0]);
        assert!(is_cut(&bytes));
    }
}
