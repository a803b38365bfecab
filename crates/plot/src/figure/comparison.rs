//! Two reflectances side by side: pictures, slices and polar cuts on one page.

use glanz_picture::compare::heat_color;

use super::polar::Circle;
use super::{PolarChart, RegressionChart};
use crate::Canvas;
use crate::chart::{Curve, heading, panel};
use crate::data::{DataPanel, PlotData};
use crate::number;
use crate::page::style::{GRAY, GRID, INK, LABEL, NUMBER};
use crate::page::{Anchor, Figure, Page, Raster, Rect, letters};
use crate::words::Lang;

/// From the left edge to the first column, where the numbers of axes stand, and so between columns.
const LEFT: f64 = 84.0;
const BETWEEN: f64 = 66.0;
/// From the last column to the right edge.
const RIGHT: f64 = 34.0;
/// The space above the first section.
const TOP: f64 = 92.0;
/// The least width of a column, in points.
const LEAST: f64 = 240.0;
/// The height of the areas of slices, over the width of a column.
const SLICE: f64 = 0.72;
/// The height of a section's heading, and of what stands over each of its columns.
const HEADING: f64 = 54.0;
/// From a column's title down to what it is of.
const TITLE_GAP: f64 = 8.0;
/// From a picture to the next section: the bar of colours and its numbers, and some space.
const BELOW_PICTURE: f64 = 50.0;
/// From the area of a slice to the next section.
const BELOW_SLICE: f64 = 84.0;
/// From the rim of a polar cut to the column's edges, where numbers of angles stand.
const RIM: f64 = 34.0;
/// Below the surface of a polar cut.
const BELOW_POLAR: f64 = 66.0;
/// The height of a bar of colours.
const BAR: f64 = 10.0;

/// Pictures beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureRow {
    /// What stands over them.
    pub heading: String,
    /// One for each column.
    pub pictures: Vec<Canvas>,
    /// What the brightest colour of the last, a map of differences, stands for.
    pub brightest: f64,
}

/// Two reflectances side by side: rows of pictures, slices and polar cuts, in columns of one width. A pixel of a picture
/// is a point of the page.
///
/// ```
/// use glanz_plot::figure::{ComparisonSheet, PictureRow};
/// use glanz_plot::words::Lang;
/// use glanz_plot::{Axis, Canvas, Curve, Figure, RegressionChart};
///
/// let slice = RegressionChart {
///     title: "light at 45°".to_owned(),
///     subtitle: String::new(),
///     x: Axis::exact("θo in °", (-90.0, 90.0), 6),
///     y: Axis::exact("f in 1/sr", (0.0, 1.0), 4),
///     clouds: Vec::new(),
///     lines: vec![Curve { name: "a".to_owned(), points: vec![(-80.0, 0.3), (80.0, 0.3)], color: [0, 0, 0], dash: None }],
///     lang: Lang::En,
/// };
/// let row = PictureRow { heading: "lamps".to_owned(), pictures: vec![Canvas::new(64, 64, [9; 3])], brightest: 10.0 };
/// let sheet = ComparisonSheet {
///     title: "a and b".to_owned(),
///     subtitle: String::new(),
///     columns: vec!["a".to_owned()],
///     rows: vec![row],
///     slices_heading: "slices".to_owned(),
///     slices: vec![slice],
///     cuts_heading: String::new(),
///     cuts: Vec::new(),
///     lang: Lang::En,
/// };
/// assert!(sheet.svg()?.starts_with("<svg"));
/// assert!(sheet.csv().starts_with("curve,θo in °,f in 1/sr\na,-80,0.3\n"));
/// # Ok::<(), glanz_plot::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ComparisonSheet {
    /// What is compared.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// What stands over the columns of pictures.
    pub columns: Vec<String>,
    /// Rows of pictures of one size.
    pub rows: Vec<PictureRow>,
    /// What stands over the slices.
    pub slices_heading: String,
    /// Values over the angle of the detector, a chart for each column. The first one's curves are in the legend.
    pub slices: Vec<RegressionChart>,
    /// What stands over the polar cuts.
    pub cuts_heading: String,
    /// The same about a point, a chart for each column.
    pub cuts: Vec<PolarChart>,
    /// The language of the numbers.
    pub lang: Lang,
}

/// Where columns lie.
#[derive(Clone, Copy)]
struct Columns {
    width: f64,
    picture_height: f64,
}

impl Columns {
    fn left(self, column: usize) -> f64 {
        LEFT + (self.width + BETWEEN) * column as f64
    }
}

impl ComparisonSheet {
    fn columns(&self) -> Columns {
        let size = self.rows.first().and_then(|row| row.pictures.first());
        let (width, height) = size.map_or((0.0, 0.0), |one| (one.width as f64, one.height as f64));
        Columns { width: width.max(LEAST), picture_height: height }
    }

