//! Pictures in memory: read, write, compare, put side by side.

use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;

use crate::{Failure, Result};

/// Rows of 8-bit RGBA from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// `4·width·height` bytes.
    pub rgba: Vec<u8>,
}

/// Where two pictures differ.
#[derive(Debug, PartialEq)]
pub(crate) struct Difference {
    /// How many pixels.
    pub pixels: usize,
    /// By how much at most, in codes.
    pub largest: u8,
    /// The first of them: column and row.
    pub first: (usize, usize),
}

impl Picture {
    /// All pixels of one colour.
    pub(crate) fn plain(width: usize, height: usize, color: [u8; 4]) -> Self {
        Self { width, height, rgba: color.repeat(width * height) }
    }

    /// From a PNG file, whatever its colour type; 16-bit samples lose their lower half.
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let file = File::open(path).map_err(Failure::during(path.display()))?;
        let mut decoder = png::Decoder::new(BufReader::new(file));
        decoder
            .set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
        let mut reader = decoder.read_info().map_err(Failure::during(path.display()))?;
        let size = reader
            .output_buffer_size()
            .ok_or_else(|| Failure::new(format!("{}: the picture is too large", path.display())))?;
        let mut bytes = vec![0; size];
        let info = reader.next_frame(&mut bytes).map_err(Failure::during(path.display()))?;
        bytes.truncate(info.buffer_size());
        let rgba = match info.color_type {
            png::ColorType::GrayscaleAlpha => {
                bytes.chunks_exact(2).flat_map(|p| [p[0], p[0], p[0], p[1]]).collect()
            }
            _ => bytes,
        };
        Ok(Self { width: info.width as usize, height: info.height as usize, rgba })
    }

    /// Into a PNG file; without an alpha channel where all is opaque.
    pub(crate) fn write(&self, path: &Path) -> Result<()> {
        let failed = || Failure::during::<png::EncodingError>(path.display());
        let file = File::create(path).map_err(Failure::during(path.display()))?;
        let mut encoder = png::Encoder::new(BufWriter::new(file), self.width as u32, self.height as u32);
        let opaque = self.rgba.chunks_exact(4).all(|p| p[3] == 255);
        encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header().map_err(failed())?;
        let channels = if opaque { 3 } else { 4 };
        let bytes: Vec<u8> = self.rgba.chunks_exact(4).flat_map(|p| &p[..channels]).copied().collect();
        writer.write_image_data(&bytes).map_err(failed())?;
        writer.finish().map_err(failed())
    }

    /// Whether every pixel has the same colour: nothing was drawn.
    pub(crate) fn is_uniform(&self) -> bool {
        self.rgba.chunks_exact(4).all(|pixel| pixel == &self.rgba[..4])
    }

    /// Where `other` differs; a different size is an error.
    pub(crate) fn difference(&self, other: &Self) -> Result<Option<Difference>> {
        if (self.width, self.height) != (other.width, other.height) {
            return Err(Failure::new(format!(
                "{}×{} pixels, but {}×{} were expected",
                other.width, other.height, self.width, self.height
            )));
        }
        let mut found: Option<Difference> = None;
        for (i, (a, b)) in self.rgba.chunks_exact(4).zip(other.rgba.chunks_exact(4)).enumerate() {
            let most = a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
            if most > 0 {
                let first = (i % self.width, i / self.width);
                let all = found.get_or_insert(Difference { pixels: 0, largest: 0, first });
                all.pixels += 1;
                all.largest = all.largest.max(most);
            }
        }
        Ok(found)
    }

    /// The difference of each channel times `factor`, opaque; pictures of the same size.
    pub(crate) fn amplified_difference(&self, other: &Self, factor: u8) -> Self {
        let mut result = Self::plain(self.width, self.height, [0, 0, 0, 255]);
        let pairs = self.rgba.chunks_exact(4).zip(other.rgba.chunks_exact(4));
        for (to, (a, b)) in result.rgba.chunks_exact_mut(4).zip(pairs) {
            let alpha = a[3].abs_diff(b[3]);
            for channel in 0..3 {
                to[channel] = a[channel].abs_diff(b[channel]).max(alpha).saturating_mul(factor);
            }
        }
        result
    }

    /// Copies `from` so that its top left corner is at (x, y).
    fn paste(&mut self, from: &Self, x: usize, y: usize) {
        for row in 0..from.height {
            let source = &from.rgba[4 * row * from.width..][..4 * from.width];
            let start = 4 * ((y + row) * self.width + x);
            self.rgba[start..start + source.len()].copy_from_slice(source);
        }
    }

    /// Rows of pictures on grey, with a margin around each.
    pub(crate) fn sheet(rows: &[Vec<Self>]) -> Self {
        const MARGIN: usize = 4;
        let across = |row: &Vec<Self>| row.iter().map(|picture| picture.width + MARGIN).sum::<usize>();
        let down = |row: &Vec<Self>| row.iter().map(|picture| picture.height).max().unwrap_or(0) + MARGIN;
        let width = rows.iter().map(across).max().unwrap_or(0) + MARGIN;
        let height = rows.iter().map(down).sum::<usize>() + MARGIN;
        let mut sheet = Self::plain(width, height, [96, 96, 96, 255]);
        let mut y = MARGIN;
        for row in rows {
            let mut x = MARGIN;
            for picture in row {
                sheet.paste(picture, x, y);
                x += picture.width + MARGIN;
            }
            y += down(row);
        }
        sheet
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spotted() -> Picture {
        let mut picture = Picture::plain(3, 2, [10, 20, 30, 255]);
        picture.rgba[4 * 4 + 1] = 25;
        picture
    }

    #[test]
    fn a_difference_is_found_and_located() {
        let plain = Picture::plain(3, 2, [10, 20, 30, 255]);
        assert_eq!(plain.difference(&plain).expect("same size"), None);
        let found = plain.difference(&spotted()).expect("same size");
        assert_eq!(found, Some(Difference { pixels: 1, largest: 5, first: (1, 1) }));
        assert!(plain.difference(&Picture::plain(2, 3, [0; 4])).is_err());
    }

    #[test]
    fn the_amplified_difference_is_dark_where_nothing_changed() {
        let difference = Picture::plain(3, 2, [10, 20, 30, 255]).amplified_difference(&spotted(), 8);
        assert_eq!(&difference.rgba[16..20], &[0, 40, 0, 255]);
        assert_eq!(&difference.rgba[..4], &[0, 0, 0, 255]);
    }

    #[test]
    fn files_give_back_what_was_written() {
        let folder = std::env::temp_dir().join(format!("glanz-xtask-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("the temporary folder is writable");
        let path = folder.join("spotted.png");
        for alpha in [255, 7] {
            let mut picture = spotted();
            picture.rgba[3] = alpha;
            picture.write(&path).expect("written");
            assert_eq!(Picture::read(&path).expect("read"), picture);
        }
        std::fs::remove_dir_all(&folder).expect("removed");
    }

    #[test]
    fn a_picture_of_one_colour_is_uniform() {
        assert!(Picture::plain(3, 2, [1, 2, 3, 4]).is_uniform());
        assert!(!spotted().is_uniform());
    }

    #[test]
    fn a_sheet_holds_all_pictures() {
        let sheet = Picture::sheet(&[vec![spotted(), spotted()], vec![spotted()]]);
        assert_eq!((sheet.width, sheet.height), (2 * (3 + 4) + 4, 2 * (2 + 4) + 4));
        let spots = sheet.rgba.chunks_exact(4).filter(|p| *p == [10, 25, 30, 255]).count();
        assert_eq!(spots, 3);
    }
}
