//! OpenEXR pictures.

use std::collections::HashSet;
use std::io::Cursor;

use ::exr::block::UncompressedBlock;
use ::exr::block::reader::{ChunksReader, Reader};
use ::exr::compression::Compression;
use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::SampleType;
use ::exr::meta::header::Header;
use ::exr::prelude::{Vec2, f16};

use super::Source;
use crate::EnvironmentMap;
use crate::read::{Place, ReadError};

/// The most pixels that one byte of a file can stand for: deflate packs 1032 bytes into one, after which
/// PXR24 makes four bytes of three; a pixel has three samples of at least two bytes.
const PIXELS_PER_BYTE: usize = 1032 * 4 / 3 / 6 + 1;

/// Reads a file.
pub fn read(source: &mut Source) -> Result<EnvironmentMap, ReadError> {
    let reader =
        Reader::read_from_buffered(Cursor::new(source.bytes), false).map_err(|e| failed(source, &e))?;
    let choice = Choice::of(reader.headers(), source)?;
    reader.headers().iter().try_for_each(|part| check_part(part, source))?;
    let header = reader.headers()[choice.part].clone();
    let Vec2(width, height) = header.layer_size;
    source.check_size(width, height)?;
    let wanted = reader
        .filter_chunks(false, |_, _, block| block.layer == choice.part && block.level == Vec2(0, 0))
        .map_err(|error| failed(source, &error))?;
    let mut picture = Pixels::new(width, height);
    for block in wanted.sequential_decompressor(false) {
        picture.take(&block.map_err(|error| failed(source, &error))?, &header, &choice, source)?;
    }
    let mut pixels = picture.whole(source)?;
    let window = header.shared_attributes.display_window;
    if window.position != header.own_attributes.layer_position || window.size != header.layer_size {
        source.notes.add("the data window is taken as the whole picture, which is not the display window");
    }
    if let Some(own) = header.shared_attributes.chromaticities {
        let pair = |Vec2(x, y): Vec2<f32>| [f64::from(x), f64::from(y)];
        source.convert_primaries(&mut pixels, [own.red, own.green, own.blue].map(pair), pair(own.white))?;
    }
    Ok(EnvironmentMap { width, height, pixels })
}

fn failed(source: &Source, error: &ExrError) -> ReadError {
    match error {
        // A file in memory fails only by ending.
        ExrError::Io(_) => source.malformed(Place::File, "a complete OpenEXR file", "its end in the middle"),
        other => source.malformed(Place::File, "an OpenEXR picture of scan lines or tiles", other),
    }
}

/// That a part can be decoded safely; in a damaged file any part may be met.
fn check_part(part: &Header, source: &Source) -> Result<(), ReadError> {
    if matches!(part.compression, Compression::B44 | Compression::B44A) {
        // The decoder's whole numbers overflow on damaged blocks of this kind.
        return Err(source.unsupported("a compression without B44", part.compression));
    }
    let Vec2(width, height) = part.layer_size;
    // One sample is a third of a colour.
    let held = source.bytes.len().saturating_mul(3 * PIXELS_PER_BYTE);
    if width.saturating_mul(height) > held {
        let expected = format!("at most the {held} pixels that {} bytes can hold", source.bytes.len());
        return Err(source.malformed(Place::File, expected, format!("a claim of {width}×{height}")));
    }
    Ok(())
}

/// The part of the file and the channels that are read.
struct Choice {
    part: usize,
    channels: [usize; 3],
}

