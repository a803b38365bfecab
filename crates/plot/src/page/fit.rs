//! Pages of another size.

use super::shapes::{Page, Raster, Rect, Shape, Text};

impl Page {
    /// The page as large as fits into one of exactly this size, in its middle, with one pixel per point.
    #[must_use]
    pub fn fitted(self, width: f64, height: f64) -> Self {
        let scale = (width / f64::from(self.width)).min(height / f64::from(self.height));
        let left = 0.5 * (width - scale * f64::from(self.width));
        let top = 0.5 * (height - scale * f64::from(self.height));
        let place = |(x, y): (f64, f64)| (left + scale * x, top + scale * y);
        let places = |points: Vec<(f64, f64)>| points.into_iter().map(place).collect();
        let raster = |raster: Raster| {
            let (x, y) = place((raster.rect.x, raster.rect.y));
            let rect = Rect { x, y, width: scale * raster.rect.width, height: scale * raster.rect.height };
            Raster { rect, ..raster }
        };
        let shape = |shape| match shape {
            Shape::Line { points, color, width } => {
                Shape::Line { points: places(points), color, width: scale * width }
            }
            Shape::Area { points, color } => Shape::Area { points: places(points), color },
            Shape::Disc { center, radius, color } => {
                Shape::Disc { center: place(center), radius: scale * radius, color }
            }
            Shape::Text(text) => Shape::Text(Text { at: place(text.at), size: scale * text.size, ..text }),
        };
        Self {
            width: width.round() as u32,
            height: height.round() as u32,
            density: 1,
            rasters: self.rasters.into_iter().map(raster).collect(),
            shapes: self.shapes.into_iter().map(shape).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_fitted_into_the_middle_of_another() {
        let mut page = Page::new(100, 50);
        page.disc((50.0, 25.0), 10.0, [0; 3]);
        page.line([(0.0, 0.0), (100.0, 50.0)], [0; 3], 2.0);
        let fitted = page.fitted(200.0, 300.0);
        assert_eq!((fitted.width, fitted.height, fitted.density), (200, 300, 1));
        let disc = Shape::Disc { center: (100.0, 150.0), radius: 20.0, color: [0; 3] };
        let line = Shape::Line { points: vec![(0.0, 100.0), (200.0, 200.0)], color: [0; 3], width: 4.0 };
        assert_eq!(fitted.shapes, [disc, line]);
    }
}
