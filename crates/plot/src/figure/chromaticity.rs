//! The chromaticity diagram of CIE 1931.

use glanz_color::chromaticity::Chromaticity;
use glanz_color::dominant::locus;
use glanz_color::models::RgbSpace;
use glanz_color::temperature::planckian;

use crate::chart::{Axes, Axis, heading};
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{GRAY, INK, NUMBER, Rgb8, WHITE};
use crate::page::{Anchor, Figure, Page, Raster, Rect, letters};
use crate::words::{Lang, Word};

/// The size of the page in points; values of x and y have the same scale.
const SIZE: (u32, u32) = (860, 920);
/// The values of x and y shown.
const RANGE: ((f64, f64), (f64, f64)) = ((-0.05, 0.8), (0.0, 0.9));
/// Cells of the colours per point.
const CELLS: f64 = 2.0;
/// The first wavelength of the locus, in nm.
const LOCUS_FROM_NM: usize = 380;

/// A colour that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What it is called.
    pub name: String,
    /// Where it lies.
    pub xy: Chromaticity,
}

/// A space whose triangle is drawn.
struct Gamut {
    name: &'static str,
    space: RgbSpace,
    color: Rgb8,
    dash: Option<(f64, f64)>,
}

const GAMUTS: [Gamut; 3] = [
    Gamut { name: "sRGB, BT.709", space: RgbSpace::SRGB, color: INK, dash: None },
    Gamut { name: "Display P3", space: RgbSpace::DISPLAY_P3, color: INK, dash: Some((9.0, 5.0)) },
    Gamut { name: "Rec. 2020", space: RgbSpace::REC2020, color: INK, dash: Some((2.5, 4.0)) },
];

/// Black bodies that are marked, in K.
const TEMPERATURES_K: [f64; 5] = [2000.0, 3000.0, 4000.0, 6500.0, 10_000.0];

/// The chromaticity diagram of CIE 1931 with the gamuts of displays, black bodies and marked colours.
///
/// ```
/// use glanz_plot::{ChromaticityDiagram, Figure};
///
/// let diagram = ChromaticityDiagram::default();
/// assert!(diagram.svg()?.contains("Chromaticity, CIE 1931"));
/// # Ok::<(), glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ChromaticityDiagram {
    /// What is seen.
    pub title: String,
    /// The colours that are marked.
    pub marks: Vec<Mark>,
    /// The language of the words.
    pub lang: Lang,
}

impl Default for ChromaticityDiagram {
    fn default() -> Self {
        Self::new(Vec::new(), Lang::En)
    }
}

impl ChromaticityDiagram {
    /// The diagram with these colours marked.
    pub fn new(marks: Vec<Mark>, lang: Lang) -> Self {
        Self { title: lang.say(Word::Chromaticity, &[]), marks, lang }
    }
}