impl Choice {
    /// R, G, B of the first part that has them.
    fn of(headers: &[Header], source: &Source) -> Result<Self, ReadError> {
        let place = |header: &Header, name: &str| {
            header.channels.list.iter().position(|channel| channel.name.eq(name))
        };
        let found = headers.iter().enumerate().find_map(|(part, header)| {
            let channels = [place(header, "R")?, place(header, "G")?, place(header, "B")?];
            Some(Self { part, channels })
        });
        let Some(choice) = found else {
            return Err(source.unsupported("channels R, G and B", found_channels(headers)));
        };
        let header = &headers[choice.part];
        if header.deep {
            return Err(source.unsupported("a flat picture", "deep data"));
        }
        if header.channels.list.iter().any(|channel| channel.sampling != Vec2(1, 1)) {
            return Err(source.unsupported("a sample of every channel in every pixel", "subsampled channels"));
        }
        let whole = |i: &usize| header.channels.list[*i].sample_type == SampleType::U32;
        if choice.channels.iter().any(whole) {
            return Err(source.unsupported("half or float samples", "whole numbers"));
        }
        Ok(choice)
    }
}

/// The names of all channels, as many as a message can bear.
fn found_channels(headers: &[Header]) -> String {
    const MOST: usize = 12;
    let channels = headers.iter().flat_map(|header| &header.channels.list);
    let name = |name: String| name.chars().take(24).collect::<String>();
    let names: Vec<_> = channels.clone().take(MOST).map(|channel| name(channel.name.to_string())).collect();
    let more = if channels.count() > MOST { ", …" } else { "" };
    format!("{}{more}", names.join(", "))
}

/// A picture as its blocks arrive.
struct Pixels {
    width: usize,
    height: usize,
    pixels: Vec<[f32; 3]>,
    taken: HashSet<(usize, usize)>,
    count: usize,
}

impl Pixels {
    fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![[0.0; 3]; width * height], taken: HashSet::new(), count: 0 }
    }

    fn take(
        &mut self,
        block: &UncompressedBlock,
        header: &Header,
        choice: &Choice,
        source: &Source,
    ) -> Result<(), ReadError> {
        let (Vec2(x, y), Vec2(columns, rows)) = (block.index.pixel_position, block.index.pixel_size);
        let fits = x.saturating_add(columns) <= self.width && y.saturating_add(rows) <= self.height;
        let right = block.index.layer == choice.part && block.index.level == Vec2(0, 0);
        let bytes_per_pixel: usize =
            header.channels.list.iter().map(|channel| channel.sample_type.bytes_per_sample()).sum();
        if !fits || !right || block.data.len() != columns * rows * bytes_per_pixel {
            return Err(source.malformed(
                Place::File,
                "blocks within the picture",
                "one that lies elsewhere",
            ));
        }
        if !self.taken.insert((x, y)) {
            let found = format!("two at pixel {x}, {y}");
            return Err(source.malformed(Place::File, "every block once", found));
        }
        self.count += columns * rows;
        for line in block.lines(&header.channels) {
            let Some(part) = choice.channels.iter().position(|i| *i == line.location.channel) else {
                continue;
            };
            let Vec2(x, y) = line.location.position;
            let out = &mut self.pixels[y * self.width + x..][..columns];
            let half = header.channels.list[line.location.channel].sample_type == SampleType::F16;
            copy_samples(line.value, half, part, out);
        }
        Ok(())
    }

    /// The picture, if every pixel is there.
    fn whole(self, source: &Source) -> Result<Vec<[f32; 3]>, ReadError> {
        if self.count != self.width * self.height {
            let found = format!("{} of {}×{}", self.count, self.width, self.height);
            return Err(source.malformed(Place::File, "blocks for every pixel", found));
        }
        Ok(self.pixels)
    }
}

/// Samples of a decompressed line, whose bytes have the order of this machine.
fn copy_samples(bytes: &[u8], half: bool, part: usize, out: &mut [[f32; 3]]) {
    if half {
        for (out, bytes) in out.iter_mut().zip(bytes.as_chunks().0) {
            out[part] = f16::from_ne_bytes(*bytes).to_f32();
        }
    } else {
        for (out, bytes) in out.iter_mut().zip(bytes.as_chunks().0) {
            out[part] = f32::from_ne_bytes(*bytes);
        }
    }
}
