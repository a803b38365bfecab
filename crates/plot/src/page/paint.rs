//! Shapes onto a back end of `plotters`. Texts are left to the formats: `plotters` knows no bearings of
//! letters.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::shapes::{Page, Shape};
use super::style::Rgb8;

/// Draws the shapes of a page except texts, each point `scale` pixels large.
pub(super) fn paint<B: DrawingBackend>(
    page: &Page,
    scale: f64,
    area: &DrawingArea<B, Shift>,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let pixel = |point: &(f64, f64)| ((point.0 * scale).round() as i32, (point.1 * scale).round() as i32);
    for shape in &page.shapes {
        match shape {
            Shape::Line { points, color, width } => {
                let width = (width * scale).round().max(1.0) as u32;
                let points: Vec<_> = points.iter().map(pixel).collect();
                area.draw(&PathElement::new(points, rgb(*color).stroke_width(width)))?;
            }
            Shape::Area { points, color } => {
                let points: Vec<_> = points.iter().map(pixel).collect();
                area.draw(&Polygon::new(points, rgb(*color).filled()))?;
            }
            Shape::Disc { center, radius, color } => {
                let radius = (radius * scale).round() as i32;
                area.draw(&Circle::new(pixel(center), radius, rgb(*color).filled()))?;
            }
            Shape::Text(_) => {}
        }
    }
    Ok(())
}

fn rgb([r, g, b]: Rgb8) -> RGBColor {
    RGBColor(r, g, b)
}