impl Figure for ChromaticityDiagram {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let mut page = Page::new(SIZE.0, SIZE.1);
        let (x, y) = RANGE;
        let rect = Rect { x: 84.0, y: 88.0, width: 720.0, height: 720.0 * (y.1 - y.0) / (x.1 - x.0) };
        let axes = Axes { rect, x: Axis::exact("x", x, 9), y: Axis::exact("y", y, 9), gap: 0.0 };
        heading(&mut page, rect.x, &self.title, &self.lang.say(Word::ChromaticityAxes, &[]));
        page.rasters.push(colors(&axes));
        axes.grid(&mut page);
        border(&mut page, &axes);
        gamuts(&mut page, &axes);
        let mut taken = Vec::new();
        black_bodies(&mut page, &axes, &mut taken);
        for mark in &self.marks {
            let at = axes.at(mark.xy.x, mark.xy.y);
            page.disc(at, 6.0, WHITE);
            page.disc(at, 4.5, INK);
            taken.push(Rect { x: at.0 - 6.0, y: at.1 - 6.0, width: 12.0, height: 12.0 });
        }
        for mark in &self.marks {
            label(&mut page, &mut taken, axes.at(mark.xy.x, mark.xy.y), &mark.name, NUMBER);
        }
        axes.frame(&mut page);
        page
    }

    fn data(&self) -> PlotData {
        let panels =
            vec![locus_data(self.lang), black_body_data(self.lang), gamut_data(self.lang), self.marked()];
        PlotData::new(&self.title, self.lang.say(Word::ChromaticityAxes, &[]), panels)
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

impl ChromaticityDiagram {
    fn marked(&self) -> DataPanel {
        let mark = |mark: &Mark| DataCurve::of_pairs(&mark.name, [(mark.xy.x, mark.xy.y)]);
        let curves = self.marks.iter().map(mark).collect();
        DataPanel {
            title: self.lang.say(Word::Marks, &[]),
            columns: vec!["x".to_owned(), "y".to_owned()],
            curves,
        }
    }
}

/// A panel of one curve of chromaticities over something.
fn one_curve(title: String, over: String, points: impl Iterator<Item = (f64, Chromaticity)>) -> DataPanel {
    let points = points.map(|(value, xy)| vec![value, xy.x, xy.y]).collect();
    let curves = vec![DataCurve { name: title.clone(), points }];
    DataPanel { title, columns: vec![over, "x".to_owned(), "y".to_owned()], curves }
}

fn locus_data(lang: Lang) -> DataPanel {
    let points = locus().iter().enumerate().map(|(index, xy)| ((LOCUS_FROM_NM + index) as f64, *xy));
    one_curve(lang.say(Word::Locus, &[]), lang.say(Word::Wavelength, &[]), points)
}

fn black_body_data(lang: Lang) -> DataPanel {
    let points = kelvins().filter_map(|kelvin| Some((kelvin, planckian(kelvin)?)));
    one_curve(lang.say(Word::BlackBodies, &[]), lang.say(Word::Temperature, &[]), points)
}

fn gamut_data(lang: Lang) -> DataPanel {
    let curve = |gamut: &Gamut| DataCurve::of_pairs(gamut.name, gamut.space.primaries.map(|[x, y]| (x, y)));
    let columns = vec!["x".to_owned(), "y".to_owned()];
    DataPanel { title: lang.say(Word::Gamuts, &[]), columns, curves: GAMUTS.iter().map(curve).collect() }
}

/// Temperatures in K by even steps of the reciprocal, for the curve runs evenly along it: 1000 K to 1e6 K.
fn kelvins() -> impl Iterator<Item = f64> {
    (0..=120).map(|i| 1e6 / (1.0 + 999.0 * (1.0 - f64::from(i) / 120.0)))
}

/// The colours within the border, as bright as a screen can; to those that it cannot show white is added
/// until it can.
fn colors(axes: &Axes) -> Raster {
    let rect = axes.rect;
    let (columns, rows) = ((rect.width * CELLS) as usize, (rect.height * CELLS) as usize);
    let mut rgb = vec![0xff; 3 * columns * rows];
    let (low, high) = axes.x.range;
    for row in 0..rows {
        let y = axes.y.range.1 - (row as f64 + 0.5) / rows as f64 * (axes.y.range.1 - axes.y.range.0);
        let crossings = crossings(y);
        for column in 0..columns {
            let x = low + (column as f64 + 0.5) / columns as f64 * (high - low);
            if crossings.iter().filter(|crossing| x < **crossing).count() % 2 == 1 {
                let at = 3 * (row * columns + column);
                rgb[at..at + 3].copy_from_slice(&color(Chromaticity::new(x, y)));
            }
        }
    }
    Raster { rect, columns, rows, rgb }
}

fn color(xy: Chromaticity) -> Rgb8 {
    let light = RgbSpace::SRGB.from_xyz_matrix().apply(xy.xyz());
    let least = light.into_iter().fold(0.0, f64::min);
    let light = light.map(|c| c - least);
    let most = light.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    light.map(|c| (255.0 * RgbSpace::SRGB.transfer.encode(c / most)).round() as u8)
}

/// The x at which the border of all colours, the locus and the purples, has this y. A point is inside if
/// an odd number of them lies to its right.
fn crossings(y: f64) -> Vec<f64> {
    let locus = locus();
    let pieces = (0..locus.len()).map(|i| (locus[i], locus[(i + 1) % locus.len()]));
    let spanning = pieces.filter(|(a, b)| (a.y > y) != (b.y > y));
    spanning.map(|(a, b)| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)).collect()
}

/// The locus with its wavelengths, and the purples.
fn border(page: &mut Page, axes: &Axes) {
    let points: Vec<_> = locus().iter().map(|xy| axes.at(xy.x, xy.y)).collect();
    let (first, last) = (points[0], points[points.len() - 1]);
    page.line([first, last], GRAY, 1.4);
    page.line(points.iter().copied(), INK, 2.2);
    for nm in (460..=640).step_by(10) {
        let index = nm - LOCUS_FROM_NM;
        let (before, at, after) = (points[index - 1], points[index], points[index + 1]);
        let along = (after.0 - before.0, after.1 - before.1);
        let length = libm::hypot(along.0, along.1);
        // Along the locus of growing wavelengths the outside is to the left on the page.
        let out = (along.1 / length, -along.0 / length);
        page.line([at, (at.0 + 7.0 * out.0, at.1 + 7.0 * out.1)], INK, 1.6);
        if let Some(label) = label_of(nm) {
            let anchor = if out.0 < -0.4 {
                Anchor::End
            } else if out.0 > 0.4 {
                Anchor::Start
            } else {
                Anchor::Middle
            };
            let point = (at.0 + 11.0 * out.0, at.1 + 14.0 * out.1 + 0.36 * NUMBER);
            page.text(label, point, anchor, NUMBER, INK);
        }
    }
}

/// The number at a wavelength, where it does not crowd others.
fn label_of(nm: usize) -> Option<String> {
    let crowded = nm > 620 && nm != 640 || nm == 610;
    (!crowded).then(|| nm.to_string())
}

