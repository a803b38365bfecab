//! The font of plots, and pixels of its letters.

use std::sync::LazyLock;

use ab_glyph_rasterizer::{Point, Rasterizer, point};
use skrifa::charmap::Charmap;
use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::{GlyphMetrics, Metrics};
use skrifa::outline::{DrawSettings, OutlineGlyphCollection, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};

use super::shapes::{Anchor, Text};

/// The font's file.
pub(crate) const FILE: &[u8] = include_bytes!("font/NotoSans-Subset.ttf");

/// Noto Sans, with the letters that plots need: Latin, Greek, digits above and below the line.
static FONT: LazyLock<Letters> = LazyLock::new(|| {
    let font = FontRef::new(FILE).expect("the font compiled into this command is whole");
    let (size, place) = (Size::unscaled(), LocationRef::default());
    Letters {
        map: font.charmap(),
        metrics: font.metrics(size, place),
        glyphs: font.glyph_metrics(size, place),
        outlines: font.outline_glyphs(),
    }
});

/// What is asked of a font, in its own units.
struct Letters {
    map: Charmap<'static>,
    metrics: Metrics,
    glyphs: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
}

impl Letters {
    fn glyph(&self, letter: char) -> GlyphId {
        self.map.map(letter).unwrap_or_default()
    }

    fn advance(&self, glyph: GlyphId) -> f32 {
        self.glyphs.advance_width(glyph).unwrap_or_default()
    }

    /// The pixels of a unit where letters are so many pixels per em.
    fn pixels(&self, em: f64) -> f32 {
        (em / f64::from(self.metrics.units_per_em)) as f32
    }
}

/// The width of a text of this size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    let pixels = FONT.pixels(size);
    text.chars().map(|c| f64::from(pixels * FONT.advance(FONT.glyph(c)))).sum()
}

/// The number of a letter's glyph; 0 for a letter that the font does not have.
pub(crate) fn glyph(letter: char) -> u16 {
    FONT.glyph(letter).to_u32() as u16
}

/// The letters of a text that the font does not have, each once.
pub fn missing(text: &str) -> Vec<char> {
    let mut missing: Vec<_> = text.chars().filter(|letter| glyph(*letter) == 0).collect();
    missing.sort_unstable();
    missing.dedup();
    missing
}

/// How far letters reach above and below the line, in thousandths of 1 em.
pub(crate) fn metrics() -> (f32, f32) {
    let units = f32::from(FONT.metrics.units_per_em) / 1000.0;
    (FONT.metrics.ascent / units, FONT.metrics.descent / units)
}

/// Gives every pixel that a text covers, and how much of it, for points of `pixels` pixels.
pub(crate) fn draw(text: &Text, pixels: f64, mut cover: impl FnMut(i32, i32, f32)) {
    let unit = FONT.pixels(text.size * pixels);
    let whole = width(&text.text, text.size * pixels);
    let mut along = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * whole,
        Anchor::End => -whole,
    } as f32;
    let (x, y) = ((text.at.0 * pixels).round() as i32, (text.at.1 * pixels).round() as i32);
    for letter in text.text.chars() {
        let glyph = FONT.glyph(letter);
        rasterize(glyph, unit, along, |column, row, part| match text.upwards {
            true => cover(x + row, y - column, part),
            false => cover(x + column, y + row, part),
        });
        along += unit * FONT.advance(glyph);
    }
}

