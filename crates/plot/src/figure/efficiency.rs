//! The efficiency of representations: the error of colour over the number of samples.

use crate::chart::{Axes, Axis, heading};
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{CURVES, GRAY, INK, LABEL, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page, Rect, letters};
use crate::words::{Lang, Word};

/// Panels beside each other.
const COLUMNS: usize = 3;
/// The size of a panel with its numbers, in points.
const PANEL: (f64, f64) = (400.0, 330.0);
/// Where panels and names begin.
const LEFT: f64 = 86.0;
/// The first line of names.
const LEGEND_Y: f64 = 98.0;
/// The errors shown, in ΔE00.
const ERRORS: (f64, f64) = (0.02, 50.0);
/// The numbers of samples shown.
const SAMPLES: (f64, f64) = (2.7, 36.0);

/// A representation of spectra by few numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct EfficiencyLine {
    /// What it is called.
    pub name: String,
    /// Numbers of samples and mean errors in ΔE00, in order; a single one is a point.
    pub points: Vec<(usize, f64)>,
}

/// The representations under one light.
#[derive(Clone, Debug, PartialEq)]
pub struct EfficiencyPanel {
    /// The light.
    pub light: String,
    /// The representations, in the same order under all lights.
    pub lines: Vec<EfficiencyLine>,
}

/// The error of colour over the number of samples, with a panel for each light.
#[derive(Clone, Debug, PartialEq)]
pub struct EfficiencyChart {
    /// What is seen.
    pub title: String,
    /// What the errors are means of, in one line.
    pub subtitle: String,
    /// The panels.
    pub lights: Vec<EfficiencyPanel>,
    /// The language of the axes.
    pub lang: Lang,
}

impl Figure for EfficiencyChart {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let columns = self.lights.len().clamp(1, COLUMNS);
        let rows = self.lights.len().div_ceil(columns).max(1);
        let width = 60.0 + columns.max(2) as f64 * PANEL.0;
        let places = places(&self.lights, width);
        let lines = places.last().map_or(0.0, |place| place.1 - LEGEND_Y);
        let top = 156.0 + lines;
        let height = top + rows as f64 * PANEL.1;
        let mut page = Page::new(width as u32, height as u32);
        heading(&mut page, LEFT, &self.title, &self.subtitle);
        legend(&mut page, &self.lights, &places);
        for (index, light) in self.lights.iter().enumerate() {
            let (column, row) = (index % columns, index / columns);
            let rect = Rect {
                x: LEFT + column as f64 * PANEL.0,
                y: top + row as f64 * PANEL.1,
                width: PANEL.0 - 80.0,
                height: PANEL.1 - 88.0,
            };
            panel(&mut page, rect, light, self.lang);
        }
        page
    }

    fn data(&self) -> PlotData {
        let columns =
            || [Word::SampleCount, Word::MeanDifference].map(|word| self.lang.say(word, &[])).to_vec();
        let curve = |line: &EfficiencyLine| {
            let points = line.points.iter().map(|(count, error)| (*count as f64, *error));
            DataCurve::of_pairs(&line.name, points)
        };
        let panel = |light: &EfficiencyPanel| DataPanel {
            title: light.light.clone(),
            columns: columns(),
            curves: light.lines.iter().map(curve).collect(),
        };
        PlotData::new(&self.title, &self.subtitle, self.lights.iter().map(panel).collect())
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

fn color(index: usize) -> Rgb8 {
    CURVES[index % CURVES.len()]
}

/// Where each name begins: beside the one before it, or in a new line where the page ends.
fn places(lights: &[EfficiencyPanel], width: f64) -> Vec<(f64, f64)> {
    let (mut x, mut y) = (LEFT, LEGEND_Y);
    let lines = lights.first().map_or(&[][..], |light| &light.lines);
    let place = |line: &EfficiencyLine| {
        let needed = 34.0 + letters::width(&line.name, NUMBER);
        if x > LEFT && x + needed > width - 20.0 {
            (x, y) = (LEFT, y + 24.0);
        }
        let place = (x, y);
        x += needed + 26.0;
        place
    };
    lines.iter().map(place).collect()
}

fn legend(page: &mut Page, lights: &[EfficiencyPanel], places: &[(f64, f64)]) {
    let lines = lights.first().map_or(&[][..], |light| &light.lines);
    for (index, (line, &(x, y))) in lines.iter().zip(places).enumerate() {
        match line.points.len() {
            1 => page.disc((x + 13.0, y), 5.5, color(index)),
            _ => page.line([(x, y), (x + 26.0, y)], color(index), 2.8),
        }
        page.text(&line.name, (x + 34.0, y + 0.36 * NUMBER), Anchor::Start, NUMBER, INK);
    }
}

fn panel(page: &mut Page, rect: Rect, light: &EfficiencyPanel, lang: Lang) {
    let x =
        Axis::log(lang.say(Word::SampleCount, &[]), SAMPLES, &[3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0]);
    let y = Axis::log(
        lang.say(Word::MeanDifference, &[]),
        ERRORS,
        &[0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0],
    );
    let axes = Axes { rect, x, y, gap: 0.0 };
    page.text(&light.light, (rect.x, rect.y - 9.0), Anchor::Start, LABEL, INK);
    axes.grid(page);
    // What an eye just tells apart, by convention.
    let just = [axes.at(SAMPLES.0, 1.0), axes.at(SAMPLES.1, 1.0)];
    page.dashes(&just, GRAY, 1.4, (5.0, 4.0));
    for (index, line) in light.lines.iter().enumerate() {
        let points: Vec<_> =
            line.points.iter().map(|(count, error)| axes.at(*count as f64, *error)).collect();
        let alone = points.len() == 1;
        for point in &points {
            page.disc(*point, if alone { 5.5 } else { 2.4 }, color(index));
        }
        page.line(points, color(index), 2.0);
    }
    axes.frame(page);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_runs_out_of_the_picture() {
        let line = |name: &str| EfficiencyLine { name: name.to_owned(), points: Vec::new() };
        let names = ["uniform, 300-780 nm", "uniform, 400-700 nm", "sRGB product", "Meyer, published", "M"];
        let light = EfficiencyPanel { light: "E".to_owned(), lines: names.map(line).to_vec() };
        for width in [400.0, 860.0, 1260.0] {
            for ((x, _), name) in places(core::slice::from_ref(&light), width).into_iter().zip(names) {
                assert!(x + 34.0 + letters::width(name, NUMBER) < width, "{name}: {x} of {width}");
            }
        }
    }
}
