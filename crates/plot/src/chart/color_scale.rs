//! A scale of colours for values, and the bar that explains it.

use super::axes::Axis;
use crate::page::style::{GRAY, NUMBER, Rgb8};
use crate::page::{Anchor, Page, Raster, Rect};

/// The scale "magma" of S. van der Walt and N. Smith (2015, CC0) from its light end, at even steps.
const SCALE: [Rgb8; 8] = [
    [0xfc, 0xfd, 0xbf],
    [0xfe, 0xc2, 0x87],
    [0xfa, 0x7f, 0x5e],
    [0xe0, 0x4c, 0x67],
    [0xa8, 0x32, 0x7d],
    [0x6b, 0x1d, 0x81],
    [0x2c, 0x11, 0x5f],
    [0x00, 0x00, 0x04],
];

/// The colour at a part, 0 … 1, of the scale.
pub fn magma(part: f64) -> Rgb8 {
    let position = part.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let left = (position as usize).min(SCALE.len() - 2);
    let t = position - left as f64;
    core::array::from_fn(|i| {
        let (a, b) = (f64::from(SCALE[left][i]), f64::from(SCALE[left + 1][i]));
        (a + (b - a) * t).round() as u8
    })
}

/// Draws the scale upwards, with the numbers of an axis beside it.
pub(crate) fn bar(page: &mut Page, rect: Rect, axis: &Axis) {
    let rows = (rect.height as usize).max(1);
    let rgb = (0..rows).rev().flat_map(|row| magma((row as f64 + 0.5) / rows as f64));
    page.rasters.push(Raster { rect, columns: 1, rows, rgb: rgb.collect() });
    page.outline(rect, GRAY, 1.2);
    for tick in &axis.ticks {
        let y = rect.bottom() - rect.height * axis.part(*tick);
        page.line([(rect.right(), y), (rect.right() + 5.0, y)], GRAY, 1.2);
        let at = (rect.right() + 9.0, y + 0.36 * NUMBER);
        page.text(axis.number(*tick), at, Anchor::Start, NUMBER, GRAY);
    }
}
