//! The one reader of OpenEXR: headers, and planes of chosen channels.

use std::collections::HashSet;
use std::io::Cursor;

use ::exr::block::UncompressedBlock;
use ::exr::block::reader::{ChunksReader, Reader};
use ::exr::compression::Compression;
use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::{AttributeValue, Chromaticities, EnvironmentMap, SampleType};
use ::exr::meta::header::Header;
use ::exr::prelude::{Vec2, f16};

use super::part::{ExrChannel, ExrPart, ExrReadError};
use super::{Attribute, dwa};
use crate::models::{RgbSpace, Transfer};

/// The most bytes of samples that one byte of a file can stand for: deflate packs 1032 bytes into one,
/// after which PXR24 makes four bytes of three.
const MOST_COMPRESSION: u64 = 1032 * 4 / 3 + 1;
/// The fewest bytes of a sample.
const LEAST_SAMPLE: u64 = 2;

impl From<ExrError> for ExrReadError {
    fn from(error: ExrError) -> Self {
        match error {
            // A file in memory fails only by ending.
            ExrError::Io(_) => Self::malformed("a complete OpenEXR file", "its end in the middle"),
            other => Self::malformed("an OpenEXR picture of scan lines or tiles", other),
        }
    }
}

/// An OpenEXR file of which the headers are read, and of which channels can be.
///
/// The caller chooses a part and channels, holds the size to its limits, then asks for the planes.
#[derive(Debug)]
pub struct ExrFile<'a> {
    reader: Reader<Cursor<&'a [u8]>>,
    bytes: u64,
    parts: Vec<ExrPart>,
}

impl<'a> ExrFile<'a> {
    /// Reads the headers.
    ///
    /// # Errors
    ///
    /// [`ExrReadError`] where the bytes are no OpenEXR file.
    pub fn open(bytes: &'a [u8]) -> Result<Self, ExrReadError> {
        let reader = Reader::read_from_buffered(Cursor::new(bytes), false)?;
        let parts = reader.headers().iter().map(ExrPart::of).collect();
        Ok(Self { reader, bytes: bytes.len() as u64, parts })
    }

    /// The parts, at least one.
    pub fn parts(&self) -> &[ExrPart] {
        &self.parts
    }

    /// The names of all channels, as many as a message can bear.
    pub fn channel_names(&self) -> String {
        const MOST: usize = 12;
        let channels = self.parts.iter().flat_map(|part| &part.channels);
        let short = |channel: &ExrChannel| channel.name.chars().take(24).collect::<String>();
        let names: Vec<_> = channels.clone().take(MOST).map(short).collect();
        let more = if channels.count() > MOST { ", …" } else { "" };
        format!("{}{more}", names.join(", "))
    }

    /// The samples of some channels of a part, a plane for each: by rows from the top, of the largest
    /// resolution. The memory that is taken grows with what the file holds, not with what it claims.
    ///
    /// # Errors
    ///
    /// [`ExrReadError`] where the file is damaged, has deep data, subsampled channels or the compressions
    /// B44 or B44A.
    ///
    /// # Panics
    ///
    /// If there is no such part or channel.
    pub fn planes(self, part: usize, channels: &[usize]) -> Result<Vec<Vec<f32>>, ExrReadError> {
        let headers = self.reader.headers();
        headers.iter().try_for_each(|header| check_part(header, LEAST_SAMPLE, self.bytes))?;
        let header = headers[part].clone();
        if header.deep {
            return Err(ExrReadError::unsupported("a flat picture", "deep data"));
        }
        if header.channels.list.iter().any(|channel| channel.sampling != Vec2(1, 1)) {
            let expected = "a sample of every channel in every pixel";
            return Err(ExrReadError::unsupported(expected, "subsampled channels"));
        }
        check_part(&header, bytes_per_pixel(&header) as u64, self.bytes)?;
        let mut planes = Planes::new(part, header, channels);
        let wanted = self
            .reader
            .filter_chunks(false, |_, _, block| block.layer == part && block.level == Vec2(0, 0))?;
        let meta = wanted.meta_data().clone();
        for chunk in wanted {
            let chunk = chunk?;
            let header = meta.headers.get(chunk.layer_index);
            header.map_or(Ok(()), |header| dwa::check(&chunk, header))?;
            planes.take(&UncompressedBlock::decompress_chunk(chunk, &meta, false)?)?;
        }
        planes.complete()
    }
}

/// That a part can be decoded safely, whose pixels have so many bytes each; in a damaged file any part may
/// be met.
fn check_part(part: &Header, bytes_per_pixel: u64, bytes: u64) -> Result<(), ExrReadError> {
    if matches!(part.compression, Compression::B44 | Compression::B44A) {
        // The decoder's whole numbers overflow on damaged blocks of this kind.
        return Err(ExrReadError::unsupported("a compression without B44", part.compression));
    }
    let Vec2(width, height) = part.layer_size;
    let held = bytes.saturating_mul(MOST_COMPRESSION) / bytes_per_pixel.max(1);
    if (width as u64).saturating_mul(height as u64) > held {
        let expected = format!("at most the {held} pixels that {bytes} bytes can hold");
        return Err(ExrReadError::malformed(expected, format_args!("a claim of {width}×{height}")));
    }
    Ok(())
}

