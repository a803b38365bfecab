//! Values over half and difference angle in false colours.

use crate::chart::{Axes, Axis, bar, heading, magma};
use crate::data::{DataCurve, DataPanel, PlotData};
use crate::page::style::{INK, LABEL, NUMBER, Rgb8};
use crate::page::{Anchor, Figure, Page, Raster, Rect};
use crate::words::{Lang, Word};

/// The side of a page in points.
const SIDE: f64 = 330.0;
/// Cells along a side: a quarter of a degree.
pub const CELLS: usize = 360;
/// Where there is nothing to show.
const NOTHING: Rgb8 = [0xe6, 0xe8, 0xeb];
/// From page to page.
const STEP: (f64, f64) = (430.0, 450.0);
/// The most panels side by side.
const COLUMNS: usize = 3;
/// The space above and to the left of the first.
const CORNER: (f64, f64) = (92.0, 124.0);

/// The values of one lobe.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// What stands above it.
    pub caption: String,
    /// Values, `CELLS` per row, rows from the top (difference angle 90°) to the bottom; NaN where a direction is
    /// below the surface.
    pub values: Vec<f64>,
}

/// Slices with one scale.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceMaps {
    /// What is seen.
    pub title: String,
    /// More about it, in one line.
    pub subtitle: String,
    /// The values of the colours.
    pub scale: Axis,
    /// The slices.
    pub slices: Vec<Slice>,
    /// The language of the axes.
    pub lang: Lang,
}

impl Figure for SliceMaps {
    fn layout(&self, _size: Option<(f64, f64)>) -> Page {
        let columns = self.slices.len().clamp(1, COLUMNS);
        let rows = self.slices.len().div_ceil(columns);
        let width = CORNER.0 + STEP.0 * columns as f64 + 90.0;
        let height = CORNER.1 + STEP.1 * rows as f64 - 40.0;
        let mut page = Page::new(width.max(640.0) as u32, height as u32);
        heading(&mut page, 40.0, &self.title, &self.subtitle);
        for (index, slice) in self.slices.iter().enumerate() {
            let (row, column) = ((index / columns) as f64, (index % columns) as f64);
            let (x, y) = (CORNER.0 + STEP.0 * column, CORNER.1 + STEP.1 * row);
            self.draw(&mut page, slice, Rect { x, y, width: SIDE, height: SIDE });
        }
        let x = CORNER.0 + STEP.0 * columns as f64 - 60.0;
        let rect = Rect { x, y: CORNER.1, width: 18.0, height: SIDE };
        bar(&mut page, rect, &self.scale);
        page.text(&self.scale.label, (x, CORNER.1 - 12.0), Anchor::Start, NUMBER, INK);
        page
    }

    fn data(&self) -> PlotData {
        let angle = |index: usize| 90.0 * (index as f64 + 0.5) / CELLS as f64;
        let cell = |(index, value): (usize, &f64)| {
            vec![angle(index % CELLS), angle(CELLS - 1 - index / CELLS), *value]
        };
        let curve = |slice: &Slice| DataCurve {
            name: slice.caption.clone(),
            points: slice.values.iter().enumerate().map(cell).collect(),
        };
        let columns = [Word::HalfAngle, Word::DifferenceAngle].map(|word| self.lang.say(word, &[]));
        let panel = DataPanel {
            title: String::new(),
            columns: columns.into_iter().chain([self.scale.label.clone()]).collect(),
            curves: self.slices.iter().map(curve).collect(),
        };
        PlotData::new(&self.title, &self.subtitle, vec![panel])
    }

    fn title_mut(&mut self) -> &mut String {
        &mut self.title
    }

    fn lang(&self) -> Lang {
        self.lang
    }
}

impl SliceMaps {
    fn draw(&self, page: &mut Page, slice: &Slice, rect: Rect) {
        let color = |value: &f64| if value.is_nan() { NOTHING } else { magma(self.scale.part(*value)) };
        let rgb = slice.values.iter().flat_map(color).collect();
        page.rasters.push(Raster { rect, columns: CELLS, rows: CELLS, rgb });
        let axis = |label: Word| Axis::exact(self.lang.say(label, &[]), (0.0, 90.0), 6);
        let (x, y) = (axis(Word::HalfAngle), axis(Word::DifferenceAngle));
        let axes = Axes { rect, x: stepped(x), y: stepped(y), gap: 0.0 };
        axes.frame(page);
        page.text(&slice.caption, (rect.x, rect.y - 12.0), Anchor::Start, LABEL, INK);
    }
}

/// Numbers at every 15°.
fn stepped(axis: Axis) -> Axis {
    Axis { ticks: (0..=6).map(|i| 15.0 * f64::from(i)).collect(), decimals: 0, ..axis }
}
