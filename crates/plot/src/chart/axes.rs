//! Axes: from values to points of a page, with a grid, numbers and labels.

use crate::page::style::{GRAY, GRID, INK, LABEL, NUMBER};
use crate::page::{Anchor, Page, Rect, letters};

/// How long a mark at a number is, in points.
const MARK: f64 = 5.0;

/// The most decades that [`Axis::decades_over`] shows.
const DECADES: i32 = 6;

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What is measured, with its unit.
    pub label: String,
    /// The values at its ends.
    pub range: (f64, f64),
    /// Whether equal lengths are equal ratios.
    pub log: bool,
    /// Where numbers stand.
    pub ticks: Vec<f64>,
    /// How many decimals they have.
    pub decimals: usize,
}

impl Axis {
    /// An axis over exactly this range, with about so many round numbers.
    pub fn exact(label: impl Into<String>, range: (f64, f64), about: usize) -> Self {
        Self::stepped(label, range, round_step((range.1 - range.0) / about.max(1) as f64))
    }

    /// An axis over this range, widened to round numbers.
    pub fn round(label: impl Into<String>, (low, high): (f64, f64), about: usize) -> Self {
        let high = if high > low { high } else { low + 1.0 };
        let step = round_step((high - low) / about.max(1) as f64);
        let range = ((low / step + 1e-9).floor() * step, (high / step - 1e-9).ceil() * step);
        Self::stepped(label, range, step)
    }

    /// An axis with a number at each multiple of the step.
    fn stepped(label: impl Into<String>, range: (f64, f64), step: f64) -> Self {
        let first = (range.0 / step - 1e-9).ceil();
        let count = ((range.1 / step + 1e-9).floor() - first).max(0.0) as usize;
        let ticks = (0..=count).map(|i| (first + i as f64) * step).collect();
        Self { label: label.into(), range, log: false, ticks, decimals: decimals(step) }
    }

    /// A logarithmic axis from power of ten to power of ten, with a number at each.
    pub fn decades(label: impl Into<String>, (low, high): (i32, i32)) -> Self {
        // Read from text, 1e-7 has no rounding to show.
        let power = |exponent: i32| format!("1e{exponent}").parse::<f64>().unwrap_or(0.0);
        let high = high.max(low + 1);
        let step = ((high - low + 9) / 10).max(1) as usize;
        let ticks: Vec<_> = (low..=high).step_by(step).map(power).collect();
        Self::log(label, (power(low), power(high)), &ticks)
    }

    /// A logarithmic axis from the least of the values that are above 0 to `most`, of at most six decades.
    pub fn decades_over(label: impl Into<String>, values: impl Iterator<Item = f64>, most: f64) -> Self {
        let high = if most > 0.0 { (libm::log10(most) - 1e-9).ceil() as i32 } else { 0 };
        let least = values.filter(|value| *value > 0.0).fold(most.max(f64::MIN_POSITIVE), f64::min);
        let low = (libm::log10(least).floor() as i32).clamp(high - DECADES, high - 1);
        Self::decades(label, (low, high))
    }

    /// Angles from 0 to 90°, with a number at every 15°.
    pub fn quarter_turn(label: impl Into<String>) -> Self {
        let ticks = (0..=6).map(|i| 15.0 * f64::from(i)).collect();
        Self { ticks, decimals: 0, ..Self::exact(label, (0.0, 90.0), 6) }
    }

    /// A logarithmic axis with numbers at these values.
    pub fn log(label: impl Into<String>, range: (f64, f64), ticks: &[f64]) -> Self {
        let ticks = ticks.iter().copied().filter(|tick| (range.0..=range.1).contains(tick)).collect();
        Self { label: label.into(), range, log: true, ticks, decimals: 0 }
    }

    /// Where a value lies, 0 … 1 along the axis; values beyond the ends are held there.
    pub fn part(&self, value: f64) -> f64 {
        let place = |value: f64| if self.log { libm::log(value.max(f64::MIN_POSITIVE)) } else { value };
        let (low, high) = (place(self.range.0), place(self.range.1));
        ((place(value) - low) / (high - low)).clamp(0.0, 1.0)
    }

    /// A value as it stands at the axis.
    pub fn number(&self, value: f64) -> String {
        let text = match self.log {
            // Beyond a few zeros a power of ten is read faster.
            true if !(1e-3..1e5).contains(&value.abs()) && value != 0.0 => format!("{value:e}"),
            true => format!("{value}"),
            // A tick at 0 may be the rounding of a difference.
            false => format!("{:.*}", self.decimals, value + 0.0),
        };
        text.replace('-', "–")
    }
}

/// 1, 2, 2.5 or 5 times a power of ten, at least this.
fn round_step(least: f64) -> f64 {
    let power = libm::exp10(libm::floor(libm::log10(least.max(f64::MIN_POSITIVE))));
    let step = [1.0, 2.0, 2.5, 5.0, 10.0].into_iter().find(|step| step * power >= least * 0.999);
    step.unwrap_or(10.0) * power
}

fn decimals(step: f64) -> usize {
    (0..6)
        .find(|digits| {
            let scaled = step * libm::exp10(*digits as f64);
            (scaled - scaled.round()).abs() < 1e-6
        })
        .unwrap_or(6)
}

/// A pair of axes and where they lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// The area of the values.
    pub rect: Rect,
    /// From left to right.
    pub x: Axis,
    /// From bottom to top.
    pub y: Axis,
    /// How far below the area the numbers of x begin: a band may lie between.
    pub gap: f64,
}

