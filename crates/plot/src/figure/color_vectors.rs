//! The colour vector graphic of TM-30: what a light does to colours of each hue.

use core::f64::consts::TAU;

use glanz_color::models::{ColorModel, Oklch, Srgb};
use glanz_color::tm30::{BINS, HueBin, Rendition};

use crate::chart::{Axes, Axis, heading};
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{GRAY, INK, LABEL, NUMBER, Rgb8, WHITE};
use crate::page::{Anchor, Figure, Page, Raster, Rect};
use crate::words::{Lang, Word};

/// The colour vector graphic of ANSI/IES TM-30-20, with local fidelity and shifts of chroma and hue beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorVectors {
    /// The light's name.
    pub name: String,
    /// How it shows colours.
    pub rendition: Rendition,
    /// The language of the words.
    pub lang: Lang,
}

/// Where the graphic lies.
const GRAPHIC: Rect = Rect { x: 40.0, y: 96.0, width: 560.0, height: 560.0 };

/// Half the width of the graphic, where the reference is a circle of radius 1.
const REACH: f64 = 1.5;

/// Cells along a side of the ground.
const CELLS: usize = 280;

/// The circle of the reference.
const BLACK: Rgb8 = [0; 3];
/// The outline of the light.
const RED: Rgb8 = [0xd8, 0x1e, 0x1e];

impl Figure for ColorVectors {
    /// Of one size: the graphic is a square beside three panels.
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let mut page = Page::new(1180, 700);
        heading(&mut page, GRAPHIC.x, &self.name, &self.lang.say(Word::ColorVectorGraphic, &[]));
        page.rasters.push(ground());
        graphic(&mut page, &self.rendition);
        corners(&mut page, &self.rendition);
        bars(&mut page, &self.rendition, self.lang);
        page
    }

    fn data(&self) -> PlotData {
        let columns = ["hue bin", "Rf,h", "Rcs,h in %", "Rhs,h", "x", "y"].map(str::to_owned).to_vec();
        let bins = self.rendition.bins.iter().enumerate();
        let points = bins.map(|(i, bin)| {
            let [x, y] = bin.vector;
            vec![(i + 1) as f64, bin.fidelity, 100.0 * bin.chroma_shift, bin.hue_shift, x, y]
        });
        let curves = vec![DataCurve { name: self.name.clone(), points: points.collect() }];
        let panel = DataPanel { title: String::new(), columns, curves };
        PlotData::new(self.name.clone(), self.lang.say(Word::ColorVectorGraphic, &[]), vec![panel])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

/// A point of the graphic on the page.
fn at([x, y]: [f64; 2]) -> (f64, f64) {
    let scale = GRAPHIC.width / (2.0 * REACH);
    (GRAPHIC.x + scale * (x + REACH), GRAPHIC.y + scale * (REACH - y))
}

/// The point at a hue and a distance from the middle.
fn polar(radius: f64, turn: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(turn);
    [radius * cos, radius * sin]
}

fn circle(radius: f64) -> impl Iterator<Item = (f64, f64)> {
    (0..=180).map(move |i| at(polar(radius, TAU * f64::from(i) / 180.0)))
}

/// Pale hues behind the graphic; those of OKLab lie within some degrees of CAM02-UCS's.
fn ground() -> Raster {
    let position = |cell: usize| REACH * (2.0 * (cell as f64 + 0.5) / CELLS as f64 - 1.0);
    let color = |row: usize, column: usize| {
        let (x, y) = (position(column), -position(row));
        let radius = libm::hypot(x, y).min(REACH);
        hue_color(libm::atan2(y, x), 0.9, 0.055 * radius)
    };
    let rgb = (0..CELLS).flat_map(|row| (0..CELLS).flat_map(move |column| color(row, column))).collect();
    Raster { rect: GRAPHIC, columns: CELLS, rows: CELLS, rgb }
}

fn hue_color(turn: f64, lightness: f64, chroma: f64) -> Rgb8 {
    let hue = turn.to_degrees().rem_euclid(360.0);
    let Srgb(rgb) = Oklch([lightness, chroma, hue]).to();
    rgb.map(|c| (255.0 * c.clamp(0.0, 1.0)).round() as u8)
}

fn graphic(page: &mut Page, rendition: &Rendition) {
    for bin in 0..BINS {
        let turn = TAU * bin as f64 / BINS as f64;
        page.dashes(&[at([0.0; 2]), at(polar(REACH, turn))], GRAY, 0.6, (3.0, 3.0));
        let (x, y) = at(polar(1.4, HueBin::middle_deg(bin).to_radians()));
        page.text(format!("{}", bin + 1), (x, y + 0.36 * NUMBER), Anchor::Middle, NUMBER, GRAY);
    }
    for tenths in [8, 9, 11, 12] {
        page.line(circle(f64::from(tenths) / 10.0), WHITE, 1.4);
    }
    let (x, y) = at([0.0, -0.8]);
    page.text("-20%", (x, y - 4.0), Anchor::Middle, NUMBER, GRAY);
    let (x, y) = at([0.0, -1.2]);
    page.text("+20%", (x, y + NUMBER), Anchor::Middle, NUMBER, GRAY);
    page.line(circle(1.0), BLACK, 2.4);
    let outline = (0..=BINS).map(|i| at(rendition.bins[i % BINS].vector));
    page.line(outline, RED, 2.8);
    for (i, bin) in rendition.bins.iter().enumerate() {
        let turn = HueBin::middle_deg(i).to_radians();
        arrow(page, at(polar(1.0, turn)), at(bin.vector), hue_color(turn, 0.5, 0.11));
    }
    page.outline(GRAPHIC, GRAY, 1.0);
}

/// An arrow with a head of a size of its own.
fn arrow(page: &mut Page, from: (f64, f64), to: (f64, f64), color: Rgb8) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = libm::hypot(dx, dy);
    if length < 1.0 {
        return;
    }
    let (x, y) = (dx / length, dy / length);
    let head = length.min(11.0);
    let neck = (to.0 - head * x, to.1 - head * y);
    page.line([from, neck], color, 3.0);
    let half = 0.45 * head;
    page.area([to, (neck.0 - half * y, neck.1 + half * x), (neck.0 + half * y, neck.1 - half * x)], color);
}

