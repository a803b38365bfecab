//! Radiance pictures (G. Ward, "Real Pixels", Graphics Gems II, 1991; the program's manual, File Formats).
//!
//! A header of text lines, an empty one, the size, then lines of pixels: three mantissas and a common
//! exponent, m · 2^(e − 136), plain or run-length encoded in the old or the new way. An own reader, since
//! that of `image` knows one orientation, takes memory by the size in the header, and overflows in damaged runs.

use glanz_color::models::{RgbSpace, Transfer};
use glanz_color::read::{Place, ReadError, excerpt};

use super::source::{Source, conversion};
use crate::EnvironmentMap;

/// The most bytes of a header: more is no header.
const MOST_HEADER: usize = 1 << 16;
/// The widths that the new encoding is for.
const NEW_WIDTHS: std::ops::RangeInclusive<usize> = 8..=0x7fff;

/// The primaries of CIE XYZ with the white E, which the format takes.
const XYZ: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [1.0 / 3.0, 1.0 / 3.0]];

/// Mantissas and exponent.
type Rgbe = [u8; 4];

/// Reads a file.
pub(super) fn read(source: &mut Source) -> Result<EnvironmentMap, ReadError> {
    let mut bytes = Bytes { bytes: source.bytes, at: 0 };
    let header = Header::read(&mut bytes, source)?;
    let size = Size::read(&mut bytes, source)?;
    let (width, height) = size.width_height();
    source.check_size(width, height)?;
    // Grows with what the file holds, not with what it claims.
    let mut pixels = Vec::new();
    let mut line = Vec::new();
    let is_flat = bytes.are_pixels(size.lines.count, size.pixels.count);
    for number in 0..size.lines.count {
        line.clear();
        let read = match is_flat {
            true => plain_line(&mut bytes, size.pixels.count, &mut line),
            false => scan_line(&mut bytes, size.pixels.count, &mut line),
        };
        if read.is_none() {
            let found = format!("damage or the end of the file at byte {}", bytes.at);
            let place = Place::Item("scan line", number as u64);
            return Err(source.malformed(place, format!("{} pixels", size.pixels.count), found));
        }
        pixels.extend(line.iter().map(|pixel| light(*pixel, header.factor)));
    }
    let mut pixels = size.upright(pixels);
    if header.factor != [1.0; 3] {
        source.notes.add("the exposure or colour correction that the file tells of is undone");
    }
    let primaries = match header.is_xyz {
        true => Some(XYZ),
        false => header.primaries,
    };
    if let Some([red, green, blue, white]) = primaries {
        source.convert_to_srgb(&mut pixels, &RgbSpace::new([red, green, blue], white, Transfer::Linear));
    }
    Ok(EnvironmentMap { width, height, pixels })
}

fn light([r, g, b, e]: Rgbe, factor: [f64; 3]) -> [f32; 3] {
    if e == 0 {
        return [0.0; 3];
    }
    let unit = libm::scalbn(1.0, i32::from(e) - 136);
    let [r, g, b] = [r, g, b].map(|m| f64::from(m) * unit);
    [r * factor[0], g * factor[1], b * factor[2]].map(|value| value as f32)
}

/// What the header says of the pixels.
struct Header {
    /// What gives back the light before exposure and colour correction.
    factor: [f64; 3],
    /// x, y of red, green, blue and white.
    primaries: Option<[[f64; 2]; 4]>,
    /// Whether the pixels are CIE XYZ.
    is_xyz: bool,
}

impl Header {
    fn read(bytes: &mut Bytes, source: &mut Source) -> Result<Self, ReadError> {
        let mut header = Self { factor: [1.0; 3], primaries: None, is_xyz: false };
        loop {
            let line = bytes.line().ok_or_else(|| {
                source.malformed(Place::Byte(bytes.at as u64), "a header that an empty line ends", "none")
            })?;
            if line.is_empty() {
                return Ok(header);
            }
            // Programs that make pictures of others indent the headers of those: they tell of what was.
            let counts = !line.starts_with(['#', ' ', '\t']);
            if let Some((key, value)) = line.split_once('=').filter(|_| counts) {
                header.take(key.trim(), value.trim(), source)?;
            }
        }
    }