fn gamuts(page: &mut Page, axes: &Axes) {
    let (x, y) = (axes.rect.right() - 190.0, axes.rect.y + 26.0);
    for (index, gamut) in GAMUTS.iter().enumerate() {
        let [r, g, b] = gamut.space.primaries.map(|[x, y]| axes.at(x, y));
        let y = y + 24.0 * index as f64;
        for line in [vec![r, g, b, r], vec![(x, y), (x + 30.0, y)]] {
            match gamut.dash {
                Some(dash) => page.dashes(&line, gamut.color, 1.8, dash),
                None => page.line(line, gamut.color, 1.8),
            }
        }
        page.text(gamut.name, (x + 40.0, y + 0.36 * NUMBER), Anchor::Start, NUMBER, INK);
    }
}

fn black_bodies(page: &mut Page, axes: &Axes, taken: &mut Vec<Rect>) {
    let curve = kelvins().filter_map(planckian).map(|xy| axes.at(xy.x, xy.y));
    page.line(curve, INK, 1.6);
    for kelvin in TEMPERATURES_K {
        let Some(xy) = planckian(kelvin) else { continue };
        let at = axes.at(xy.x, xy.y);
        page.disc(at, 3.2, INK);
        label(page, taken, at, &kelvin.to_string(), NUMBER - 1.5);
    }
}

/// The farthest that a label may stand from its point, in points of the page.
const FARTHEST: f64 = 200.0;

/// Writes a label beside a point, where it covers no other: above, below, to the left or to the right, else on
/// the smallest circle with space for it, with a line to its point.
fn label(page: &mut Page, taken: &mut Vec<Rect>, at: (f64, f64), text: &str, size: f64) {
    let (width, height) = (letters::width(text, size), 0.9 * size);
    let place = |x: f64, y: f64| Rect { x: at.0 + x, y: at.1 + y, width, height };
    let places = [
        place(-0.5 * width, -9.0 - height),
        place(-0.5 * width, 9.0),
        place(-10.0 - width, -0.25 * height),
        place(10.0, -0.25 * height),
        place(10.0, 4.0),
        place(10.0, -4.0 - height),
    ];
    let is_free = |place: &Rect| {
        taken.iter().all(|other| {
            place.x > other.right()
                || other.x > place.right()
                || place.y > other.bottom()
                || other.y > place.bottom()
        })
    };
    let near = places.into_iter().find(is_free);
    let place = near.or_else(|| far_places(at, (width, height)).find(is_free)).unwrap_or(places[0]);
    if near.is_none() {
        let end = (at.0.clamp(place.x, place.right()), at.1.clamp(place.y, place.bottom()));
        page.line([at, end], GRAY, 1.0);
    }
    page.text(text, (place.x, place.bottom() - 0.1 * size), Anchor::Start, size, INK);
    taken.push(place);
}

/// Places for a label of this size on growing circles around a point.
fn far_places(at: (f64, f64), (width, height): (f64, f64)) -> impl Iterator<Item = Rect> {
    let circles = (0..).map(|i| 24.0 + 8.0 * f64::from(i)).take_while(|radius| *radius <= FARTHEST);
    circles.flat_map(move |radius| {
        (0..24).map(move |step| {
            let angle = f64::from(step) * core::f64::consts::TAU / 24.0;
            let middle = (at.0 + radius * libm::cos(angle), at.1 + radius * libm::sin(angle));
            Rect { x: middle.0 - 0.5 * width, y: middle.1 - 0.5 * height, width, height }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_inside_and_the_corners_are_not() {
        let is_inside =
            |x: f64, y: f64| crossings(y).iter().filter(|crossing| x < **crossing).count() % 2 == 1;
        assert!(is_inside(1.0 / 3.0, 1.0 / 3.0) && is_inside(0.1, 0.7));
        for (x, y) in [(0.0, 0.0), (0.79, 0.89), (0.5, 0.05), (0.7, 0.4)] {
            assert!(!is_inside(x, y), "{x}, {y}");
        }
    }

    #[test]
    fn labels_of_points_that_lie_close_cover_none_of_each_other() {
        let (mut page, mut taken) = (Page::new(SIZE.0, SIZE.1), Vec::new());
        for index in 0..14 {
            let at = (300.0 + 6.0 * f64::from(index), 400.0 + 2.0 * f64::from(index));
            label(&mut page, &mut taken, at, "FL3.12", NUMBER);
        }
        for (index, a) in taken.iter().enumerate() {
            for b in &taken[index + 1..] {
                let apart = a.x > b.right() || b.x > a.right() || a.y > b.bottom() || b.y > a.bottom();
                assert!(apart, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn the_colours_of_the_diagram_have_the_hues_of_their_places() {
        assert_eq!(color(Chromaticity::new(0.64, 0.33)), [255, 0, 0]);
        let white = color(Chromaticity::new(0.3127, 0.3290));
        assert!(white.iter().all(|c| *c > 253), "{white:?}");
    }
}
