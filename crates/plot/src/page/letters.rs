//! The font of plots, and pixels of its letters.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};

use super::shapes::{Anchor, Text};

/// The font's file.
pub(crate) const FILE: &[u8] = include_bytes!("font/NotoSans-Subset.ttf");

/// Noto Sans, with the letters that plots need: Latin, Greek, digits above and below the line.
static FONT: LazyLock<FontRef<'static>> =
    LazyLock::new(|| FontRef::try_from_slice(FILE).expect("the font compiled into this command is whole"));

/// The scale at which letters are so many pixels per em.
fn scale(em: f64) -> PxScale {
    let height = f64::from(FONT.height_unscaled());
    PxScale::from((em * height / f64::from(FONT.units_per_em().unwrap_or(1000.0))) as f32)
}

/// The width of a text of this size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    let font = FONT.as_scaled(scale(size));
    text.chars().map(|c| f64::from(font.h_advance(font.glyph_id(c)))).sum()
}

/// The number of a letter's glyph; 0 for a letter that the font does not have.
pub(crate) fn glyph(letter: char) -> u16 {
    FONT.glyph_id(letter).0
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
    let units = FONT.units_per_em().unwrap_or(1000.0) / 1000.0;
    (FONT.ascent_unscaled() / units, FONT.descent_unscaled() / units)
}

/// Gives every pixel that a text covers, and how much of it, for points of `pixels` pixels.
pub(crate) fn draw(text: &Text, pixels: f64, mut cover: impl FnMut(i32, i32, f32)) {
    let font = FONT.as_scaled(scale(text.size * pixels));
    let whole = width(&text.text, text.size * pixels);
    let mut along = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * whole,
        Anchor::End => -whole,
    } as f32;
    let (x, y) = ((text.at.0 * pixels).round() as i32, (text.at.1 * pixels).round() as i32);
    for c in text.text.chars() {
        let id = font.glyph_id(c);
        let glyph: Glyph = id.with_scale_and_position(font.scale(), point(along, 0.0));
        along += font.h_advance(id);
        let Some(outline) = font.outline_glyph(glyph) else { continue };
        let bounds = outline.px_bounds();
        let (left, top) = (bounds.min.x as i32, bounds.min.y as i32);
        outline.draw(|column, row, part| {
            let (right, down) = (left + column as i32, top + row as i32);
            match text.upwards {
                true => cover(x + down, y - right, part),
                false => cover(x + right, y + down, part),
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_the_letters_of_plots() {
        for c in "AZaz09 λΔ₀°′–’()/.,:%".chars() {
            assert_ne!(FONT.glyph_id(c).0, 0, "'{c}'");
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
