//! Points and the lines that a regression laid through them.

use crate::chart::{Axes, Axis, Curve, heading, legend, panel, runs};
use crate::data::PlotData;
use crate::page::{Figure, Page, Rect};
use crate::words::Lang;

/// The size of the area of the values in points.
const AREA: (f64, f64) = (720.0, 440.0);
/// The least of it.
const LEAST: (f64, f64) = (240.0, 160.0);
/// From the edges of the page to the area: left, top, right and bottom.
const MARGIN: [f64; 4] = [104.0, 104.0, 40.0, 84.0];
/// The radius of a point.
const RADIUS: f64 = 1.8;

/// Points and the lines that a regression laid through them.
///
/// ```
/// use glanz_plot::words::Lang;
/// use glanz_plot::{Axis, Curve, Figure, RegressionChart};
///
/// let cloud = |points: Vec<(f64, f64)>| Curve { name: "readings".to_owned(), points, color: [60, 90, 160], dash: None };
/// let chart = RegressionChart {
///     title: "A line".to_owned(),
///     subtitle: String::new(),
///     x: Axis::exact("x", (0.0, 2.0), 4),
///     y: Axis::exact("y", (0.0, 4.0), 4),
///     clouds: vec![cloud(vec![(0.5, 1.1), (1.0, 1.9), (1.5, 3.0)])],
///     lines: vec![Curve { name: "fit".to_owned(), points: vec![(0.0, 0.0), (2.0, 4.0)], color: [0, 0, 0], dash: None }],
///     lang: Lang::En,
/// };
/// assert!(chart.csv().starts_with("curve,x,y\nreadings,0.5,1.1\n"));
/// assert!(chart.svg()?.starts_with("<svg"));
/// # Ok::<(), glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RegressionChart {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// From left to right.
    pub x: Axis,
    /// From bottom to top.
    pub y: Axis,
    /// Points, drawn as dots; those outside of the axes are left out of the drawing.
    pub clouds: Vec<Curve>,
    /// Lines, above the points.
    pub lines: Vec<Curve>,
    /// The language of the numbers.
    pub lang: Lang,
}

impl RegressionChart {
    pub(super) fn all(&self) -> Vec<Curve> {
        self.clouds.iter().chain(&self.lines).cloned().collect()
    }

    /// Draws all but title and legend.
    pub(super) fn draw(&self, page: &mut Page, rect: Rect) {
        let axes = Axes { rect, x: self.x.clone(), y: self.y.clone(), gap: 0.0 };
        axes.grid(page);
        let inside = |axis: &Axis, value: f64| value >= axis.range.0 && value <= axis.range.1;
        for cloud in &self.clouds {
            let shown = cloud.points.iter().filter(|(x, y)| inside(&self.x, *x) && inside(&self.y, *y));
            for (x, y) in shown {
                page.disc(axes.at(*x, *y), RADIUS, cloud.color);
            }
        }
        for line in &self.lines {
            for run in runs(&line.points, &self.y) {
                let points: Vec<_> = run.iter().map(|(x, y)| axes.at(*x, *y)).collect();
                line.stroke(page, &points, 2.0);
            }
        }
        axes.frame(page);
    }
}

impl Figure for RegressionChart {
    fn layout(&self, size: Option<(f64, f64)>) -> Page {
        let [left, top, right, bottom] = MARGIN;
        let curves = self.all();
        let names = legend::width(&curves);
        let beside = if names > 0.0 { names + 28.0 } else { 0.0 };
        let area = size.map_or(AREA, |(width, height)| {
            ((width - left - beside - right).max(LEAST.0), (height - top - bottom).max(LEAST.1))
        });
        let height = area.1.max(legend::height(&curves));
        let width = left + area.0 + beside + right;
        let mut page = Page::new(width.ceil() as u32, (top + height + bottom) as u32);
        heading(&mut page, left, &self.title, &self.subtitle);
        let rect = Rect { x: left, y: top, width: area.0, height };
        self.draw(&mut page, rect);
        let at = (rect.right() + 24.0, rect.y + 12.0);
        legend::draw_after_clouds(&mut page, at, &curves, self.clouds.len());
        page
    }

    fn data(&self) -> PlotData {
        PlotData::new(&self.title, &self.subtitle, vec![panel("", &self.x.label, &self.y.label, &self.all())])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}
