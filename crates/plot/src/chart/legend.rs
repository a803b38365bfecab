//! Legends: the names of curves, each beside a piece of its curve.

use super::curve::Curve;
use crate::page::style::{INK, NUMBER};
use crate::page::{Anchor, Page, letters};

/// From one name to the next below it.
const NAME: f64 = 24.0;
/// The length of the piece of curve beside a name.
const PIECE: f64 = 26.0;
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
pub(crate) fn draw(page: &mut Page, (x, y): (f64, f64), curves: &[Curve]) {
    for (index, curve) in curves.iter().filter(|curve| !curve.name.is_empty()).enumerate() {
        let y = y + NAME * index as f64;
        curve.stroke(page, &[(x, y), (x + PIECE, y)], 2.8);
        let at = (x + PIECE + GAP, y + 0.36 * NUMBER);
        page.text(&curve.name, at, Anchor::Start, NUMBER, INK);
    }
}
