//! OpenEXR: linear light, premultiplied, which is light over black.

use std::collections::HashSet;
use std::io::Cursor;

use ::exr::block::UncompressedBlock;
use ::exr::block::reader::{ChunksReader, Reader};
use ::exr::compression::Compression;
use ::exr::error::Error as ExrError;
use ::exr::meta::attribute::{Chromaticities, SampleType};
use ::exr::meta::header::Header;
use ::exr::prelude::{Vec2, f16};
use glanz_color::models::{RgbSpace, Transfer};

use super::super::rows::three_planes;
use super::super::{Picture, ReadError, Scale};
use super::Source;

/// The most pixels that one byte of a file can stand for: deflate packs 1032 bytes into one, after which
/// PXR24 makes four bytes of three; a pixel has three samples of at least two bytes.
const PIXELS_PER_BYTE: usize = 1032 * 4 / 3 / 6 + 1;
/// Chromaticities that differ by less than this are the same: files round theirs to four digits.
const SAME_CHROMATICITY: f64 = 1e-3;

pub fn decode(source: &Source) -> Result<Picture, ReadError> {
    let failed = |error: ExrError| match error {
        // A file in memory fails only by ending.
        ExrError::Io(_) => source.content("a complete OpenEXR file", "its end in the middle"),
        other => source.content("an OpenEXR picture of scan lines or tiles", other),
    };
    let reader = Reader::read_from_buffered(Cursor::new(source.bytes), false).map_err(failed)?;
    let choice = Choice::of(reader.headers(), source)?;
    reader.headers().iter().try_for_each(|part| check_part(part, source))?;
    let header = reader.headers()[choice.part].clone();
    let Vec2(width, height) = header.layer_size;
    source.check_size(width, height, PIXELS_PER_BYTE)?;
    let wanted = reader
        .filter_chunks(false, |_, _, block| block.layer == choice.part && block.level == Vec2(0, 0))
        .map_err(failed)?;
    let mut planes = Planes::new(width, height);
    for block in wanted.sequential_decompressor(false) {
        planes.take(&block.map_err(failed)?, &header, &choice, source)?;
    }
    let mut picture = planes.whole(source)?;
    picture.notes = choice.notes(&header);
    to_srgb(&mut picture, header.shared_attributes.chromaticities, source)?;
    Ok(picture)
}

/// That a part can be decoded safely; in a damaged file any part may be met.
fn check_part(part: &Header, source: &Source) -> Result<(), ReadError> {
    if matches!(part.compression, Compression::B44 | Compression::B44A) {
        // The decoder's whole numbers overflow on damaged blocks of this kind.
        return Err(source.content("a compression without B44", part.compression));
    }
    // One sample is a third of a colour.
    source.check_size(part.layer_size.0, part.layer_size.1, 3 * PIXELS_PER_BYTE)
}

/// The part of the file and the channels that are read.
struct Choice {
    part: usize,
    channels: [usize; 3],
    /// The layer's name with its dot; empty for none.
    prefix: String,
}

impl Choice {
    /// Plain R, G, B of the first part that has them, else those of the first layer that has them.
    fn of(headers: &[Header], source: &Source) -> Result<Self, ReadError> {
        let plain = headers.iter().enumerate().find_map(|(part, header)| Self::with(part, header, ""));
        let choice = plain.or_else(|| {
            headers.iter().enumerate().find_map(|(part, header)| {
                let names = header.channels.list.iter().map(|channel| channel.name.to_string());
                names.into_iter().find_map(|name| Self::with(part, header, name.strip_suffix('R')?))
            })
        });
        let Some(choice) = choice else {
            return Err(source.content("channels R, G and B", found_channels(headers)));
        };
        let header = &headers[choice.part];
        if header.deep {
            return Err(source.content("a flat picture", "deep data"));
        }
        if header.channels.list.iter().any(|channel| channel.sampling != Vec2(1, 1)) {
            return Err(source.content("a sample of every channel in every pixel", "subsampled channels"));
        }
        for channel in choice.channels.map(|i| &header.channels.list[i]) {
            if channel.sample_type == SampleType::U32 {
                let found = format!("whole numbers in channel {}", channel.name);
                return Err(source.content("half or float samples", found));
            }
        }
        Ok(choice)
    }

    fn with(part: usize, header: &Header, prefix: &str) -> Option<Self> {
        if !prefix.is_empty() && !prefix.ends_with('.') {
            return None;
        }
        let place = |channel: &str| {
            let name = format!("{prefix}{channel}");
            header.channels.list.iter().position(|channel| channel.name.to_string() == name)
        };
        let channels = [place("R")?, place("G")?, place("B")?];
        Some(Self { part, channels, prefix: prefix.to_owned() })
    }

