//! A picture of 8-bit codes that other pictures and texts are put on.

use glanz_picture::output::PictureData;
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

/// A picture of straight RGBA codes.
///
/// ```
/// use glanz_plot::Canvas;
/// use glanz_picture::output::{Format, Metadata, PictureData};
///
/// let mut sheet = Canvas::new(4, 2, [0, 0, 0]);
/// sheet.put(2, 0, &Canvas::new(2, 2, [255, 255, 255]));
/// assert_eq!(sheet.rgba[..12], [0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255]);
/// let file = PictureData::from(sheet).to_bytes(Format::Png, &Metadata::default())?;
/// # Ok::<(), glanz_picture::output::OutputError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// `4·width·height` bytes, rows from the top.
    pub rgba: Vec<u8>,
}

impl From<Canvas> for PictureData {
    fn from(Canvas { width, height, rgba }: Canvas) -> Self {
        Self::Codes8 { width, height, rgba }
    }
}

/// The size of letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lettering(RasterHeight);

impl Lettering {
    /// For labels of small pictures.
    pub const SMALL: Self = Self(RasterHeight::Size16);
    /// For labels of greater ones.
    pub const LARGE: Self = Self(RasterHeight::Size20);

    /// The height of a line.
    pub fn height(self) -> usize {
        self.0.val()
    }

    /// The width of `text`: all letters are equally wide.
    pub fn width(self, text: &str) -> usize {
        text.chars().count() * get_raster_width(FontWeight::Regular, self.0)
    }

    /// `text`, with its middle left out if it is wider than `width`.
    pub fn fit(self, text: &str, width: usize) -> String {
        let letters = width / get_raster_width(FontWeight::Regular, self.0);
        let count = text.chars().count();
        if count <= letters {
            return text.to_owned();
        }
        let kept = letters.saturating_sub(2);
        let (head, tail) = (kept - kept / 2, kept / 2);
        let start: String = text.chars().take(head).collect();
        let end: String = text.chars().skip(count - tail).collect();
        if letters < 2 { start } else { format!("{start}..{end}") }
    }
}

impl Lettering {
    /// `text` in lines that are no wider than `width`, broken after blanks and commas; a piece that is wider by itself
    /// has its middle left out.
    pub fn lines(self, text: &str, width: usize) -> Vec<String> {
        let mut lines = vec![String::new()];
        for piece in text.split_inclusive([' ', ',']) {
            let line = lines.last_mut().expect("begins with one line");
            if self.width(format!("{line}{piece}").trim_end()) <= width || line.is_empty() {
                line.push_str(piece);
            } else {
                lines.push(piece.to_owned());
            }
        }
        lines.iter().map(|line| self.fit(line.trim_end(), width)).collect()
    }
}

impl Canvas {
    /// A canvas of one colour.
    pub fn new(width: usize, height: usize, color: [u8; 3]) -> Self {
        let [r, g, b] = color;
        Self { width, height, rgba: [r, g, b, 255].repeat(width * height) }
    }

    /// Puts a picture with its upper left corner at (x, y). What does not fit is left out.
    pub fn put(&mut self, x: usize, y: usize, picture: &Self) {
        let columns = picture.width.min(self.width.saturating_sub(x));
        for row in 0..picture.height.min(self.height.saturating_sub(y)) {
            let from = 4 * row * picture.width;
            let to = 4 * ((y + row) * self.width + x);
            self.rgba[to..to + 4 * columns].copy_from_slice(&picture.rgba[from..from + 4 * columns]);
        }
    }

    /// Writes one line of text with its upper left corner at (x, y). Letters that the font does not
    /// have become question marks.
    pub fn write(&mut self, x: usize, y: usize, text: &str, lettering: Lettering, color: [u8; 3]) {
        let mut left = x;
        for letter in text.chars() {
            let raster = get_raster(letter, FontWeight::Regular, lettering.0)
                .or_else(|| get_raster('?', FontWeight::Regular, lettering.0))
                .expect("the font has a question mark");
            for (row, pixels) in raster.rows().enumerate() {
                for (column, &strength) in pixels.iter().enumerate() {
                    self.blend(left + column, y + row, color, strength);
                }
            }
            left += raster.width();
        }
    }

    fn blend(&mut self, x: usize, y: usize, color: [u8; 3], strength: u8) {
        if strength == 0 || x >= self.width || y >= self.height {
            return;
        }
        let at = 4 * (y * self.width + x);
        let strength = u32::from(strength);
        for (own, ink) in self.rgba[at..at + 3].iter_mut().zip(color) {
            *own = ((u32::from(*own) * (255 - strength) + u32::from(ink) * strength + 127) / 255) as u8;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_over_the_edge_is_cut() {
        let mut canvas = Canvas::new(3, 3, [0; 3]);
        canvas.put(2, 1, &Canvas::new(5, 5, [9; 3]));
        canvas.put(7, 7, &Canvas::new(1, 1, [9; 3]));
        let reds: Vec<_> = canvas.rgba.chunks(4).map(|pixel| pixel[0]).collect();
        assert_eq!(reds, [0, 0, 0, 0, 0, 9, 0, 0, 9]);
    }

    #[test]
    fn texts_leave_ink_within_their_width() {
        let mut canvas = Canvas::new(100, 20, [0; 3]);
        canvas.write(10, 2, "Hé 7", Lettering::SMALL, [255; 3]);
        let right = 10 + Lettering::SMALL.width("Hé 7");
        let inked = |x: usize| (0..20).any(|y| canvas.rgba[4 * (y * 100 + x)] > 0);
        assert!((10..right).any(inked));
        assert!(!(0..10).any(inked) && !(right..100).any(inked));
    }

    #[test]
    fn a_long_text_is_broken_after_commas_and_blanks() {
        let letter = Lettering::SMALL.width("x");
        let lines = |text: &str, letters: usize| Lettering::SMALL.lines(text, letters * letter);
        assert_eq!(
            lines("fade = {constant=1,quadratic=0.1}", 16),
            ["fade =", "{constant=1,", "quadratic=0.1}"]
        );
        assert_eq!(lines("a = 1", 16), ["a = 1"]);
        assert_eq!(lines("materials_of_the_ball", 9), ["mate..all"]);
    }

    #[test]
    fn a_long_text_loses_its_middle() {
        let letter = Lettering::SMALL.width("x");
        assert_eq!(Lettering::SMALL.fit("shininess", 9 * letter), "shininess");
        assert_eq!(Lettering::SMALL.fit("shininess", 8 * letter), "shi..ess");
        assert_eq!(Lettering::SMALL.fit("shininess", letter), "");
    }
}
