//! Lobes about a point of a surface, in the plane of incidence.

use crate::chart::{Axis, Curve, heading, legend, panel};
use crate::data::PlotData;
use crate::page::style::{GRAY, GRID, INK, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page};
use crate::words::{Lang, Word};

/// The radius of the outermost circle in points.
const RADIUS: f64 = 330.0;
/// From the circle to the edges of the page, where numbers of angles stand.
const RIM: f64 = 76.0;
/// The space above, for the title.
const TOP: f64 = 92.0;
/// The space below the surface where nothing passes through.
const BOTTOM: f64 = 66.0;

/// The radius of a point.
const DOT: f64 = 2.0;

/// A direction that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Ray {
    /// The angle from the normal in degrees, positive to the right.
    pub degrees: f64,
    /// What stands at its end; may be empty.
    pub label: String,
    /// Its colour.
    pub color: Rgb8,
    /// Whether it is dashed.
    pub dashed: bool,
}

/// Curves of values by angle.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarChart {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// The values from the middle outwards.
    pub radius: Axis,
    /// Angles from the normal in degrees (−180 … 180, positive to the right) and values.
    pub curves: Vec<Curve>,
    /// Points of the same kind, drawn as dots.
    pub clouds: Vec<Curve>,
    /// Directions that are marked.
    pub rays: Vec<Ray>,
    /// Whether what is below the surface is shown too.
    pub whole: bool,
    /// The language of the words about the surface.
    pub lang: Lang,
}