    fn notes(&self, header: &Header) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.prefix.is_empty() {
            notes.push(format!("the layer '{}' is compared", self.prefix.trim_end_matches('.')));
        } else if self.part > 0 {
            let name = header.own_attributes.layer_name.as_ref().map(ToString::to_string);
            notes.push(format!("part {} ({}) is compared", self.part, name.unwrap_or_default()));
        }
        let window = header.shared_attributes.display_window;
        if window.position != header.own_attributes.layer_position || window.size != header.layer_size {
            notes.push("the data window is compared, which is not the display window".to_owned());
        }
        notes
    }
}

/// The names of all channels, as many as a message can bear.
fn found_channels(headers: &[Header]) -> String {
    const MOST: usize = 12;
    let channels = headers.iter().flat_map(|header| &header.channels.list);
    let names: Vec<_> = channels.clone().take(MOST).map(|channel| channel.name.to_string()).collect();
    let more = if channels.count() > MOST { ", …" } else { "" };
    format!("{}{more}", names.join(", "))
}

/// A picture as its blocks arrive.
struct Planes {
    width: usize,
    height: usize,
    rgb: [Vec<f32>; 3],
    taken: HashSet<(usize, usize)>,
    pixels: usize,
}

impl Planes {
    fn new(width: usize, height: usize) -> Self {
        let rgb = [(); 3].map(|()| vec![0.0; width * height]);
        Self { width, height, rgb, taken: HashSet::new(), pixels: 0 }
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
            return Err(source.content("blocks within the picture", "one that lies elsewhere"));
        }
        if !self.taken.insert((x, y)) {
            return Err(source.content("every block once", format_args!("two at pixel {x}, {y}")));
        }
        self.pixels += columns * rows;
        for line in block.lines(&header.channels) {
            let Some(plane) = choice.channels.iter().position(|i| *i == line.location.channel) else {
                continue;
            };
            let Vec2(x, y) = line.location.position;
            let out = &mut self.rgb[plane][y * self.width + x..][..columns];
            let half = header.channels.list[line.location.channel].sample_type == SampleType::F16;
            copy_samples(line.value, half, out);
        }
        Ok(())
    }

    /// The picture, if every pixel is there.
    fn whole(self, source: &Source) -> Result<Picture, ReadError> {
        let Self { width, height, rgb, pixels, .. } = self;
        if pixels != width * height {
            let found = format!("{pixels} of {width}×{height}");
            return Err(source.content("blocks for every pixel", found));
        }
        Ok(Picture { width, height, rgb, scale: Scale::Light, notes: Vec::new() })
    }
}

/// Samples of a decompressed line, whose bytes have the order of this machine.
fn copy_samples(bytes: &[u8], half: bool, out: &mut [f32]) {
    if half {
        for (out, bytes) in out.iter_mut().zip(bytes.as_chunks().0) {
            *out = f16::from_ne_bytes(*bytes).to_f32();
        }
    } else {
        for (out, bytes) in out.iter_mut().zip(bytes.as_chunks().0) {
            *out = f32::from_ne_bytes(*bytes);
        }
    }
}

/// Brings a picture of other primaries to those of sRGB; its white becomes D65.
fn to_srgb(
    picture: &mut Picture,
    chromaticities: Option<Chromaticities>,
    source: &Source,
) -> Result<(), ReadError> {
    let Some(own) = chromaticities else {
        return Ok(());
    };
    let pair = |Vec2(x, y): Vec2<f32>| [f64::from(x), f64::from(y)];
    let (primaries, white) = ([own.red, own.green, own.blue].map(pair), pair(own.white));
    let srgb = RgbSpace::LINEAR_SRGB;
    let found = primaries.iter().chain([&white]).flatten();
    let known = srgb.primaries.iter().chain([&srgb.white]).flatten();
    if found.zip(known).all(|(found, known)| (found - known).abs() < SAME_CHROMATICITY) {
        return Ok(());
    }
    let matrix =
        srgb.from_xyz_matrix().times(RgbSpace::new(primaries, white, Transfer::Linear).to_xyz_matrix());
    if !matrix.0.iter().flatten().all(|value| value.is_finite()) {
        let found = format!(
            "red {:?}, green {:?}, blue {:?}, white {white:?}",
            primaries[0], primaries[1], primaries[2]
        );
        return Err(source.content("chromaticities of three primaries and a white", found));
    }
    let light = |i: usize| picture.rgb.each_ref().map(|plane| f64::from(plane[i]));
    let rgb =
        three_planes(picture.width, picture.height, |i| matrix.apply(light(i)).map(|value| value as f32));
    picture.rgb = rgb;
    picture.notes.push("the file's primaries are not those of sRGB; its colours are converted".to_owned());
    Ok(())
}