    /// Takes a line in. One that says nothing that can be meant is as if it were absent, but for a remark.
    fn take(&mut self, key: &str, value: &str, source: &mut Source) -> Result<(), ReadError> {
        let positive = |values: &[f64]| values.iter().all(|v| (1e-30..=1e30).contains(v));
        let is_meant = match key {
            "FORMAT" if value == "32-bit_rle_rgbe" => true,
            "FORMAT" if value == "32-bit_rle_xyze" => {
                self.is_xyz = true;
                true
            }
            "FORMAT" => {
                return Err(source.unsupported("32-bit_rle_rgbe or 32-bit_rle_xyze", excerpt(value)));
            }
            // Both are cumulative.
            "EXPOSURE" => numbers::<1>(value).filter(|values| positive(values)).is_some_and(|[by]| {
                self.factor = self.factor.map(|factor| factor / by);
                true
            }),
            "COLORCORR" => numbers::<3>(value).filter(|values| positive(values)).is_some_and(|by| {
                self.factor.iter_mut().zip(by).for_each(|(factor, by)| *factor /= by);
                true
            }),
            "PRIMARIES" => numbers::<8>(value).is_some_and(|[rx, ry, gx, gy, bx, by, wx, wy]| {
                let primaries = [[rx, ry], [gx, gy], [bx, by], [wx, wy]];
                let space =
                    RgbSpace::new([primaries[0], primaries[1], primaries[2]], primaries[3], Transfer::Linear);
                let spans = conversion(&space).is_some();
                self.primaries = spans.then_some(primaries).or(self.primaries);
                spans
            }),
            _ => true,
        };
        if !is_meant {
            source.notes.add(&format!("the line {key} says nothing ({}) and is ignored", excerpt(value)));
        }
        Ok(())
    }
}

/// Exactly so many finite numbers.
fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let values: Option<Vec<f64>> = text
        .split_whitespace()
        .take(N + 1)
        .map(|word| word.parse().ok().filter(|v: &f64| v.is_finite()))
        .collect();
    values?.try_into().ok()
}

/// One axis of the picture, in the order of the file.
#[derive(Clone, Copy)]
struct Axis {
    horizontal: bool,
    /// Whether it goes to the left or up.
    reversed: bool,
    count: usize,
}

/// The order of the pixels.
struct Size {
    lines: Axis,
    pixels: Axis,
}

impl Size {
    /// From a line such as `-Y 512 +X 1024`.
    fn read(bytes: &mut Bytes, source: &Source) -> Result<Self, ReadError> {
        let place = Place::Byte(bytes.at as u64);
        let line = bytes.line().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().take(5).collect();
        let axes = match words[..] {
            [a, a_count, b, b_count] => Axis::of(a, a_count).zip(Axis::of(b, b_count)),
            _ => None,
        };
        match axes.filter(|(lines, pixels)| lines.horizontal != pixels.horizontal) {
            Some((lines, pixels)) => Ok(Self { lines, pixels }),
            None => Err(source.malformed(place, "a size such as '-Y 512 +X 1024'", excerpt(line))),
        }
    }

    fn width_height(&self) -> (usize, usize) {
        match self.lines.horizontal {
            true => (self.lines.count, self.pixels.count),
            false => (self.pixels.count, self.lines.count),
        }
    }

    /// The pixels by rows from the top, from the left.
    fn upright(&self, pixels: Vec<[f32; 3]>) -> Vec<[f32; 3]> {
        let Self { lines, pixels: along } = *self;
        if !lines.horizontal && !lines.reversed && !along.reversed {
            return pixels;
        }
        let (width, height) = self.width_height();
        let place = |axis: Axis, index: usize| if axis.reversed { axis.count - 1 - index } else { index };
        let from = |row: usize, column: usize| {
            let (line, pixel) = if lines.horizontal { (column, row) } else { (row, column) };
            pixels[place(lines, line) * along.count + place(along, pixel)]
        };
        (0..height)
            .flat_map(|row| (0..width).map(move |column| (row, column)))
            .map(|(r, c)| from(r, c))
            .collect()
    }
}