/// The indices in the corners of the graphic.
fn corners(page: &mut Page, rendition: &Rendition) {
    let (left, right) = (GRAPHIC.x + 12.0, GRAPHIC.right() - 12.0);
    let (top, bottom) = (GRAPHIC.y + 34.0, GRAPHIC.bottom() - 14.0);
    let mut corner = |text: String, label: &str, at: (f64, f64), anchor| {
        page.text(text, at, anchor, 28.0, INK);
        page.text(label, (at.0, at.1 + 18.0), anchor, NUMBER, INK);
    };
    corner(format!("{:.0}", rendition.rf), "Rf", (left, top), Anchor::Start);
    let gamut = if rendition.rg.is_finite() { format!("{:.0}", rendition.rg) } else { "–".to_owned() };
    corner(gamut, "Rg", (right, top), Anchor::End);
    corner(format!("{:.0} K", rendition.temperature.cct_k), "CCT", (left, bottom - 18.0), Anchor::Start);
    corner(format!("{:+.4}", rendition.temperature.duv), "Duv", (right, bottom - 18.0), Anchor::End);
}

/// Local fidelity and shifts over the bins.
fn bars(page: &mut Page, rendition: &Rendition, lang: Lang) {
    let of = |value: fn(&HueBin) -> f64| rendition.bins.each_ref().map(value);
    let panels = [
        (lang.say(Word::LocalFidelity, &[]), of(|bin| bin.fidelity), (0.0, 100.0)),
        (lang.say(Word::ChromaShift, &[]), of(|bin| 100.0 * bin.chroma_shift), (-40.0, 40.0)),
        (lang.say(Word::HueShift, &[]), of(|bin| bin.hue_shift), (-0.5, 0.5)),
    ];
    for (row, (label, values, range)) in panels.into_iter().enumerate() {
        let rect = Rect { x: 690.0, y: 108.0 + 197.0 * row as f64, width: 450.0, height: 142.0 };
        page.text(&*label, (rect.x, rect.y - 8.0), Anchor::Start, LABEL, INK);
        panel(page, rect, &values, range);
    }
}

/// One bar per bin; a range that is too small grows with the values.
fn panel(page: &mut Page, rect: Rect, values: &[f64; BINS], range: (f64, f64)) {
    let most = values.iter().fold(range.1, |most, value| most.max(value.abs()));
    let low = if range.0 < 0.0 { -most } else { range.0 };
    let x = Axis { ticks: Vec::new(), ..Axis::exact("", (0.0, BINS as f64), 2) };
    let axes = Axes { rect, x, y: Axis::round("", (low, most), 5), gap: 0.0 };
    axes.frame(page);
    for (bin, value) in values.iter().enumerate() {
        let (left, right) = (bin as f64 + 0.12, bin as f64 + 0.88);
        let corners = [(left, 0.0), (left, *value), (right, *value), (right, 0.0)];
        let color = hue_color(HueBin::middle_deg(bin).to_radians(), 0.68, 0.12);
        page.area(corners.map(|(x, y)| axes.at(x, y)), color);
        let (x, _) = axes.at(bin as f64 + 0.5, 0.0);
        let below = (x, rect.bottom() + 15.0);
        page.text(format!("{}", bin + 1), below, Anchor::Middle, 11.0, GRAY);
    }
    page.line([axes.at(0.0, 0.0), axes.at(BINS as f64, 0.0)], GRAY, 1.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use glanz_color::fine_light;
    use glanz_color::tm30::evaluate;

    #[test]
    fn a_dull_lamp_draws_inside_of_the_circle_at_red() {
        let rendition = evaluate(&fine_light("FL2").unwrap()).unwrap();
        let figure = ColorVectors { name: "FL2".to_owned(), rendition, lang: Lang::En };
        let page = figure.page();
        let texts: Vec<_> = page.texts().map(|text| text.text.as_str()).collect();
        assert!(texts.contains(&"70") && texts.contains(&"86") && texts.contains(&"+0.0018"), "{texts:?}");
        let [x, y] = figure.rendition.bins[0].vector;
        assert!(libm::hypot(x, y) < 0.8);
        let ([left, top], (px, py)) = ([GRAPHIC.x, GRAPHIC.y], at([x, y]));
        assert!(px > left + 0.5 * GRAPHIC.width && py > top && py < GRAPHIC.bottom());
        assert_eq!(figure.svg().unwrap(), figure.svg().unwrap());
    }
}
