//! PNG, JPEG and WebP pictures.

use std::io::Cursor;

use glanz_color::read::{Place, ReadError, excerpt};
use glanz_math::MemoryBudget;
use glanz_picture::wrong_png_palette;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};

use super::{ReadOptions, jpeg};
use crate::Texture;
use crate::memory::texture_bytes;

/// The most texels that one byte of a file can stand for: deflate packs 1032 bytes into one, and a
/// black-and-white PNG eight texels into a byte; a JPEG block of 64 texels takes at least one bit
/// of a scan. More than this is a claim that the file cannot hold.
const TEXELS_PER_BYTE: u64 = 8 * 1032;
/// Small pictures are never refused for what they claim.
const ALWAYS_ALLOWED_TEXELS: u64 = 1 << 16;

/// Decodes a PNG, JPEG or WebP picture, taken as a colour texture (`srgb`) that repeats.
///
/// The sides and the memory are limited by `options`; `name` is the file's name in messages.
pub fn read_texture(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Texture, ReadError> {
    decode(bytes, name, Place::File, options, &mut options.memory.clone())
}

/// What is odd about a picture that can be decoded: a JPEG that is cut. `name` is the file's name in the remark.
///
/// ```
/// use glanz_scene::read::remark_of_texture;
///
/// assert_eq!(remark_of_texture(b"\x89PNG\r\n\x1a\n", "wood.png"), None);
/// ```
pub fn remark_of_texture(bytes: &[u8], name: &str) -> Option<String> {
    jpeg::is_cut(bytes).then(|| format!("the picture '{name}' {}", jpeg::CUT))
}

/// Decodes a picture that lies at `place` of `file`, and takes its size off a budget.
pub(super) fn decode(
    bytes: &[u8],
    file: &str,
    place: Place,
    options: &ReadOptions,
    memory: &mut MemoryBudget,
) -> Result<Texture, ReadError> {
    let format = format_of(bytes).ok_or_else(|| {
        let start = excerpt(&bytes[..bytes.len().min(8)]);
        ReadError::unsupported(file, place.clone(), "a PNG, JPEG or WebP picture", start)
    })?;
    if let Some(found) = wrong_png_palette(bytes) {
        let found = format!("{found} bytes");
        return Err(ReadError::malformed(file, place, "a palette of whole entries", found));
    }
    let picture = |error: ImageError| {
        let (expected, found) = match &error {
            ImageError::Limits(_) => (within(options.max_texture_side), "a larger one".to_owned()),
            _ => ("a complete picture".to_owned(), error.to_string()),
        };
        ReadError::malformed(file, place.clone(), expected, found)
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    reader.limits(limits(options, *memory));
    let decoder = reader.into_decoder().map_err(picture)?;
    let (width, height) = decoder.dimensions();
    check_size((width, height), bytes.len(), file, &place, options)?;
    // The decoder's picture and the texels are there at once.
    let both = (u64::from(decoder.color_type().bytes_per_pixel()) + 4) * u64::from(width) * u64::from(height);
    let over = |over| ReadError::memory(file, place.clone(), over);
    memory.check(format_args!("a texture of {width}×{height} texels"), both).map_err(over)?;
    spend((width, height), file, &place, memory)?;
    let rgba = DynamicImage::from_decoder(decoder).map_err(picture)?.into_rgba8();
    Ok(Texture { width, height, rgba: rgba.into_raw(), srgb: true, ..Texture::default() })
}

/// Takes the size of a texture off a budget.
pub(super) fn spend(
    (width, height): (u32, u32),
    file: &str,
    place: &Place,
    memory: &mut MemoryBudget,
) -> Result<(), ReadError> {
    memory
        .take(format_args!("a texture of {width}×{height} texels"), texture_bytes(width, height))
        .map_err(|over| ReadError::memory(file, place.clone(), over))
}

/// How large a picture may be.
fn within(side: u32) -> String {
    format!("a picture of 1 to {side} texels along each side")
}

/// The format after the first bytes.
fn format_of(bytes: &[u8]) -> Option<ImageFormat> {
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        Some(ImageFormat::Png)
    } else if bytes.starts_with(b"\xff\xd8\xff") {
        Some(ImageFormat::Jpeg)
    } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        Some(ImageFormat::WebP)
    } else {
        None
    }
}