impl Axes {
    /// The point of a pair of values.
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let (x, y) = (self.x.part(x), self.y.part(y));
        (self.rect.x + x * self.rect.width, self.rect.bottom() - y * self.rect.height)
    }

    /// The point of a value of x on the lower edge.
    fn below(&self, x: f64) -> (f64, f64) {
        (self.at(x, self.y.range.0).0, self.rect.bottom())
    }

    /// Draws the lines of the grid.
    pub fn grid(&self, page: &mut Page) {
        for tick in &self.x.ticks {
            let (x, bottom) = self.below(*tick);
            page.line([(x, self.rect.y), (x, bottom)], GRID, 1.0);
        }
        for tick in &self.y.ticks {
            let (_, y) = self.at(self.x.range.0, *tick);
            page.line([(self.rect.x, y), (self.rect.right(), y)], GRID, 1.0);
        }
    }

    /// Of how many marks of x one has its number, so that numbers do not touch each other.
    fn numbered(&self) -> usize {
        let widest = self.x.ticks.iter().map(|tick| letters::width(&self.x.number(*tick), NUMBER));
        let widest = widest.fold(0.0, f64::max) + 8.0;
        let places: Vec<_> = self.x.ticks.iter().map(|tick| self.below(*tick).0).collect();
        let fits = |every: &usize| {
            places
                .iter()
                .step_by(*every)
                .zip(places.iter().step_by(*every).skip(1))
                .all(|(a, b)| b - a >= widest)
        };
        (1..=places.len().max(1)).find(fits).unwrap_or(1)
    }

    /// Draws the axes with numbers and labels.
    pub fn frame(&self, page: &mut Page) {
        page.outline(self.rect, GRAY, 1.2);
        let every = self.numbered();
        for (index, tick) in self.x.ticks.iter().enumerate() {
            let (x, bottom) = self.below(*tick);
            let bottom = bottom + self.gap;
            page.line([(x, bottom), (x, bottom + MARK)], GRAY, 1.2);
            let at = (x, bottom + MARK + NUMBER + 2.0);
            if index % every == 0 {
                page.text(self.x.number(*tick), at, Anchor::Middle, NUMBER, GRAY);
            }
        }
        for tick in &self.y.ticks {
            let (_, y) = self.at(self.x.range.0, *tick);
            page.line([(self.rect.x - MARK, y), (self.rect.x, y)], GRAY, 1.2);
            let at = (self.rect.x - MARK - 5.0, y + 0.36 * NUMBER);
            page.text(self.y.number(*tick), at, Anchor::End, NUMBER, GRAY);
        }
        let middle = self.rect.x + 0.5 * self.rect.width;
        let below = self.rect.bottom() + self.gap + MARK + 2.6 * NUMBER + 4.0;
        page.text(&self.x.label, (middle, below), Anchor::Middle, LABEL, INK);
        let widest = self.y.ticks.iter().map(|tick| letters::width(&self.y.number(*tick), NUMBER));
        let widest = widest.fold(0.0, f64::max);
        let at = (self.rect.x - MARK - 5.0 - widest - 14.0, self.rect.y + 0.5 * self.rect.height);
        page.text_upwards(&self.y.label, at, LABEL, INK);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_at_axes_are_round() {
        let axis = Axis::exact("nm", (380.0, 780.0), 8);
        assert_eq!(axis.ticks, [400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0, 750.0]);
        let axis = Axis::round("part", (-0.03, 0.97), 5);
        assert_eq!(axis.range, (-0.2, 1.0));
        assert_eq!(axis.number(axis.ticks[0]), "–0.2");
        assert_eq!(axis.number(axis.ticks[1]), "0.0");
        assert_eq!(Axis::round("steps of a quarter", (0.0, 1.0), 4).number(0.25), "0.25");
    }

    #[test]
    fn numbers_of_a_narrow_axis_do_not_touch() {
        let numbers = |width: f64| {
            let rect = Rect { x: 50.0, y: 10.0, width, height: 50.0 };
            let x = Axis::exact("", (-90.0, 90.0), 12);
            let axes =
                Axes { rect, x: Axis { decimals: 0, ..x }, y: Axis::exact("", (0.0, 1.0), 1), gap: 0.0 };
            let mut page = Page::new(900, 100);
            axes.frame(&mut page);
            page.texts().filter(|text| text.anchor == Anchor::Middle && !text.text.is_empty()).count()
        };
        let (wide, narrow) = (numbers(800.0), numbers(150.0));
        assert!(narrow >= 3 && wide > narrow, "{wide} {narrow}");
    }

    #[test]
    fn a_flat_curve_has_an_axis_too() {
        let axis = Axis::round("nothing", (0.0, 0.0), 5);
        assert!(axis.range.1 > axis.range.0 && axis.ticks.len() > 2);
    }

    #[test]
    fn equal_ratios_are_equal_lengths_on_a_logarithmic_axis() {
        let axis = Axis::log("n", (1.0, 100.0), &[1.0, 10.0, 100.0, 1000.0]);
        assert_eq!(axis.ticks.len(), 3);
        assert!((axis.part(10.0) - 0.5).abs() < 1e-12);
        assert_eq!((axis.part(0.0), axis.part(1e9)), (0.0, 1.0));
    }
}
