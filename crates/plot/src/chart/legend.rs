//! Legends: the names of curves, each beside a piece of its curve.

use super::curve::Curve;
use crate::page::style::{INK, NUMBER};
use crate::page::{Anchor, Page, letters};

/// From one name to the next below it.
const NAME: f64 = 24.0;
/// The length of the piece of curve beside a name.
const PIECE: f64 = 26.0;
/// The radius of a point that stands for a cloud.
const DOT: f64 = 3.0;
/// From the end of the piece to the name.
const GAP: f64 = 8.0;

/// The width of the legend in points.
pub(crate) fn width(curves: &[Curve]) -> f64 {
    let widest = curves.iter().map(|curve| letters::width(&curve.name, NUMBER)).fold(0.0, f64::max);
    if widest == 0.0 { 0.0 } else { PIECE + GAP + widest }
}

/// The height of the legend in points.
pub(crate) fn height(curves: &[Curve]) -> f64 {
    NAME * curves.iter().filter(|curve| !curve.name.is_empty()).count() as f64
}

/// Writes the names below each other, each beside a piece of its curve.
pub(crate) fn draw(page: &mut Page, at: (f64, f64), curves: &[Curve]) {
    draw_after_clouds(page, at, curves, 0);
}

/// The same of curves the first of which are clouds of points, so many of them.
pub(crate) fn draw_after_clouds(page: &mut Page, (x, y): (f64, f64), curves: &[Curve], clouds: usize) {
    let named = curves.iter().enumerate().filter(|(_, curve)| !curve.name.is_empty());
    for (row, (index, curve)) in named.enumerate() {
        let y = y + NAME * row as f64;
        match index < clouds {
            true => page.disc((x + 0.5 * PIECE, y), DOT, curve.color),
            false => curve.stroke(page, &[(x, y), (x + PIECE, y)], 2.8),
        }
        let at = (x + PIECE + GAP, y + 0.36 * NUMBER);
        page.text(&curve.name, at, Anchor::Start, NUMBER, INK);
    }
}
