//! Curves in a pair of axes.

use super::axes::{Axes, Axis};
use super::curve::{Curve, panel};
use super::heading::heading;
use super::legend;
use crate::data::{DataPanel, PlotData};
use crate::page::style::{INK, LABEL, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page, Rect};
use crate::words::Lang;

/// The size of the area of the values in points.
const AREA: (f64, f64) = (720.0, 440.0);
/// The least of it.
const LEAST: (f64, f64) = (240.0, 160.0);
/// The same for plots that stand side by side.
const PANEL: (f64, f64) = (380.0, 360.0);
/// From the edges of the page to the area: left, top, right and bottom.
const MARGIN: [f64; 4] = [104.0, 104.0, 40.0, 84.0];

/// A value of x that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct LineMark {
    /// Where.
    pub x: f64,
    /// What stands above it.
    pub label: String,
    /// The colour of its line.
    pub color: Rgb8,
}

/// Curves in a pair of axes.
///
/// ```
/// use glanz_plot::words::Lang;
/// use glanz_plot::{Axis, Curve, Figure, LineChart};
///
/// let points = (0..=90).map(|angle| (f64::from(angle), f64::from(angle).to_radians().cos())).collect();
/// let curve = Curve { name: "cosine".to_owned(), points, color: [0, 0, 0], dash: None };
/// let chart = LineChart {
///     title: "Lambert's law".to_owned(),
///     subtitle: String::new(),
///     x: Axis::exact("angle in °", (0.0, 90.0), 9),
///     y: Axis::exact("irradiance", (0.0, 1.0), 5),
///     curves: vec![curve],
///     marks: Vec::new(),
///     lang: Lang::En,
/// };
/// assert!(chart.csv().lines().count() > 90);
/// assert!(chart.svg()?.starts_with("<svg"));
/// # Ok::<(), glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LineChart {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// From left to right.
    pub x: Axis,
    /// From bottom to top.
    pub y: Axis,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Values of x that are marked.
    pub marks: Vec<LineMark>,
    /// The language of the numbers.
    pub lang: Lang,
}

impl Figure for LineChart {
    fn layout(&self, size: Option<(f64, f64)>) -> Page {
        let [left, top, right, bottom] = MARGIN;
        let names = legend::width(&self.curves);
        let beside = if names > 0.0 { names + 28.0 } else { 0.0 };
        let area = size.map_or(AREA, |(width, height)| {
            ((width - left - beside - right).max(LEAST.0), (height - top - bottom).max(LEAST.1))
        });
        let height = area.1.max(legend::height(&self.curves));
        let width = left + area.0 + beside + right;
        let mut page = Page::new(width.ceil() as u32, (top + height + bottom) as u32);
        heading(&mut page, left, &self.title, &self.subtitle);
        let rect = Rect { x: left, y: top, width: area.0, height };
        self.draw(&mut page, rect);
        legend::draw(&mut page, (rect.right() + 24.0, rect.y + 12.0), &self.curves);
        page
    }

    fn data(&self) -> PlotData {
        PlotData::new(&self.title, &self.subtitle, vec![self.panel("")])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

impl LineChart {
    fn panel(&self, title: &str) -> DataPanel {
        panel(title, &self.x.label, &self.y.label, &self.curves)
    }

    fn draw(&self, page: &mut Page, rect: Rect) {
        let axes = Axes { rect, x: self.x.clone(), y: self.y.clone(), gap: 0.0 };
        axes.grid(page);
        let mut taken: Vec<(f64, usize)> = Vec::new();
        for mark in &self.marks {
            let (x, top) = axes.at(mark.x, axes.y.range.1);
            page.dashes(&[(x, top), (x, rect.bottom())], mark.color, 1.2, (5.0, 4.0));
            // Labels of near marks stand above each other.
            let row = (0..).find(|row| taken.iter().all(|(at, own)| own != row || (at - x).abs() > 90.0));
            let row = row.unwrap_or(0);
            taken.push((x, row));
            let at = (x, top - 7.0 - 15.0 * row as f64);
            page.text(&mark.label, at, Anchor::Middle, NUMBER - 1.0, mark.color);
        }
        for curve in &self.curves {
            for run in runs(&curve.points, &axes.y) {
                let points: Vec<_> = run.iter().map(|(x, y)| axes.at(*x, *y)).collect();
                curve.stroke(page, &points, 2.4);
            }
        }
        axes.frame(page);
    }
}

/// Charts side by side under one title, each with its own title and its legend below it.
#[derive(Clone, Debug, PartialEq)]
pub struct SideBySide {
    /// The title of all.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// The charts; their subtitles are not shown.
    pub charts: Vec<LineChart>,
    /// The language of the numbers.
    pub lang: Lang,
}

impl Figure for SideBySide {
    fn layout(&self, size: Option<(f64, f64)>) -> Page {
        let [left, top, right, bottom] = MARGIN;
        let top = top + 30.0;
        let names = self.charts.iter().map(|chart| legend::height(&chart.curves)).fold(0.0, f64::max);
        let count = self.charts.len().max(1) as f64;
        let panel = size.map_or(PANEL, |(width, height)| {
            let (width, height) =
                ((width - right) / count - left - 16.0, height - top - bottom - names - 20.0);
            // Below this, the labels of the axes would touch each other.
            (width.max(PANEL.0), height.max(LEAST.1))
        });
        let step = left + panel.0 + 16.0;
        let width = step * self.charts.len() as f64 + right;
        let mut page = Page::new(width as u32, (top + panel.1 + bottom + names + 20.0) as u32);
        heading(&mut page, left, &self.title, &self.subtitle);
        for (index, chart) in self.charts.iter().enumerate() {
            let rect = Rect { x: left + step * index as f64, y: top, width: panel.0, height: panel.1 };
            page.text(&chart.title, (rect.x, rect.y - 12.0), Anchor::Start, LABEL, INK);
            chart.draw(&mut page, rect);
            legend::draw(&mut page, (rect.x, rect.bottom() + bottom + 4.0), &chart.curves);
        }
        page
    }

    fn data(&self) -> PlotData {
        let panels = self.charts.iter().map(|chart| chart.panel(&chart.title)).collect();
        PlotData::new(&self.title, &self.subtitle, panels)
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

/// The pieces of a curve that can be drawn: between values that are not finite, that a logarithmic axis does not
/// have, or that lie beyond the upper end. Of the latter one remains on each side, at the edge.
pub(crate) fn runs(points: &[(f64, f64)], axis: &Axis) -> Vec<Vec<(f64, f64)>> {
    let beyond = |index: usize| points.get(index).is_none_or(|(_, y)| *y > axis.range.1);
    let drawn = |index: usize| {
        let y = points[index].1;
        let hidden = beyond(index) && beyond(index.wrapping_sub(1)) && beyond(index + 1);
        y.is_finite() && (!axis.log || y >= axis.range.0) && !hidden
    };
    let mut runs = vec![Vec::new()];
    for (index, point) in points.iter().enumerate() {
        match drawn(index) {
            true => runs.last_mut().expect("begins with one run").push(*point),
            false => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| run.len() > 1);
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_broken_where_it_has_no_value() {
        let points = [(0.0, 1.0), (1.0, 1.0), (2.0, f64::NAN), (3.0, 0.0), (4.0, 1.0), (5.0, 2.0)];
        let lengths = |axis: &Axis| runs(&points, axis).iter().map(Vec::len).collect::<Vec<_>>();
        assert_eq!(lengths(&Axis::exact("", (0.0, 2.0), 4)), [2, 3]);
        assert_eq!(lengths(&Axis::decades("", (-2, 1))), [2, 2]);
    }
}