    fn count(&self) -> usize {
        let pictures = self.rows.iter().map(|row| row.pictures.len());
        pictures.chain([self.slices.len(), self.cuts.len()]).max().unwrap_or(1)
    }

    /// A row of pictures from `y` on; gives where it ends.
    fn pictures(&self, page: &mut Page, row: &PictureRow, y: f64) -> f64 {
        let columns = self.columns();
        let top = y + HEADING;
        section(page, &row.heading, y);
        for (column, picture) in row.pictures.iter().enumerate() {
            let (x, name) = (columns.left(column), self.columns.get(column).map_or("", String::as_str));
            page.text(name, (x, top - TITLE_GAP), Anchor::Start, NUMBER, GRAY);
            page.rasters.push(raster(picture, (x, top)));
        }
        if let Some(last) = row.pictures.len().checked_sub(1) {
            let bar = Rect {
                x: columns.left(last),
                y: top + columns.picture_height + 8.0,
                width: row.pictures[last].width as f64,
                height: BAR,
            };
            self.scale(page, bar, row.brightest);
        }
        top + columns.picture_height + BELOW_PICTURE
    }

    /// The bar of colours, with its numbers.
    fn scale(&self, page: &mut Page, bar: Rect, brightest: f64) {
        let cells = bar.width as usize;
        let rgb = (0..cells).flat_map(|x| heat_color(x as f32 / cells.max(2) as f32)).collect();
        page.rasters.push(Raster { rect: bar, columns: cells, rows: 1, rgb });
        for (part, anchor) in [(0.0, Anchor::Start), (0.5, Anchor::Middle), (1.0, Anchor::End)] {
            let at = (bar.x + part * bar.width, bar.bottom() + NUMBER + 1.0);
            page.text(number(part * brightest), at, anchor, NUMBER, GRAY);
        }
    }

    /// The slices from `y` on; gives where they end.
    fn slices(&self, page: &mut Page, y: f64) -> f64 {
        let columns = self.columns();
        section(page, &self.slices_heading, y);
        if let Some(chart) = self.slices.first() {
            let right = columns.left(self.count() - 1) + columns.width;
            key(page, (right, y + 18.0), chart);
        }
        let top = y + HEADING;
        let height = SLICE * columns.width;
        for (column, chart) in self.slices.iter().enumerate() {
            let rect = Rect { x: columns.left(column), y: top, width: columns.width, height };
            page.text(&chart.title, (rect.x, top - TITLE_GAP), Anchor::Start, NUMBER, GRAY);
            chart.draw(page, rect);
        }
        top + height + BELOW_SLICE
    }

    /// The polar cuts from `y` on; gives where they end.
    fn cuts(&self, page: &mut Page, y: f64) -> f64 {
        let columns = self.columns();
        section(page, &self.cuts_heading, y);
        let radius = 0.5 * columns.width - RIM;
        let center = y + HEADING + 26.0 + radius;
        for (column, chart) in self.cuts.iter().enumerate() {
            let x = columns.left(column);
            page.text(&chart.title, (x, y + HEADING - TITLE_GAP), Anchor::Start, NUMBER, GRAY);
            chart.draw(page, Circle { center: (x + 0.5 * columns.width, center), radius });
        }
        center + BELOW_POLAR
    }
}

/// The heading of a section, below a line.
fn section(page: &mut Page, text: &str, y: f64) {
    let right = f64::from(page.width) - RIGHT;
    page.line([(LEFT, y), (right, y)], GRID, 1.2);
    page.text(text, (LEFT, y + 23.0), Anchor::Start, LABEL, INK);
}

/// The names of points and lines in one line that ends at a point.
fn key(page: &mut Page, (right, y): (f64, f64), chart: &RegressionChart) {
    let is_named = |curve: &&Curve| !curve.name.is_empty();
    let clouds = chart.clouds.iter().filter(is_named).map(|curve| (curve, true));
    let all: Vec<_> = chart.lines.iter().filter(is_named).map(|curve| (curve, false)).chain(clouds).collect();
    let mut right = right;
    for (curve, is_cloud) in all.into_iter().rev() {
        let left = right - letters::width(&curve.name, NUMBER);
        page.text(&curve.name, (left, y + 0.36 * NUMBER), Anchor::Start, NUMBER, INK);
        match is_cloud {
            true => page.disc((left - 11.0, y), 3.0, curve.color),
            false => curve.stroke(page, &[(left - 34.0, y), (left - 8.0, y)], 2.8),
        }
        right = left - if is_cloud { 40.0 } else { 60.0 };
    }
}

fn raster(picture: &Canvas, (x, y): (f64, f64)) -> Raster {
    let rect = Rect { x, y, width: picture.width as f64, height: picture.height as f64 };
    let rgb = picture.rgba.chunks(4).flat_map(|code| [code[0], code[1], code[2]]).collect();
    Raster { rect, columns: picture.width, rows: picture.height, rgb }
}

