//! Curves: what their points, colours and dashes are.

use crate::data::{DataCurve, DataPanel};
use crate::page::{Page, Rgb8};

/// A curve of values, over wavelength, an angle or a distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What it is called in the legend; empty for a curve that is not in it.
    pub name: String,
    /// Wavelengths in nm, angles in degrees or distances in metres, and values, in order.
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

/// The numbers of curves, under the names of what they hold.
pub fn panel(title: &str, x: &str, y: &str, curves: &[Curve]) -> DataPanel {
    let curves = curves.iter().map(|curve| DataCurve::of_pairs(&curve.name, curve.points.iter().copied()));
    DataPanel { title: title.to_owned(), columns: vec![x.to_owned(), y.to_owned()], curves: curves.collect() }
}
