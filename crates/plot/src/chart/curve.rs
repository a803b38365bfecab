//! Curves: what their points, colours and dashes are.

use crate::page::{Page, Rgb8};

/// A curve of values, over wavelength or an angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What it is called in the legend; empty for a curve that is not in it.
    pub name: String,
    /// Wavelengths in nm or angles in degrees, and values, in order.
    pub points: Vec<(f64, f64)>,
    /// Its colour.
    pub color: Rgb8,
    /// The lengths of its dashes and of the gaps between them in points, if it has any.
    pub dash: Option<(f64, f64)>,
}

impl Curve {
    /// Draws a line in the curve's style.
    pub fn stroke(&self, page: &mut Page, points: &[(f64, f64)], width: f64) {
        match self.dash {
            Some(dash) => page.dashes(points, self.color, width, dash),
            None => page.line(points.iter().copied(), self.color, width),
        }
    }
}

/// The least and the greatest value, and 0.
pub(crate) fn extent(curves: &[Curve]) -> (f64, f64) {
    let values = || curves.iter().flat_map(|curve| curve.points.iter().map(|(_, value)| *value));
    (values().fold(0.0, f64::min), values().fold(0.0, f64::max))
}

/// Curves as a table with the columns `curve`, `x` and `y`, named by what they hold; one row per point.
pub fn csv(x: &str, y: &str, curves: &[Curve]) -> String {
    let quoted = |text: &str| match text.contains([',', '"', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    };
    let mut text = format!("curve,{},{}\n", quoted(x), quoted(y));
    for curve in curves {
        let name = quoted(&curve.name);
        for (x, y) in &curve.points {
            text += &format!("{name},{x},{y}\n");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_a_row_for_each_point_and_quotes_commas() {
        let curve = Curve {
            name: "a, b".to_owned(),
            points: vec![(0.0, 1.0), (0.5, 2.0)],
            color: [0; 3],
            dash: None,
        };
        assert_eq!(csv("x in °", "y", &[curve]), "curve,x in °,y\n\"a, b\",0,1\n\"a, b\",0.5,2\n");
    }
}
