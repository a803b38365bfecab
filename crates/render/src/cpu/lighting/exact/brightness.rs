//! Directions of an environment, denser where it is brighter.

use glanz_math::{PI, Real, Vec3};

use super::points::SquarePoint;
use crate::prepare::EnvironmentMap;

/// The most columns of the grid, and its rows.
const MOST: [usize; 2] = [1024, 512];

/// How much of the density is the same everywhere: what falls between the points of the grid is not missed.
const EVEN: f64 = 0.05;

/// A direction towards an environment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BrightPoint {
    /// In the environment's own directions.
    pub direction: [f64; 3],
    /// How much of each spectrum comes from there.
    pub amounts: [f32; 3],
    /// How dense such points are there, per steradian.
    pub density: f64,
}

/// How dense points are over the directions of an environment, by cells of equal solid angle: columns around the
/// vertical, rows of equal height.
#[derive(Debug)]
pub(crate) struct Brightness {
    columns: usize,
    rows: usize,
    /// Per steradian, by rows from the top.
    density: Vec<f32>,
    pub points: Vec<BrightPoint>,
}

impl Brightness {
    pub(crate) fn new(map: &EnvironmentMap, points: &[SquarePoint]) -> Self {
        let [columns, rows] = [map.width.min(MOST[0]), map.height.min(MOST[1])];
        let cells = crate::parallel::collect(columns * rows, |i| cell(map, [columns, rows], i));
        let mut values = splat(map, cells, [columns, rows]);
        let total: f64 = values.iter().sum();
        let even = if total > 0.0 { EVEN * total / values.len() as f64 } else { 1.0 };
        values.iter_mut().for_each(|value| *value += even);
        let total: f64 = values.iter().sum();
        let solid = 4.0 * PI / values.len() as f64;
        let density = values.iter().map(|value| (value / (total * solid)) as f32).collect();
        let mut own = Self { columns, rows, density, points: Vec::new() };
        own.points = own.chosen(map, &values, points);
        own
    }

    /// The points by the inverse of the distribution, first the row and then the column, which keeps them even.
    fn chosen(&self, map: &EnvironmentMap, values: &[f64], points: &[SquarePoint]) -> Vec<BrightPoint> {
        let running = |values: &mut dyn Iterator<Item = f64>| {
            let mut sum = 0.0;
            let sums: Vec<f64> = values
                .map(|value| {
                    sum += value;
                    sum
                })
                .collect();
            sums
        };
        let by_row: Vec<Vec<f64>> =
            values.chunks(self.columns).map(|row| running(&mut row.iter().copied())).collect();
        let rows = running(&mut by_row.iter().map(|row| row[self.columns - 1]));
        let point = |point: &SquarePoint| {
            let (row, down) = place(&rows, point.v);
            let (column, around) = place(&by_row[row], point.u);
            let y = 1.0 - 2.0 * (row as f64 + down) / self.rows as f64;
            let direction = direction(y, (column as f64 + around) / self.columns as f64);
            let [x, y, z] = direction;
            let amounts = map.at(Vec3::new(x as f32, y as f32, z as f32));
            let density = f64::from(self.density[row * self.columns + column]);
            BrightPoint { direction, amounts, density }
        };
        points.iter().map(point).collect()
    }

    /// How dense points are around a direction of the environment.
    #[inline(always)]
    pub(crate) fn density<R: Real>(&self, direction: Vec3<R>) -> R {
        let like = direction.x;
        let around = direction.x.atan2(-direction.z) * like.lit(0.5 / PI) + like.lit(0.5);
        let columns = (around * like.lit(self.columns as f64)).to_array();
        let rows = ((like.one() - direction.y) * like.lit(0.5 * self.rows as f64)).to_array();
        let mut values = [0.0; 16];
        for lane in 0..R::LANES {
            // A direction that is no number gives the first cell.
            let row = (rows[lane].max(0.0) as usize).min(self.rows - 1);
            let column = (columns[lane].max(0.0) as usize).min(self.columns - 1);
            values[lane] = self.density[row * self.columns + column];
        }
        like.with_array(&values)
    }
}

/// The direction at a height, and at a fraction of a turn from behind.
fn direction(y: f64, around: f64) -> [f64; 3] {
    let (sin, cos) = libm::sincos((around - 0.5) * 2.0 * PI);
    let radius = libm::sqrt((1.0 - y * y).max(0.0));
    [radius * sin, y, -radius * cos]
}

