//! PNG: sRGB codes of 1 to 16 bits, over black.

use std::io::Cursor;

use ::png::{BitDepth, ColorType, Decoder, Info, Limits, Reader, Transformations};
use glanz_color::srgb_decode;

use super::super::rows::three_planes;
use super::super::{Picture, Scale};
use super::error::ReadError;
use super::limits::MAX_PIXELS;
use super::source::Source;
use crate::wrong_png_palette;

/// Deflate packs at most 1032 bytes into one, and a byte holds at most eight pixels.
const PIXELS_PER_BYTE: usize = 8 * 1032;
/// What the decoder may use beside the picture: one line, palettes, texts, a colour profile.
const DECODER_BYTES: usize = 64 << 20;
/// The gamma chunk of sRGB, 1/2.2, in units of 1e-5 (ISO/IEC 15948, 11.3.3.5).
const SRGB_GAMMA: u32 = 45_455;

pub(super) fn decode(source: &Source) -> Result<Picture, ReadError> {
    if let Some(bytes) = wrong_png_palette(source.bytes) {
        return Err(source.content("a palette of whole entries", format_args!("{bytes} bytes")));
    }
    let failed = |error: ::png::DecodingError| source.content("a complete PNG", error);
    let limits = Limits { bytes: MAX_PIXELS * 8 + DECODER_BYTES };
    let mut decoder = Decoder::new_with_limits(Cursor::new(source.bytes), limits);
    decoder.set_ignore_text_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(failed)?;
    let (width, height) = (header.width as usize, header.height as usize);
    source.check_size(width, height, PIXELS_PER_BYTE)?;
    let mut reader = decoder.read_info().map_err(failed)?;
    let size = buffer_size(&reader, source)?;
    source.check_memory(width, height, (size / (width * height).max(1)) as u64)?;
    let mut samples = vec![0; size];
    let info = reader.next_frame(&mut samples).map_err(failed)?;
    samples.truncate(info.buffer_size());
    let wide = info.bit_depth == BitDepth::Sixteen;
    let channels = info.color_type.samples();
    if samples.len() != width * height * channels * if wide { 2 } else { 1 } {
        return Err(source.content("a first frame of the whole picture", "a smaller one"));
    }
    let light = Light::new(wide);
    let pixel = |i: usize| light.of_pixel(&samples, info.color_type, i * channels);
    let rgb = three_planes(width, height, pixel);
    let notes = notes(reader.info());
    Ok(Picture { width, height, rgb, scale: Scale::Codes, notes })
}

fn buffer_size(reader: &Reader<Cursor<&[u8]>>, source: &Source) -> Result<usize, ReadError> {
    let size = reader.output_buffer_size();
    size.filter(|size| *size <= MAX_PIXELS * 8).ok_or_else(|| {
        source.content("a picture of at most 8 bytes per pixel", format_args!("{size:?} bytes"))
    })
}

/// The light of every code.
struct Light {
    wide: bool,
    of_code: Vec<f32>,
}

impl Light {
    fn new(wide: bool) -> Self {
        let most = if wide { u32::from(u16::MAX) } else { u32::from(u8::MAX) };
        let of_code = (0..=most).map(|code| srgb_decode((f64::from(code) / f64::from(most)) as f32));
        Self { wide, of_code: of_code.collect() }
    }

    /// Sample number `i` as a code.
    fn code(&self, samples: &[u8], i: usize) -> usize {
        match self.wide {
            true => usize::from(u16::from_be_bytes([samples[2 * i], samples[2 * i + 1]])),
            false => usize::from(samples[i]),
        }
    }

    /// The pixel whose samples begin at number `first`, laid over black.
    fn of_pixel(&self, samples: &[u8], color: ColorType, first: usize) -> [f32; 3] {
        let rgb = match color {
            ColorType::Grayscale | ColorType::GrayscaleAlpha => [0; 3],
            ColorType::Rgb | ColorType::Rgba | ColorType::Indexed => [0, 1, 2],
        };
        let light = rgb.map(|channel| self.of_code[self.code(samples, first + channel)]);
        let alpha = match color {
            ColorType::GrayscaleAlpha => 1,
            ColorType::Rgba => 3,
            _ => return light,
        };
        let alpha = self.code(samples, first + alpha) as f32 / (self.of_code.len() - 1) as f32;
        light.map(|light| light * alpha)
    }
}

/// What the file says about its colours that is not heeded.
fn notes(info: &Info) -> Vec<String> {
    let mut notes = Vec::new();
    if info
        .coding_independent_code_points
        .is_some_and(|code| (code.color_primaries, code.transfer_function) != (1, 13))
    {
        notes.push("the file says that its codes are not sRGB (cICP); they are taken as sRGB".to_owned());
    } else if info.icc_profile.is_some() {
        notes
            .push("the file has a colour profile, which is not read; its codes are taken as sRGB".to_owned());
    } else if info.srgb.is_none() && info.gama_chunk.is_some_and(|gamma| gamma.into_scaled() != SRGB_GAMMA) {
        notes.push("the file gives its codes a gamma of its own; they are taken as sRGB".to_owned());
    }
    notes
}
