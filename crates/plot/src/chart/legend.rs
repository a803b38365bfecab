//! Curves and their names.

use super::curves::Curve;
use super::letters;
use super::picture::{Anchor, Picture};
use super::style::{INK, NUMBER};

/// From one name to the next below it.
const NAME: f64 = 24.0;
/// The length of the piece of curve beside a name.
const PIECE: f64 = 26.0;
/// From the end of the piece to the name.
const GAP: f64 = 8.0;

impl Curve {
    /// Draws a line in the curve's style.
    pub fn stroke(&self, picture: &mut Picture, points: &[(f64, f64)], width: f64) {
        match self.dash {
            Some(dash) => picture.dashes(points, self.color, width, dash),
            None => picture.line(points.iter().copied(), self.color, width),
        }
    }
}

/// The room that the names take to the right.
pub fn width(curves: &[Curve]) -> f64 {
    let widest = curves.iter().map(|curve| letters::width(&curve.name, NUMBER)).fold(0.0, f64::max);
    if widest == 0.0 { 0.0 } else { PIECE + GAP + widest }
}

/// The room that the names take downwards.
pub fn height(curves: &[Curve]) -> f64 {
    NAME * curves.iter().filter(|curve| !curve.name.is_empty()).count() as f64
}

/// Writes the names below each other, each beside a piece of its curve.
pub fn draw(picture: &mut Picture, (x, y): (f64, f64), curves: &[Curve]) {
    for (index, curve) in curves.iter().filter(|curve| !curve.name.is_empty()).enumerate() {
        let y = y + NAME * index as f64;
        curve.stroke(picture, &[(x, y), (x + PIECE, y)], 2.8);
        let at = (x + PIECE + GAP, y + 0.36 * NUMBER);
        picture.text(&curve.name, at, Anchor::Start, NUMBER, INK);
    }
}