impl Figure for PolarChart {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let all = self.all();
        let names = legend::width(&all);
        let width = 2.0 * (RADIUS + RIM) + if names > 0.0 { names + 30.0 } else { 0.0 };
        let below = if self.whole { RADIUS + RIM } else { BOTTOM };
        let height = TOP + 30.0 + RADIUS + below.max(legend::height(&all) - RADIUS);
        let mut page = Page::new(width.ceil() as u32, height.ceil() as u32);
        let circle = Circle { center: (RIM + RADIUS, TOP + 30.0 + RADIUS), radius: RADIUS };
        heading(&mut page, 40.0, &self.title, &self.subtitle);
        self.draw(&mut page, circle);
        let at = (circle.center.0 + RADIUS + RIM + 10.0, TOP + 40.0);
        legend::draw_after_clouds(&mut page, at, &all, self.clouds.len());
        page
    }

    fn data(&self) -> PlotData {
        let x = self.lang.say(Word::AngleOfLight, &[]);
        PlotData::new(&self.title, &self.subtitle, vec![panel("", &x, &self.radius.label, &self.all())])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

/// Where the outermost circle lies on a page.
#[derive(Clone, Copy)]
pub(super) struct Circle {
    pub(super) center: (f64, f64),
    pub(super) radius: f64,
}

impl Circle {
    /// The point at an angle from the normal, in parts of the radius.
    fn at(self, degrees: f64, part: f64) -> (f64, f64) {
        place(self.center, degrees, self.radius * part)
    }

    /// The point so many points beyond the rim.
    fn beyond(self, degrees: f64, points: f64) -> (f64, f64) {
        place(self.center, degrees, self.radius + points)
    }
}

impl PolarChart {
    pub(super) fn all(&self) -> Vec<Curve> {
        self.clouds.iter().chain(&self.curves).cloned().collect()
    }

    /// Draws all but title and legend.
    pub(super) fn draw(&self, page: &mut Page, circle: Circle) {
        self.grid(page, circle);
        for ray in &self.rays {
            ray.draw(page, circle);
        }
        let place = |(degrees, value): &(f64, f64)| circle.at(*degrees, self.part(*value));
        let finite = |curve: &Curve| -> Vec<(f64, f64)> {
            curve.points.iter().filter(|(_, value)| value.is_finite()).map(place).collect()
        };
        for cloud in &self.clouds {
            finite(cloud).into_iter().for_each(|at| page.disc(at, DOT, cloud.color));
        }
        for curve in &self.curves {
            curve.stroke(page, &finite(curve), 2.4);
        }
    }

    /// How far out a value is; none is in the middle.
    fn part(&self, value: f64) -> f64 {
        if value <= 0.0 { 0.0 } else { self.radius.part(value) }
    }

    fn grid(&self, page: &mut Page, circle: Circle) {
        let (center, radius) = (circle.center, circle.radius);
        let reach: i32 = if self.whole { 180 } else { 90 };
        let arc = |part: f64| (-reach..=reach).map(move |d| circle.at(f64::from(d), part));
        for tick in self.radius.ticks.iter().filter(|tick| self.radius.part(**tick) > 0.0) {
            let part = self.radius.part(*tick);
            page.line(arc(part), GRID, 1.2);
            let at = (center.0 + radius * part, center.1 + 1.4 * NUMBER);
            page.text(self.radius.number(*tick), at, Anchor::Middle, NUMBER - 1.0, GRAY);
        }
        page.line(arc(1.0), GRAY, 1.2);
        for degrees in (-reach..=reach).step_by(15) {
            let angle = f64::from(degrees);
            page.line([center, circle.at(angle, 1.0)], GRID, 1.0);
            if degrees % 30 == 0 && degrees != -180 && degrees.abs() != 90 {
                let (x, y) = circle.beyond(angle, 16.0);
                let text = format!("{degrees}°").replace('-', "–");
                page.text(text, (x, y + 0.36 * NUMBER), Anchor::Middle, NUMBER, GRAY);
            }
        }
        self.ground(page, circle);
    }

    /// The line of the surface, with what stands below it.
    fn ground(&self, page: &mut Page, Circle { center, radius }: Circle) {
        let (left, right) = (center.0 - radius - 14.0, center.0 + radius + 14.0);
        page.line([(left, center.1), (right, center.1)], INK, 3.0);
        let at = (left, center.1 + 1.4 * NUMBER);
        page.text(self.lang.say(Word::Surface, &[]), at, Anchor::Start, NUMBER, INK);
        if !self.whole {
            let at = (center.0, center.1 + 3.2 * NUMBER);
            page.text(&self.radius.label, at, Anchor::Middle, NUMBER, INK);
        }
    }
}

impl Ray {
    fn draw(&self, page: &mut Page, circle: Circle) {
        let end = circle.at(self.degrees, 1.0);
        match self.dashed {
            true => page.dashes(&[circle.center, end], self.color, 1.6, (3.0, 5.0)),
            false => page.line([circle.center, end], self.color, 1.8),
        }
        if !self.dashed {
            page.disc(end, 5.0, self.color);
        }
        let (x, y) = circle.beyond(self.degrees, 30.0);
        let anchor = match self.degrees {
            d if d.abs() < 12.0 => Anchor::Middle,
            d if d < 0.0 => Anchor::End,
            _ => Anchor::Start,
        };
        // Above the numbers of the rim, and within the page at its sides.
        let x = x.clamp(circle.center.0 - circle.radius, circle.center.0 + circle.radius + RIM);
        let lift = if anchor == Anchor::Middle { -2.0 } else { -6.0 };
        page.text(&self.label, (x, y + lift), anchor, NUMBER, self.color);
    }
}

/// The point at an angle from the normal.
fn place((x, y): (f64, f64), degrees: f64, radius: f64) -> (f64, f64) {
    let (sine, cosine) = libm::sincos(degrees.to_radians());
    (x + radius * sine, y - radius * cosine)
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn the_normal_points_up_and_positive_angles_to_the_right() {
        let near = |(x, y): (f64, f64), (a, b): (f64, f64)| (x - a).abs() < 1e-12 && (y - b).abs() < 1e-12;
        assert!(near(place((10.0, 10.0), 0.0, 5.0), (10.0, 5.0)));
        assert!(near(place((10.0, 10.0), 90.0, 5.0), (15.0, 10.0)));
        assert!(near(place((10.0, 10.0), -180.0, 5.0), (10.0, 15.0)));
    }
}
