//! A page as a list of shapes.

use super::style::Rgb8;
use crate::words::Lang;

/// Where a text stands to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A rectangle: left, top, width and height, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// The left edge.
    pub x: f64,
    /// The upper edge.
    pub y: f64,
    /// From left to right.
    pub width: f64,
    /// From top to bottom.
    pub height: f64,
}

impl Rect {
    /// The right edge.
    pub fn right(self) -> f64 {
        self.x + self.width
    }

    /// The lower edge.
    pub fn bottom(self) -> f64 {
        self.y + self.height
    }
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// What it says.
    pub text: String,
    /// A point of the baseline.
    pub at: (f64, f64),
    /// Where the text stands to that point.
    pub anchor: Anchor,
    /// The size of the letters: 1 em.
    pub size: f64,
    /// Their colour.
    pub color: Rgb8,
    /// Whether it runs upwards.
    pub upwards: bool,
}

/// A shape; positions and sizes are in points from the upper left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A line through points.
    Line {
        /// The points.
        points: Vec<(f64, f64)>,
        /// Its colour.
        color: Rgb8,
        /// How wide it is.
        width: f64,
    },
    /// A polygon.
    Area {
        /// Its corners.
        points: Vec<(f64, f64)>,
        /// Its colour.
        color: Rgb8,
    },
    /// A disc.
    Disc {
        /// Its centre.
        center: (f64, f64),
        /// Its radius.
        radius: f64,
        /// Its colour.
        color: Rgb8,
    },
    /// A line of text.
    Text(Text),
}

/// A raster that lies behind all shapes.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Where it lies.
    pub rect: Rect,
    /// How many columns of cells it has.
    pub columns: usize,
    /// How many rows of cells it has.
    pub rows: usize,
    /// Red, green and blue of each cell, row by row from the top.
    pub rgb: Vec<u8>,
}

/// A page on white.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The width in points.
    pub width: u32,
    /// The height in points.
    pub height: u32,
    /// Pixels of a PNG per point, each way: 2, so that plots are sharp on fine screens and in print, or 1 for a page
    /// whose size in pixels was asked for.
    pub density: u32,
    /// What lies behind the shapes.
    pub rasters: Vec<Raster>,
    /// The shapes, the lowest first.
    pub shapes: Vec<Shape>,
}

impl Page {
    /// A white page of this size in points.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, density: 2, rasters: Vec::new(), shapes: Vec::new() }
    }

    /// Adds a line.
    pub fn line(&mut self, points: impl IntoIterator<Item = (f64, f64)>, color: Rgb8, width: f64) {
        self.shapes.push(Shape::Line { points: points.into_iter().collect(), color, width });
    }

    /// Adds a line of dashes, `on` and `off` points long.
    pub fn dashes(&mut self, points: &[(f64, f64)], color: Rgb8, width: f64, (on, off): (f64, f64)) {
        let (mut left, mut drawn, mut dash) = (on, true, Vec::new());
        dash.extend(points.first().copied());
        for pair in points.windows(2) {
            let (mut from, to) = (pair[0], pair[1]);
            loop {
                let (dx, dy) = (to.0 - from.0, to.1 - from.1);
                let length = (dx * dx + dy * dy).sqrt();
                if length <= left {
                    left -= length;
                    dash.push(to);
                    break;
                }
                from = (from.0 + dx * left / length, from.1 + dy * left / length);
                dash.push(from);
                let done = core::mem::replace(&mut dash, vec![from]);
                if drawn {
                    self.line(done, color, width);
                }
                drawn = !drawn;
                left = if drawn { on } else { off };
            }
        }
        if drawn && dash.len() > 1 {
            self.line(dash, color, width);
        }
    }

    /// Adds a polygon.
    pub fn area(&mut self, points: impl IntoIterator<Item = (f64, f64)>, color: Rgb8) {
        self.shapes.push(Shape::Area { points: points.into_iter().collect(), color });
    }

    /// Adds a filled rectangle.
    pub fn fill(&mut self, rect: Rect, color: Rgb8) {
        let corners = [
            (rect.x, rect.y),
            (rect.right(), rect.y),
            (rect.right(), rect.bottom()),
            (rect.x, rect.bottom()),
        ];
        self.area(corners, color);
    }

    /// Adds the outline of a rectangle.
    pub fn outline(&mut self, rect: Rect, color: Rgb8, width: f64) {
        let (left, top, right, bottom) = (rect.x, rect.y, rect.right(), rect.bottom());
        self.line([(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], color, width);
    }

    /// Adds a disc.
    pub fn disc(&mut self, center: (f64, f64), radius: f64, color: Rgb8) {
        self.shapes.push(Shape::Disc { center, radius, color });
    }

    /// Adds a line of text.
    pub fn text(&mut self, text: impl Into<String>, at: (f64, f64), anchor: Anchor, size: f64, color: Rgb8) {
        self.shapes.push(Shape::Text(Text { text: text.into(), at, anchor, size, color, upwards: false }));
    }

    /// Adds a line of text that runs upwards, its middle at the point.
    pub fn text_upwards(&mut self, text: impl Into<String>, at: (f64, f64), size: f64, color: Rgb8) {
        let (text, anchor) = (text.into(), Anchor::Middle);
        self.shapes.push(Shape::Text(Text { text, at, anchor, size, color, upwards: true }));
    }

    /// The same with texts that are a number, and nothing else, as a language writes them: those at axes.
    #[must_use]
    pub fn with_numbers_in(mut self, lang: Lang) -> Self {
        for shape in &mut self.shapes {
            if let Shape::Text(Text { text, .. }) = shape
                && text.replace('–', "-").parse::<f64>().is_ok()
            {
                *text = lang.decimal(core::mem::take(text));
            }
        }
        self
    }

    /// The texts.
    pub fn texts(&self) -> impl Iterator<Item = &Text> {
        self.shapes.iter().filter_map(|shape| match shape {
            Shape::Text(text) => Some(text),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_their_part_of_the_line() {
        let mut page = Page::new(100, 100);
        page.dashes(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)], [0; 3], 1.0, (3.0, 2.0));
        let lengths = page.shapes.iter().map(|shape| match shape {
            Shape::Line { points, .. } => {
                points.windows(2).map(|p| (p[1].0 - p[0].0).abs() + (p[1].1 - p[0].1).abs()).sum()
            }
            _ => 0.0_f64,
        });
        // 20 points hold four dashes of 3 and gaps of 2.
        assert_eq!(lengths.collect::<Vec<_>>(), [3.0; 4]);
    }

    #[test]
    fn numbers_alone_are_written_as_the_language_does() {
        let mut page = Page::new(100, 100);
        for text in ["–0.25", "1e-3", "a.b", "0.5 of D(9300.5)"] {
            page.text(text, (0.0, 0.0), Anchor::Start, 9.0, [0, 0, 0]);
        }
        let texts = |page: &Page| page.texts().map(|text| text.text.clone()).collect::<Vec<_>>();
        let english = page.clone().with_numbers_in(Lang::En);
        assert_eq!(texts(&english), texts(&page));
        let french = page.with_numbers_in(Lang::Fr);
        assert_eq!(texts(&french), ["–0,25", "1e-3", "a.b", "0.5 of D(9300.5)"]);
    }
}