/// Gives the pixels of a glyph on the line at `along`, with units of so many pixels; rows go down.
fn rasterize(glyph: GlyphId, unit: f32, along: f32, mut cover: impl FnMut(i32, i32, f32)) {
    let (Some(outline), Some(bounds)) = (FONT.outlines.get(glyph), FONT.glyphs.bounds(glyph)) else { return };
    // Rounded as every point is, so that none is outside: the rasteriser would fill the rest of its row.
    let (whole, part) = (along.floor(), along - along.floor());
    let (left, right) = ((bounds.x_min * unit + part).floor(), (bounds.x_max * unit + part).ceil());
    let (top, bottom) = ((-bounds.y_max * unit).floor(), (-bounds.y_min * unit).ceil());
    let size = ((right - left) as usize, (bottom - top) as usize);
    if size.0 == 0 || size.1 == 0 {
        return;
    }
    let mut pen = Pen {
        rasterizer: Rasterizer::new(size.0, size.1),
        unit,
        part,
        corner: point(left, top),
        start: point(0.0, 0.0),
        last: point(0.0, 0.0),
    };
    let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
    // A glyph that is damaged is left out; the font that is compiled in has none.
    if outline.draw(settings, &mut pen).is_err() {
        return;
    }
    let (left, top) = ((whole + left) as i32, top as i32);
    pen.rasterizer.for_each_pixel_2d(|column, row, part| cover(left + column as i32, top + row as i32, part));
}

/// Draws outlines in the font's units into pixels, whose rows go down.
struct Pen {
    rasterizer: Rasterizer,
    unit: f32,
    /// How far the glyph's origin is from a whole pixel.
    part: f32,
    /// The first of the pixels.
    corner: Point,
    /// Where the contour began.
    start: Point,
    last: Point,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> Point {
        point(x * self.unit + self.part, -y * self.unit) - self.corner
    }
}

impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.start = self.at(x, y);
        self.last = self.start;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let to = self.at(x, y);
        self.rasterizer.draw_line(self.last, to);
        self.last = to;
    }

    fn quad_to(&mut self, control_x: f32, control_y: f32, x: f32, y: f32) {
        let (control, to) = (self.at(control_x, control_y), self.at(x, y));
        self.rasterizer.draw_quad(self.last, control, to);
        self.last = to;
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let [a, b, to] = [self.at(ax, ay), self.at(bx, by), self.at(x, y)];
        self.rasterizer.draw_cubic(self.last, a, b, to);
        self.last = to;
    }

    fn close(&mut self) {
        self.rasterizer.draw_line(self.last, self.start);
        self.last = self.start;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_the_letters_of_plots() {
        for c in "AZaz09 λΔ₀°′–’()/.,:%".chars() {
            assert_ne!(glyph(c), 0, "'{c}'");
        }
    }

    /// A point outside of a letter's pixels, by rounding alone, would fill rows up to their ends.
    #[test]
    fn letters_whose_edge_is_at_the_edge_of_a_pixel_do_not_leak() {
        let ink = |glyph, unit, along| {
            let mut sum = 0.0;
            rasterize(glyph, unit, along, |_, _, part| sum += part);
            sum
        };
        for letter in "rHil".chars() {
            let (glyph, unit) = (FONT.glyph(letter), FONT.pixels(24.0));
            let expected = ink(glyph, unit, 0.0);
            for number in 0..4000 {
                let unit = unit * (1.0 + 1e-4 * (number % 7) as f32);
                let edge = number as f32 * 0.37;
                let along = edge.round() - FONT.glyphs.bounds(glyph).unwrap().x_min * unit;
                for along in [along.next_down(), along, along.next_up()] {
                    let off = ink(glyph, unit, along) / expected - 1.0;
                    assert!(off.abs() < 0.02, "'{letter}' at {along}: {off}");
                }
            }
        }
    }

    #[test]
    fn a_text_in_the_middle_covers_both_sides_of_its_point_alike() {
        let text = Text {
            text: "oooo".to_owned(),
            at: (50.0, 50.0),
            anchor: Anchor::Middle,
            size: 10.0,
            color: [0; 3],
            upwards: false,
        };
        let (mut left, mut right) = (0.0, 0.0);
        draw(&text, 4.0, |x, _, part| if x < 200 { left += part } else { right += part });
        assert!(left > 100.0 && (left / right - 1.0).abs() < 0.05, "{left} {right}");
    }
}