impl Axis {
    fn of(name: &str, count: &str) -> Option<Self> {
        let (horizontal, reversed) = match name {
            "+X" => (true, false),
            "-X" => (true, true),
            "-Y" => (false, false),
            "+Y" => (false, true),
            _ => return None,
        };
        Some(Self { horizontal, reversed, count: count.parse().ok()? })
    }
}

/// The file and how far it is read.
struct Bytes<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let taken = self.bytes.get(self.at..)?.get(..count)?;
        self.at += count;
        Some(taken)
    }

    fn byte(&mut self) -> Option<u8> {
        self.take(1).map(|byte| byte[0])
    }

    fn pixel(&mut self) -> Option<Rgbe> {
        self.take(4).and_then(|bytes| bytes.try_into().ok())
    }

    /// Whether what is left is pixels as they are: exactly as many bytes as they take, and no mark of the new encoding.
    fn are_pixels(&self, lines: usize, width: usize) -> bool {
        let left = &self.bytes[self.at..];
        let fits = lines.checked_mul(width).and_then(|pixels| pixels.checked_mul(4)) == Some(left.len());
        fits && !left.first_chunk().is_some_and(|first| is_marked(*first, width))
    }

    /// A line of the header, without its end.
    fn line(&mut self) -> Option<String> {
        let rest = self.bytes.get(self.at..MOST_HEADER.min(self.bytes.len()))?;
        let length = rest.iter().position(|byte| *byte == b'\n')?;
        self.at += length + 1;
        Some(String::from_utf8_lossy(&rest[..length]).trim_end().to_owned())
    }
}

/// Adds the pixels of a line to an empty list. `None` where it is damaged or ends.
fn scan_line(bytes: &mut Bytes, width: usize, line: &mut Vec<Rgbe>) -> Option<()> {
    let begin = bytes.at;
    let first = bytes.pixel()?;
    if is_marked(first, width) {
        line.resize(width, [0; 4]);
        return (0..4).try_for_each(|channel| new_channel(bytes, line, channel));
    }
    bytes.at = begin;
    old_line(bytes, width, line)
}

/// Whether a line of this width begins as those of the new encoding do.
fn is_marked([r, g, b, e]: Rgbe, width: usize) -> bool {
    [r, g] == [2, 2] && usize::from(b) << 8 | usize::from(e) == width && NEW_WIDTHS.contains(&width)
}

/// Pixels as they are, whatever they look like.
fn plain_line(bytes: &mut Bytes, width: usize, line: &mut Vec<Rgbe>) -> Option<()> {
    line.extend(bytes.take(4 * width)?.as_chunks().0);
    Some(())
}

/// The new encoding: the line's bytes of one channel, as runs and as they are.
fn new_channel(bytes: &mut Bytes, line: &mut [Rgbe], channel: usize) -> Option<()> {
    let mut at = 0;
    while at < line.len() {
        let code = usize::from(bytes.byte()?);
        // Above 128 a run of code − 128; else so many bytes, none of which would never end.
        let count = if code > 128 { code - 128 } else { code };
        let part = line.get_mut(at..at + count).filter(|part| !part.is_empty())?;
        if code > 128 {
            let value = bytes.byte()?;
            part.iter_mut().for_each(|pixel| pixel[channel] = value);
        } else {
            let values = bytes.take(count)?;
            part.iter_mut().zip(values).for_each(|(pixel, value)| pixel[channel] = *value);
        }
        at += count;
    }
    Some(())
}

/// The old encoding: pixels as they are, and (1, 1, 1, n) for n more of the last; of such marks in a row
/// each counts 256 times the one before.
fn old_line(bytes: &mut Bytes, width: usize, line: &mut Vec<Rgbe>) -> Option<()> {
    let mut shift = 0;
    while line.len() < width {
        let pixel = bytes.pixel()?;
        if pixel[..3] != [1, 1, 1] {
            line.push(pixel);
            shift = 0;
            continue;
        }
        // More than three marks are longer than any line.
        let count = usize::from(pixel[3]).checked_shl(shift).filter(|_| shift <= 16)?;
        let last = *line.last()?;
        if count > width - line.len() {
            return None;
        }
        line.resize(line.len() + count, last);
        shift += 8;
    }
    Some(())
}
