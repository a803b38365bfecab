//! Contact sheets: pictures in rows and columns, with titles and captions.

use super::canvas::{Canvas, Lettering};
use crate::Error;

/// Between pictures, and around them.
pub(super) const GAP: usize = 6;
/// The sheet itself, in sRGB codes.
pub(super) const PAPER: [u8; 3] = [30, 30, 34];
/// Texts, in sRGB codes.
pub(super) const INK: [u8; 3] = [232, 232, 228];
/// The widest and highest sheet, in pixels.
const MAX_SIDE: usize = 16_384;
/// Pictures from this width on carry large letters.
const LARGE_FROM: usize = 320;

/// The layout of a contact sheet and its texts.
///
/// ```
/// use glanz_plot::{Canvas, ContactSheet};
///
/// let captions = vec![vec!["first".to_owned()], vec!["second".to_owned()]];
/// let layout = ContactSheet { captions, per_row: 2, count: 2, cell: (64, 48), ..ContactSheet::default() };
/// let mut sheet = layout.begin()?;
/// layout.put(&mut sheet, 1, &Canvas::new(64, 48, [200, 30, 30]));
/// assert!(sheet.width >= 128);
/// # Ok::<(), glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactSheet {
    /// Over everything; may be empty.
    pub title: String,
    /// Over each column; empty for none.
    pub columns: Vec<String>,
    /// To the left of each row; empty for none.
    pub rows: Vec<String>,
    /// Under each picture; empty for none.
    pub captions: Vec<Vec<String>>,
    /// Pictures in a row.
    pub per_row: usize,
    /// Number of pictures.
    pub count: usize,
    /// Width and height of each picture.
    pub cell: (usize, usize),
}

/// Where things are on a sheet, in pixels.
struct Layout {
    lettering: Lettering,
    left: usize,
    top: usize,
    caption: usize,
    width: usize,
    height: usize,
}

impl ContactSheet {
    /// An empty sheet, ready for its pictures.
    ///
    /// # Errors
    /// [`Error::SheetSize`] if it were larger than a picture can be.
    pub fn begin(&self) -> Result<Canvas, Error> {
        let layout = self.layout();
        if layout.width > MAX_SIDE || layout.height > MAX_SIDE {
            return Err(Error::SheetSize {
                columns: self.per_row,
                rows: self.row_count(),
                width: layout.width,
                height: layout.height,
                most: MAX_SIDE,
            });
        }
        let mut canvas = Canvas::new(layout.width, layout.height, PAPER);
        let lettering = layout.lettering;
        if !self.title.is_empty() {
            let title = lettering.fit(&self.title, layout.width - 2 * GAP);
            canvas.write(GAP, GAP, &title, lettering, INK);
        }
        for (column, label) in self.columns.iter().enumerate() {
            let (x, y) = self.corner(&layout, 0, column);
            let lines = lettering.lines(label, self.cell.0);
            let top = y - GAP / 2 - lettering.height() * lines.len();
            centered(&mut canvas, (x, top), self.cell.0, &lines, lettering);
        }
        for (row, label) in self.rows.iter().enumerate() {
            let (_, y) = self.corner(&layout, row, 0);
            let y = y + (self.cell.1.saturating_sub(lettering.height() * lines(label))) / 2;
            for (line, text) in label.split('\n').enumerate() {
                canvas.write(GAP, y + line * lettering.height(), text, lettering, INK);
            }
        }
        Ok(canvas)
    }

    /// Puts picture number `index` and its caption in place.
    pub fn put(&self, canvas: &mut Canvas, index: usize, picture: &Canvas) {
        let layout = self.layout();
        let (x, y) = self.corner(&layout, index / self.per_row, index % self.per_row);
        canvas.put(x, y, picture);
        let caption = self.captions.get(index).map(Vec::as_slice).unwrap_or_default();
        let lines = self.caption_lines(caption, layout.lettering);
        let top = y + self.cell.1 + GAP / 2;
        centered(canvas, (x, top), self.cell.0, &lines, layout.lettering);
    }

    /// A caption in lines that fit below its picture.
    fn caption_lines(&self, caption: &[String], lettering: Lettering) -> Vec<String> {
        caption.iter().flat_map(|text| lettering.lines(text, self.cell.0)).collect()
    }

    fn row_count(&self) -> usize {
        self.count.div_ceil(self.per_row.max(1))
    }

    fn layout(&self) -> Layout {
        let lettering = if self.cell.0 >= LARGE_FROM { Lettering::LARGE } else { Lettering::SMALL };
        let line = lettering.height() + GAP / 2;
        let row_label =
            self.rows.iter().flat_map(|label| label.split('\n')).map(|text| lettering.width(text));
        let left = GAP + row_label.max().map_or(0, |width| width + GAP);
        let title = if self.title.is_empty() { 0 } else { line + GAP };
        let over = self.columns.iter().map(|label| lettering.lines(label, self.cell.0).len()).max();
        let over = over.map_or(0, |lines| lines * lettering.height() + GAP / 2);
        let top = GAP + title + over;
        let caption_lines = self.captions.iter().map(|caption| self.caption_lines(caption, lettering).len());
        let caption_lines = caption_lines.max().unwrap_or(0);
        let caption = if caption_lines == 0 { 0 } else { caption_lines * lettering.height() + GAP / 2 };
        let width = left + self.per_row * (self.cell.0 + GAP);
        let height = top + self.row_count() * (self.cell.1 + caption + GAP);
        Layout { lettering, left, top, caption, width, height }
    }

    /// The upper left corner of a picture.
    fn corner(&self, layout: &Layout, row: usize, column: usize) -> (usize, usize) {
        let x = layout.left + column * (self.cell.0 + GAP);
        let y = layout.top + row * (self.cell.1 + layout.caption + GAP);
        (x, y)
    }
}

fn lines(text: &str) -> usize {
    text.split('\n').count()
}

/// Writes lines in the middle of `width` pixels from (x, y) on.
fn centered(
    canvas: &mut Canvas,
    (x, y): (usize, usize),
    width: usize,
    lines: &[String],
    lettering: Lettering,
) {
    for (index, text) in lines.iter().enumerate() {
        let indent = width.saturating_sub(lettering.width(text)) / 2;
        canvas.write(x + indent, y + index * lettering.height(), text, lettering, INK);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(count: usize, per_row: usize) -> ContactSheet {
        ContactSheet { count, per_row, cell: (40, 30), ..ContactSheet::default() }
    }

    #[test]
    fn pictures_lie_in_rows_without_touching() {
        let sheet = sheet(5, 3);
        let mut canvas = sheet.begin().unwrap();
        for index in 0..5 {
            sheet.put(&mut canvas, index, &Canvas::new(40, 30, [index as u8 + 100; 3]));
        }
        let count = |code: u8| canvas.rgba.chunks(4).filter(|pixel| pixel[0] == code).count();
        assert!((0..5).all(|index| count(index + 100) == 40 * 30));
        assert_eq!((canvas.width, canvas.height), (6 + 3 * 46, 6 + 2 * 36));
    }

    #[test]
    fn texts_widen_the_sheet() {
        let plain = sheet(4, 2).begin().unwrap();
        let words = ContactSheet {
            title: "t".to_owned(),
            columns: vec!["a".to_owned(), "b".to_owned()],
            rows: vec!["first".to_owned(), "second".to_owned()],
            ..sheet(4, 2)
        };
        let words = words.begin().unwrap();
        assert!(words.width > plain.width && words.height > plain.height);
    }

    #[test]
    fn a_sheet_too_large_for_a_picture_is_refused() {
        assert!(sheet(1_000_000, 2).begin().is_err());
    }
}
