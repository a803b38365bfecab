//! The view of a point of a surface in space: from points of space to points of a page.

use crate::page::Page;
use crate::page::style::{GRAY, GRID};

/// Where the point of the surface lies on the page, how long a unit is, and from where it is seen, from far away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    center: (f64, f64),
    radius: f64,
    elevation: (f64, f64),
    around: (f64, f64),
}

impl Projection {
    /// Seen from this angle above the surface, and this one around it from x towards y, both in degrees.
    pub(super) fn new(center: (f64, f64), radius: f64, (elevation, around): (f64, f64)) -> Self {
        Self {
            center,
            radius,
            elevation: libm::sincos(elevation.to_radians()),
            around: libm::sincos(around.to_radians()),
        }
    }

    /// The point of the page, and how near to the eye it is.
    pub(super) fn apply(&self, [x, y, z]: [f64; 3]) -> ((f64, f64), f64) {
        let (sine, cosine) = self.around;
        let (right, towards) = (-x * sine + y * cosine, x * cosine + y * sine);
        let (up_sine, up_cosine) = self.elevation;
        let up = z * up_cosine - towards * up_sine;
        let near = towards * up_cosine + z * up_sine;
        ((self.center.0 + self.radius * right, self.center.1 - self.radius * up), near)
    }

    /// Draws the surface as circles and lines.
    pub(super) fn ground(&self, page: &mut Page) {
        let circle = |radius: f64| {
            (0..=120).map(move |i| {
                let (sine, cosine) = libm::sincos(f64::from(i) * 3_f64.to_radians());
                self.apply([radius * cosine, radius * sine, 0.0]).0
            })
        };
        for radius in [0.25, 0.5, 0.75] {
            page.line(circle(radius), GRID, 1.2);
        }
        for spoke in 0..6 {
            let (sine, cosine) = libm::sincos(f64::from(spoke) * 30_f64.to_radians());
            let ends = [-1.0, 1.0].map(|side| self.apply([side * cosine, side * sine, 0.0]).0);
            page.line(ends, GRID, 1.2);
        }
        page.line(circle(1.0), GRAY, 1.2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_is_up_and_what_is_in_front_is_near() {
        let around = -62.0_f64;
        let projection = Projection::new((0.0, 0.0), 180.0, (24.0, around));
        let ((x, y), _) = projection.apply([0.0, 0.0, 1.0]);
        assert!(x.abs() < 1e-12 && y < -100.0);
        let (sine, cosine) = libm::sincos(around.to_radians());
        let near = |k: f64| projection.apply([k * cosine, k * sine, 0.0]).1;
        assert!(near(1.0) > 0.5 && near(-1.0) < -0.5);
    }
}