/// The cell in which a fraction of all lies, and where in it.
fn place(running: &[f64], fraction: f64) -> (usize, f64) {
    let wanted = fraction * running[running.len() - 1];
    let cell = running.partition_point(|sum| *sum <= wanted).min(running.len() - 1);
    let before = if cell == 0 { 0.0 } else { running[cell - 1] };
    let own = running[cell] - before;
    (cell, if own > 0.0 { ((wanted - before) / own).clamp(0.0, 1.0) } else { 0.5 })
}

/// The brightness in the middle of the quarters of a cell.
fn cell(map: &EnvironmentMap, [columns, rows]: [usize; 2], number: usize) -> f64 {
    let (column, row) = (number % columns, number / columns);
    let at = |quarter: usize| {
        let (x, y) = (0.25 + 0.5 * (quarter % 2) as f64, 0.25 + 0.5 * (quarter / 2) as f64);
        let y = 1.0 - 2.0 * (row as f64 + y) / rows as f64;
        let [x, y, z] = direction(y, (column as f64 + x) / columns as f64);
        brightness(map.at(Vec3::new(x as f32, y as f32, z as f32)))
    };
    (0..4).map(at).sum::<f64>() / 4.0
}

/// The cells with what each pixel of the environment has, so that none is missed where they are small, and their
/// neighbours, since values between pixels are interpolated.
fn splat(map: &EnvironmentMap, mut cells: Vec<f64>, [columns, rows]: [usize; 2]) -> Vec<f64> {
    let solid = 4.0 * PI / (columns * rows) as f64;
    let is_finer = map.width > columns || map.height > rows;
    if is_finer {
        for i in 0..map.pixels.len() {
            let (row, column) = (i / map.width, i % map.width);
            let [_, y, _] = map.direction(row, column);
            let own = ((0.5 * (1.0 - y) * rows as f64) as usize).min(rows - 1);
            let part = map.solid_angle(row) / solid;
            cells[own * columns + column * columns / map.width] += part * brightness(map.pixels[i]);
        }
    }
    let smooth = |i: usize| {
        let (column, row) = (i % columns, i / columns);
        let beside = |by: usize| cells[row * columns + (column + by) % columns];
        let above = cells[row.saturating_sub(1) * columns + column];
        let below = cells[(row + 1).min(rows - 1) * columns + column];
        cells[i] + 0.125 * (beside(1) + beside(columns - 1) + above + below)
    };
    (0..columns * rows).map(smooth).collect()
}

fn brightness(amounts: [f32; 3]) -> f64 {
    amounts.iter().map(|amount| f64::from(amount.max(0.0))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cpu::lighting::exact::points::{Part, Purpose, spread};

    /// A wall with a window sixteen times as bright.
    fn room() -> EnvironmentMap {
        EnvironmentMap::from_fn(96, 48, |[x, y, z]| {
            [if x > 0.6 && y.abs() < 0.3 && z < 0.7 { 16.0 } else { 1.0 }; 3]
        })
    }

    #[test]
    fn points_are_as_dense_as_they_say() {
        let room = room();
        let brightness = Brightness::new(&room, &spread(4096, Part::Whole, Purpose::Light));
        // Σ 1 / density is the solid angle of all directions; Σ amount / density all that comes from them.
        let (mut whole, mut all) = (0.0, 0.0);
        for point in &brightness.points {
            let [x, y, z] = point.direction;
            let looked_up = brightness.density(Vec3::new(x as f32, y as f32, z as f32));
            assert!((f64::from(looked_up) / point.density - 1.0).abs() < 1e-5, "{point:?}");
            whole += 1.0 / (4096.0 * point.density);
            all += f64::from(point.amounts[0]) / (4096.0 * point.density);
        }
        assert!((whole / (4.0 * PI) - 1.0).abs() < 0.01, "{whole}");
        let pixels = room.pixels.iter().enumerate();
        let truth: f64 = pixels.map(|(i, p)| f64::from(p[0]) * room.solid_angle(i / room.width)).sum();
        assert!((all / truth - 1.0).abs() < 0.01, "{all} for {truth}");
    }

    #[test]
    fn a_single_bright_pixel_is_not_missed() {
        let map = EnvironmentMap::from_fn(4096, 2048, |[x, y, z]| {
            let is_sun = x * 0.6 + y * 0.0 + z * 0.8 > 0.999_999;
            [if is_sun { 1e6 } else { 0.01 }; 3]
        });
        let brightness = Brightness::new(&map, &spread(256, Part::Whole, Purpose::Light));
        let near = |point: &&BrightPoint| point.direction[0] * 0.6 + point.direction[2] * 0.8 > 0.999;
        assert!(brightness.points.iter().filter(near).count() > 200);
    }
}
