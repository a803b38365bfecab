//! Charts over wavelength: what spectra, cones and basis functions have in common.

use super::axes::{Axes, Axis};
use super::band;
use super::curve::{Curve, extent, panel};
use super::heading::heading;
use super::legend;
use crate::data::PlotData;
use crate::page::style::{GRAY, INK, NUMBER};
use crate::page::{Anchor, Figure, Page, Rect};
use crate::words::{Lang, Word};

/// The size of the page in points.
const SIZE: (u32, u32) = (1040, 620);
/// The least width of the values, and height of the page.
const LEAST: (f64, f64) = (240.0, 320.0);
/// The width of a column of names to the right of the curves.
const LEGEND: f64 = 200.0;
/// From one name to the next below it.
const NAME: f64 = 24.0;
/// Names longer than this are cut.
const LONGEST_NAME: usize = 26;

/// A wavelength that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Marked {
    /// The wavelength in nm.
    pub nm: f64,
    /// What stands above it.
    pub label: String,
}

/// Curves over wavelength; a curve that is alone is filled with the colours of the spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct WavelengthChart {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// What the values are, with their unit.
    pub label: String,
    /// The wavelengths shown, in nm.
    pub range_nm: (f64, f64),
    /// The curves.
    pub curves: Vec<Curve>,
    /// Wavelengths that are marked.
    pub marked: Vec<Marked>,
    /// The language of the axis of wavelengths.
    pub lang: Lang,
}

impl Figure for WavelengthChart {
    fn layout(&self, size: Option<(f64, f64)>) -> Page {
        let size = size.unwrap_or((f64::from(SIZE.0), f64::from(SIZE.1)));
        let alone = self.curves.len() == 1;
        let legend = if alone { 28.0 } else { LEGEND };
        // Names of many curves need more height.
        let height = size.1.max(LEAST.1).max(150.0 + NAME * self.curves.len() as f64);
        let width = (size.0 - 96.0 - legend).max(LEAST.0);
        let mut page = Page::new((width + 96.0 + legend) as u32, height as u32);
        let rect = Rect { x: 96.0, y: 96.0, width, height: height - 96.0 - 84.0 };
        heading(&mut page, rect.x, &self.title, &self.subtitle);
        let axes = self.axes(rect);
        if let ([curve], true) = (self.curves.as_slice(), alone) {
            band::under(&mut page, &axes, |nm| value_at(&curve.points, nm));
        }
        draw(&mut page, &axes, &self.curves, self.lang);
        for marked in &self.marked {
            let (x, top) = axes.at(marked.nm, axes.y.range.1);
            page.dashes(&[(x, top), (x, rect.bottom())], INK, 1.4, (5.0, 4.0));
            page.text(&marked.label, (x, top - 7.0), Anchor::Middle, NUMBER, INK);
        }
        if !alone {
            names(&mut page, (rect.right() + 22.0, rect.y + 12.0), &self.curves);
        }
        page
    }

    fn data(&self) -> PlotData {
        let x = self.lang.say(Word::Wavelength, &[]);
        PlotData::new(&self.title, &self.subtitle, vec![panel("", &x, &self.label, &self.curves)])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

impl WavelengthChart {
    fn axes(&self, rect: Rect) -> Axes {
        // Numbers of wavelengths need about 60 points each.
        let about = ((rect.width / 60.0) as usize).clamp(2, 10);
        let x = Axis::exact(self.lang.say(Word::Wavelength, &[]), self.range_nm, about);
        Axes { rect, x, y: Axis::round(&self.label, extent(&self.curves), 6), gap: band::HEIGHT }
    }
}

/// Draws curves over wavelength in these axes, with the band of the spectrum.
pub(crate) fn draw(page: &mut Page, axes: &Axes, curves: &[Curve], lang: Lang) {
    axes.grid(page);
    if axes.y.range.0 < 0.0 {
        let zero = [axes.at(axes.x.range.0, 0.0), axes.at(axes.x.range.1, 0.0)];
        page.line(zero, GRAY, 1.2);
    }
    band::below(page, axes, lang);
    for curve in curves {
        let shown = curve.points.iter().filter(|(nm, _)| (axes.x.range.0..=axes.x.range.1).contains(nm));
        let points: Vec<_> = shown.map(|(nm, value)| axes.at(*nm, *value)).collect();
        match curve.dash {
            Some(dash) => page.dashes(&points, curve.color, 2.4, dash),
            None => page.line(points, curve.color, 2.4),
        }
    }
    axes.frame(page);
}

/// The legend of curves over wavelength, with long names shortened.
pub(crate) fn names(page: &mut Page, at: (f64, f64), curves: &[Curve]) {
    let shortened = |curve: &Curve| {
        let mut name: String = curve.name.chars().take(LONGEST_NAME).collect();
        if curve.name.chars().nth(LONGEST_NAME).is_some() {
            name.push('…');
        }
        Curve { name, points: Vec::new(), ..*curve }
    };
    legend::draw(page, at, &curves.iter().map(shortened).collect::<Vec<_>>());
}

/// The value at a wavelength, linear between points; 0 outside of them.
fn value_at(points: &[(f64, f64)], nm: f64) -> f64 {
    let after = points.partition_point(|point| point.0 < nm);
    match (points.get(after.wrapping_sub(1)), points.get(after)) {
        (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (nm - a.0) / (b.0 - a.0),
        (None, Some(first)) if first.0 == nm => first.1,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_between_points_are_linear_and_outside_there_are_none() {
        let points = [(400.0, 1.0), (410.0, 3.0)];
        for (nm, value) in [(400.0, 1.0), (405.0, 2.0), (410.0, 3.0), (399.0, 0.0), (411.0, 0.0)] {
            assert_eq!(value_at(&points, nm), value, "{nm}");
        }
    }
}