fn bytes_per_pixel(header: &Header) -> usize {
    header.channels.list.iter().map(|channel| channel.sample_type.bytes_per_sample()).sum()
}

impl ExrPart {
    fn of(header: &Header) -> Self {
        let channels = header.channels.list.iter().map(|channel| ExrChannel {
            name: channel.name.to_string(),
            is_whole_numbers: channel.sample_type == SampleType::U32,
        });
        let mut attributes: Vec<_> = header.own_attributes.other.iter().filter_map(attribute).collect();
        attributes.sort_by(|(a, _), (b, _)| a.cmp(b));
        let window = header.shared_attributes.display_window;
        let (position, size) = (header.own_attributes.layer_position, header.layer_size);
        Self {
            name: header.own_attributes.layer_name.as_ref().map(ToString::to_string),
            width: size.0,
            height: size.1,
            channels: channels.collect(),
            attributes,
            is_cube_map: header.own_attributes.environment_map == Some(EnvironmentMap::Cube),
            is_whole: window.position == position && window.size == size,
            space: header.shared_attributes.chromaticities.map(space),
        }
    }
}

fn attribute((name, value): (&::exr::meta::attribute::Text, &AttributeValue)) -> Option<(String, Attribute)> {
    let value = match value {
        AttributeValue::Text(text) => Attribute::Text(text.to_string()),
        AttributeValue::F32(number) => Attribute::Number(*number),
        _ => return None,
    };
    Some((name.to_string(), value))
}

fn space(own: Chromaticities) -> RgbSpace {
    let pair = |Vec2(x, y): Vec2<f32>| [f64::from(x), f64::from(y)];
    RgbSpace::new([own.red, own.green, own.blue].map(pair), pair(own.white), Transfer::Linear)
}

/// Planes as their blocks arrive.
struct Planes {
    part: usize,
    header: Header,
    /// The plane of each of the part's channels.
    plane_of: Vec<Option<usize>>,
    planes: Vec<Vec<f32>>,
    taken: HashSet<(usize, usize)>,
    pixels: usize,
}

impl Planes {
    fn new(part: usize, header: Header, channels: &[usize]) -> Self {
        let mut plane_of = vec![None; header.channels.list.len()];
        for (plane, &channel) in channels.iter().enumerate() {
            plane_of[channel] = Some(plane);
        }
        let Vec2(width, height) = header.layer_size;
        let planes = channels.iter().map(|_| vec![0.0; width * height]).collect();
        Self { part, header, plane_of, planes, taken: HashSet::new(), pixels: 0 }
    }

    fn take(&mut self, block: &UncompressedBlock) -> Result<(), ExrReadError> {
        let (Vec2(x, y), Vec2(columns, rows)) = (block.index.pixel_position, block.index.pixel_size);
        let Vec2(width, height) = self.header.layer_size;
        let fits = x.saturating_add(columns) <= width && y.saturating_add(rows) <= height;
        let right = block.index.layer == self.part && block.index.level == Vec2(0, 0);
        if !fits || !right || block.data.len() != columns * rows * bytes_per_pixel(&self.header) {
            return Err(ExrReadError::malformed("blocks within the picture", "one that lies elsewhere"));
        }
        if !self.taken.insert((x, y)) {
            return Err(ExrReadError::malformed("every block once", format_args!("two at pixel {x}, {y}")));
        }
        self.pixels += columns * rows;
        for line in block.lines(&self.header.channels) {
            let Some(plane) = self.plane_of[line.location.channel] else { continue };
            let Vec2(x, y) = line.location.position;
            let out = &mut self.planes[plane][y * width + x..][..columns];
            copy_samples(line.value, self.header.channels.list[line.location.channel].sample_type, out);
        }
        Ok(())
    }

    /// The planes, if every pixel is there.
    fn complete(self) -> Result<Vec<Vec<f32>>, ExrReadError> {
        let Vec2(width, height) = self.header.layer_size;
        if self.pixels == width * height {
            return Ok(self.planes);
        }
        let found = format_args!("{} of {width}×{height}", self.pixels);
        Err(ExrReadError::malformed("blocks for every pixel", found))
    }
}

/// Samples of a decompressed line, whose bytes have the order of this machine.
fn copy_samples(bytes: &[u8], kind: SampleType, out: &mut [f32]) {
    fn copy<const N: usize>(bytes: &[u8], out: &mut [f32], value: impl Fn([u8; N]) -> f32) {
        out.iter_mut().zip(bytes.as_chunks().0).for_each(|(out, bytes)| *out = value(*bytes));
    }
    match kind {
        SampleType::F16 => copy(bytes, out, |sample| f16::from_ne_bytes(sample).to_f32()),
        SampleType::F32 => copy(bytes, out, f32::from_ne_bytes),
        SampleType::U32 => copy(bytes, out, |sample| u32::from_ne_bytes(sample) as f32),
    }
}