/// Limits for the decoder. Its memory may reach twice the picture's at 16 bits per channel.
fn limits(options: &ReadOptions, memory: MemoryBudget) -> Limits {
    let mut limits = Limits::default();
    limits.max_image_width = Some(options.max_texture_side);
    limits.max_image_height = Some(options.max_texture_side);
    limits.max_alloc = Some(memory.left().saturating_mul(4));
    limits
}

/// Refuses pictures of no texels, and of more than the file can hold.
fn check_size(
    (width, height): (u32, u32),
    bytes: usize,
    file: &str,
    place: &Place,
    options: &ReadOptions,
) -> Result<(), ReadError> {
    let texels = u64::from(width) * u64::from(height);
    let malformed = |expected: String| {
        Err(ReadError::malformed(file, place.clone(), expected, format!("{width}×{height}")))
    };
    let side = options.max_texture_side;
    if width == 0 || height == 0 || width > side || height > side {
        return malformed(within(side));
    }
    let held = (bytes as u64).saturating_mul(TEXELS_PER_BYTE).max(ALWAYS_ALLOWED_TEXELS);
    if texels > held {
        return malformed(format!("at most the {held} texels that {bytes} bytes can hold"));
    }
    Ok(())
}

#[cfg(test)]
pub(super) mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A PNG of these RGBA texels.
    pub(crate) fn png(width: u32, height: u32, rgba: &[u8]) -> Vec<u8> {
        encode(width, height, rgba, ImageFormat::Png)
    }

    fn encode(width: u32, height: u32, rgba: &[u8], format: ImageFormat) -> Vec<u8> {
        let picture = image::RgbaImage::from_raw(width, height, rgba.to_vec()).unwrap();
        let mut bytes = Cursor::new(Vec::new());
        match format {
            ImageFormat::Jpeg => DynamicImage::from(picture).to_rgb8().write_to(&mut bytes, format).unwrap(),
            _ => picture.write_to(&mut bytes, format).unwrap(),
        }
        bytes.into_inner()
    }

    /// The same picture in all formats.
    pub(crate) fn samples() -> [Vec<u8>; 3] {
        let rgba: Vec<u8> = (0..16 * 8 * 4).map(|i| (i * 37 % 251) as u8).collect();
        [ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::WebP].map(|format| encode(16, 8, &rgba, format))
    }

    #[test]
    fn a_webp_is_decoded_to_its_bytes() {
        let [png, _, webp] =
            samples().map(|bytes| read_texture(&bytes, "p", &ReadOptions::default()).unwrap());
        assert_eq!(webp, png);
    }

    #[test]
    fn a_png_is_decoded_to_its_bytes() {
        let texture =
            read_texture(&png(2, 1, &[1, 2, 3, 4, 5, 6, 7, 8]), "p", &ReadOptions::default()).unwrap();
        assert_eq!((texture.width, texture.height, texture.srgb), (2, 1, true));
        assert_eq!(texture.rgba, [1, 2, 3, 4, 5, 6, 7, 8]);
    }

    #[test]
    fn a_palette_of_parts_of_entries_is_refused() {
        let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
        for (kind, data) in
            [(b"IHDR", &[0, 0, 0, 1, 0, 0, 0, 1, 8, 3, 0, 0, 0][..]), (b"PLTE", &[1; 4]), (b"IDAT", &[0; 9])]
        {
            bytes.extend((data.len() as u32).to_be_bytes());
            let chunk = [&kind[..], data].concat();
            bytes.extend(&chunk);
            bytes.extend(crc32(&chunk).to_be_bytes());
        }
        let error = read_texture(&bytes, "p.png", &ReadOptions::default()).unwrap_err().to_string();
        assert!(error.contains("a palette of whole entries, found 4 bytes"), "{error}");
    }

    #[test]
    fn a_jpeg_is_decoded() {
        let gray = vec![128; 8 * 8 * 4];
        let texture =
            read_texture(&encode(8, 8, &gray, ImageFormat::Jpeg), "j", &ReadOptions::default()).unwrap();
        assert!(texture.rgba.chunks(4).all(|texel| texel[0].abs_diff(128) < 3 && texel[3] == 255));
    }

    #[test]
    fn limits_of_side_and_memory_hold() {
        let bytes = png(64, 2, &[0; 64 * 2 * 4]);
        let narrow = ReadOptions { max_texture_side: 63, ..ReadOptions::default() };
        assert!(read_texture(&bytes, "p", &narrow).is_err());
        let with = |bytes: u64| ReadOptions {
            memory: MemoryBudget::of_bytes(bytes),
            max_texture_side: 64,
            ..ReadOptions::default()
        };
        // 128 texels of 4 bytes, and 4/3 of that again with the levels.
        let error = read_texture(&bytes, "p", &with(1194)).unwrap_err().to_string();
        assert!(
            error.contains("expected at most 1.2 kB of memory, found 1.2 kB for a texture of 64×2 texels"),
            "{error}"
        );
        assert!(error.contains("it takes at least --memory 2kB"), "{error}");
        assert!(read_texture(&bytes, "p", &with(1195)).is_ok());
    }

    #[test]
    fn a_picture_that_is_too_wide_is_told_what_is_allowed() {
        let narrow = ReadOptions { max_texture_side: 15, ..ReadOptions::default() };
        let mut huge = encode(8, 8, &[128; 256], ImageFormat::Jpeg);
        let frame = huge.windows(2).position(|pair| pair == [0xff, 0xc0]).unwrap();
        // Height and width, behind marker, length and precision.
        huge[frame + 5..frame + 9].copy_from_slice(&[0xff; 4]);
        for bytes in samples().into_iter().chain([huge]) {
            let error = read_texture(&bytes, "p", &narrow).unwrap_err().to_string();
            assert!(
                error.contains("expected a picture of 1 to 15 texels along each side, found "),
                "{error}"
            );
        }
    }

    #[test]
    fn a_picture_larger_than_its_file_can_hold_is_refused() {
        let mut bytes = png(4, 4, &[0; 64]);
        // Width and height in the header of PNG, at bytes 16 to 23, and the checksum after it.
        bytes[16..24].copy_from_slice(&[0, 0, 0x3f, 0xff, 0, 0, 0x3f, 0xff]);
        let crc = crc32(&bytes[12..29]);
        bytes[29..33].copy_from_slice(&crc.to_be_bytes());
        let error = read_texture(&bytes, "bomb.png", &ReadOptions::default()).unwrap_err().to_string();
        assert!(error.contains("bomb.png") && error.contains("16383×16383"), "{error}");
    }

    /// The checksum of PNG chunks, bit by bit.
    fn crc32(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(!0u32, |crc, byte| {
            (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
                if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 }
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn damaged_pictures_do_no_harm(
            which in 0usize..3,
            keep in 0usize..400,
            flips in proptest::collection::vec((0usize..400, 0u8..8), 0..4),
        ) {
            let mut bytes = samples()[which].clone();
            for (byte, bit) in flips {
                let len = bytes.len();
                bytes[byte % len] ^= 1 << bit;
            }
            bytes.truncate(keep.max(4));
            if let Err(error) = read_texture(&bytes, "picture", &ReadOptions::default()) {
                prop_assert!(error.to_string().starts_with("picture: "));
            }
        }
    }
}