impl Figure for ComparisonSheet {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let columns = self.columns();
        let width = columns.left(self.count() - 1) + columns.width + RIGHT;
        let mut page = Page::new(width.ceil() as u32, 0);
        heading(&mut page, LEFT, &self.title, &self.subtitle);
        let mut y = TOP;
        for row in &self.rows {
            y = self.pictures(&mut page, row, y);
        }
        if !self.slices.is_empty() {
            y = self.slices(&mut page, y);
        }
        if !self.cuts.is_empty() {
            y = self.cuts(&mut page, y);
        }
        page.height = y.ceil() as u32;
        // A pixel of a picture is one of the page.
        page.density = 1;
        page
    }

    fn data(&self) -> PlotData {
        let x = self.slices.first().map_or("", |chart| chart.x.label.as_str());
        let slices = self.slices.iter().map(|chart| DataPanel {
            title: format!("{}, {}", self.slices_heading, chart.title),
            ..panel("", &chart.x.label, &chart.y.label, &chart.all())
        });
        let cuts = self.cuts.iter().map(|chart| DataPanel {
            title: format!("{}, {}", self.cuts_heading, chart.title),
            ..panel("", x, &chart.radius.label, &chart.all())
        });
        PlotData::new(&self.title, &self.subtitle, slices.chain(cuts).collect())
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Axis;

    fn slice(title: &str) -> RegressionChart {
        let curve = |name: &str, y: f64| Curve {
            name: name.to_owned(),
            points: vec![(-60.0, y), (60.0, y)],
            color: [0; 3],
            dash: None,
        };
        RegressionChart {
            title: title.to_owned(),
            subtitle: String::new(),
            x: Axis::exact("angle", (-90.0, 90.0), 6),
            y: Axis::exact("f", (0.0, 1.0), 2),
            clouds: vec![curve("readings", 0.5)],
            lines: vec![curve("a", 0.3), curve("b", 0.4)],
            lang: Lang::En,
        }
    }

    fn cut(title: &str) -> PolarChart {
        PolarChart {
            title: title.to_owned(),
            subtitle: String::new(),
            radius: Axis::exact("f cos", (0.0, 1.0), 2),
            curves: slice(title).lines,
            clouds: slice(title).clouds,
            rays: Vec::new(),
            whole: false,
            lang: Lang::En,
        }
    }

    fn sheet() -> ComparisonSheet {
        let row = |heading: &str| PictureRow {
            heading: heading.to_owned(),
            pictures: vec![Canvas::new(260, 260, [7; 3]); 3],
            brightest: 10.0,
        };
        ComparisonSheet {
            title: "t".to_owned(),
            subtitle: String::new(),
            columns: ["a", "b", "difference"].map(str::to_owned).to_vec(),
            rows: vec![row("lamps"), row("studio")],
            slices_heading: "slices".to_owned(),
            slices: ["15", "45", "75"].map(slice).to_vec(),
            cuts_heading: "cuts".to_owned(),
            cuts: ["15", "45", "75"].map(cut).to_vec(),
            lang: Lang::En,
        }
    }

    #[test]
    fn everything_lies_on_the_page_and_pictures_above_slices() {
        let page = sheet().page();
        let (width, height) = (f64::from(page.width), f64::from(page.height));
        let inside = |rect: &Rect| rect.x >= 0.0 && rect.right() <= width && rect.bottom() <= height;
        assert!(page.rasters.len() == 8 && page.rasters.iter().all(|raster| inside(&raster.rect)));
        for text in page.texts() {
            assert!((0.0..=width).contains(&text.at.0) && (0.0..=height).contains(&text.at.1), "{text:?}");
        }
        let y_of = |word: &str| page.texts().find(|text| text.text == word).map(|text| text.at.1);
        assert!(
            y_of("studio") > y_of("lamps")
                && y_of("slices") > y_of("studio")
                && y_of("cuts") > y_of("slices")
        );
        // Areas of slices begin where pictures do.
        let lefts: Vec<f64> = page.rasters.iter().map(|raster| raster.rect.x).take(3).collect();
        let titles = page.texts().filter(|text| text.text == "15" || text.text == "75");
        assert!(titles.map(|text| text.at.0).all(|x| lefts.contains(&x)));
    }

    #[test]
    fn the_numbers_of_all_charts_come_out() {
        let data = sheet().data();
        assert_eq!(data.panels.len(), 6);
        assert_eq!(data.panels[5].title, "cuts, 75");
        let names: Vec<&str> = data.panels[0].curves.iter().map(|curve| curve.name.as_str()).collect();
        assert_eq!(names, ["readings", "a", "b"]);
    }
}
