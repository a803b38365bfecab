//! The field of view of a perspective camera, in which equal ways are equal angles.
//!
//! A perspective picture is stretched towards its edge: at 30° from the middle a degree is a third longer along the radius. Light that is
//! scattered by an angle must not be spread by pixels there. The planes of this field have directions at their angle from the middle
//! (azimuthal equidistant): angles from the middle are exact, and about it they are too long by θ/sin θ, 5 % at 30°.

use glanz_math::{SimdLevel, at_level};

use super::plane::{Plane, for_each_row};
use super::pyramid::MARGIN;

/// A field of view, and how it belongs to the pixels of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Field {
    /// The distance of the picture from the eye, in pixels.
    distance: f64,
    /// The middle of the picture, in pixels from its edges.
    middle: [f64; 2],
}

/// The level of the pyramid from which on planes are of the field.
///
/// Blurs of finer levels have σ below 6.8 pixels, and are as good as flat.
pub(super) const LEVEL: usize = 2;

/// The variance that going to the field and back adds, in squared pixels of that level: each time a mean over places within a pixel of
/// t(1 − t).
pub(super) const VARIANCE: f64 = 1.0 / 3.0;

/// The greatest angle from the middle; a perspective picture has none of 90°.
const MOST: f64 = 1.5;

/// Below this stretch of the farthest corner a picture is as good as a field.
const FLAT: f64 = 1.01;

/// Steps of the table of radii.
const STEPS: usize = 1024;

impl Field {
    /// The field of a picture, if it differs from the picture by enough to matter.
    pub(crate) fn new(distance_px: Option<f64>, middle: [f64; 2]) -> Option<Self> {
        let field = Self { distance: distance_px?, middle };
        let corner = libm::hypot(middle[0], middle[1]) / field.distance;
        (corner.is_finite() && corner / libm::atan(corner) > FLAT).then_some(field)
    }

    /// Pixels of that level, of those of the picture.
    fn scale() -> f64 {
        libm::exp2(-(LEVEL as f64))
    }

    /// The ways between the field and a plane of the picture at that level, of the size of `like`, margins included.
    pub(super) fn ways(&self, like: [usize; 2], margin: usize) -> Ways {
        let size = self.reach().map(|reach| 2 * (reach + MARGIN));
        let field_middle = size.map(|size| 0.5 * size as f64);
        let picture_middle = self.middle.map(|at| at * Self::scale() + margin as f64);
        let distance = self.distance * Self::scale();
        // By the squared radius in the field, how much farther out it is in the picture: tan θ / θ; and back.
        let out = Table::new(farthest(size, field_middle), |square| {
            let angle = (libm::sqrt(square) / distance).min(MOST);
            if angle > 0.0 { libm::tan(angle) / angle } else { 1.0 }
        });
        let back = Table::new(farthest(like, picture_middle), |square| {
            let tan = libm::sqrt(square) / distance;
            if tan > 0.0 { libm::atan(tan) / tan } else { 1.0 }
        });
        Ways {
            forth: Places::new(size, like, &out, field_middle, picture_middle),
            back: Places::new(like, size, &back, picture_middle, field_middle),
            margin,
        }
    }

    /// How far the field reaches to either side of its middle, in whole pixels of its level.
    fn reach(&self) -> [usize; 2] {
        self.middle.map(|half| {
            let angle = libm::atan(half / self.distance);
            (angle * self.distance * Self::scale()).ceil() as usize + 1
        })
    }
}

fn square(value: f64) -> f64 {
    value * value
}

/// The squared distance of the farthest corner of a plane from a place.
fn farthest(size: [usize; 2], middle: [f64; 2]) -> f64 {
    let [x, y] = [0, 1].map(|c| square(middle[c].max(size[c] as f64 - middle[c])));
    x + y
}

/// A factor by the squared radius, linear between steps.
struct Table {
    per_step: f32,
    values: Vec<f32>,
}

impl Table {
    fn new(most: f64, factor: impl Fn(f64) -> f64) -> Self {
        let step = most / STEPS as f64;
        Self {
            per_step: (1.0 / step) as f32,
            values: (0..STEPS + 2).map(|i| factor(i as f64 * step) as f32).collect(),
        }
    }

    #[inline(always)]
    fn at(&self, square: f32) -> f32 {
        let at = square * self.per_step;
        let i = (at as usize).min(STEPS);
        let (a, b) = (self.values[i], self.values[i + 1]);
        a + (b - a) * (at - i as f32).min(1.0)
    }
}

/// The ways from a plane of the picture to the field, and back.
pub(crate) struct Ways {
    forth: Places,
    back: Places,
    /// The margin of the picture's plane.
    margin: usize,
}

impl Ways {
    /// A plane of the picture, taken to the field.
    pub(super) fn forth(&self, picture: &Plane) -> Plane {
        self.forth.of(picture, MARGIN)
    }

    /// A plane of the field, taken to the picture.
    pub(super) fn back(&self, field: &Plane) -> Plane {
        self.back.of(field, self.margin)
    }
}

/// Where in another plane the pixels of a plane are: of every second one, linear between them.
///
/// Places by themselves would be more to read than the planes; from the line between two of them the curve is 0.01 pixels off where the
/// picture is seen under 45°.
struct Places {
    size: [usize; 2],
    source: [usize; 2],
    /// How many places a row of the grid has.
    columns: usize,
    grid: [Vec<f32>; 2],
}

/// Pixels between two places of the grid.
const GRID: usize = 2;

impl Places {
    /// What is at `from` plus a way is in the other plane at `to` plus that way, times the table's factor.
    fn new(size: [usize; 2], source: [usize; 2], table: &Table, from: [f64; 2], to: [f64; 2]) -> Self {
        let [columns, rows] = size.map(|size| size / GRID + 2);
        let [from, to] = [from, to].map(|at| at.map(|at| at as f32));
        let grid = [0, 1].map(|c| {
            let mut places = vec![0.0; columns * rows];
            for_each_row(&mut places, columns, |y, row| {
                for (x, place) in row.iter_mut().enumerate() {
                    let way = [0, 1].map(|c| ([x, y][c] * GRID) as f32 + 0.5 - from[c]);
                    *place = to[c] + way[c] * table.at(way[0] * way[0] + way[1] * way[1]) - 0.5;
                }
            });
            places
        });
        Self { size, source, columns, grid }
    }

    /// A plane of what is there in the other one, linear between its pixels.
    fn of(&self, source: &Plane, margin: usize) -> Plane {
        let [width, height] = self.size;
        let mut target = Plane::zero(width, height, margin);
        let level = SimdLevel::best();
        // The rows below those of the source: what is at a place there is below it here.
        let (upper, lower) = (&source.values[..], &source.values[self.source[0]..]);
        for_each_row(&mut target.values, width, |y, row| {
            let [mut columns, mut rows] = [0, 1].map(|_| vec![0.0; self.columns * GRID]);
            let mut at = vec![0; columns.len()];
            at_level!(level, simd => {
                let _ = simd;
                self.expand(0, y, &mut columns);
                self.expand(1, y, &mut rows);
                split(&mut columns, &mut rows, &mut at, self.source);
            });
            for (((value, at), tx), ty) in row.iter_mut().zip(&at).zip(&columns).zip(&rows) {
                let at = *at as usize;
                let (Some([a, b]), Some([c, d])) = (upper[at..].first_chunk(), lower[at..].first_chunk())
                else {
                    continue;
                };
                let (above, below) = (a + tx * (b - a), c + tx * (d - c));
                *value = above + ty * (below - above);
            }
        });
        target
    }

    /// One coordinate of the places of a row.
    #[inline(always)]
    fn expand(&self, coordinate: usize, y: usize, places: &mut [f32]) {
        let (cell, part) = (y / GRID, (y % GRID) as f32 / GRID as f32);
        let (above, below) = self.grid[coordinate][cell * self.columns..].split_at(self.columns);
        let tall: Vec<f32> = above.iter().zip(below).map(|(a, b)| a + part * (b - a)).collect();
        for (own, pair) in places.as_chunks_mut::<GRID>().0.iter_mut().zip(tall.windows(2)) {
            let step = (pair[1] - pair[0]) / GRID as f32;
            for (i, place) in own.iter_mut().enumerate() {
                *place = pair[0] + i as f32 * step;
            }
        }
    }
}

/// Splits places of a plane of this size into the index of the pixel at their upper left, and how far they are from it to the right and
/// down, from 0 to 1.
#[inline(always)]
fn split(columns: &mut [f32], rows: &mut [f32], at: &mut [u32], size: [usize; 2]) {
    // Planes of the pyramid have margins: no side is shorter than two pixels.
    let last = size.map(|size| size as i32 - 2);
    let whole = |place: &mut f32, last: i32| {
        let within = place.max(0.0).min((last + 1) as f32);
        let whole = (within as i32).min(last);
        *place = within - whole as f32;
        whole
    };
    for ((at, column), row) in at.iter_mut().zip(columns).zip(rows) {
        let (left, top) = (whole(column, last[0]), whole(row, last[1]));
        *at = (top * size[0] as i32 + left) as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field() -> Field {
        // 90° across.
        Field::new(Some(200.0), [200.0, 100.0]).unwrap()
    }

    #[test]
    fn a_plane_comes_back_as_it_was() {
        let field = field();
        let (width, height) = (100 + 2 * MARGIN, 50 + 2 * MARGIN);
        let mut picture = Plane::zero(width, height, MARGIN);
        for (i, value) in picture.values.iter_mut().enumerate() {
            let (x, y) = ((i % width) as f64, (i / width) as f64);
            *value = (libm::sin(x / 9.0) + libm::cos(y / 7.0)) as f32;
        }
        let ways = field.ways([width, height], MARGIN);
        let back = ways.back(&ways.forth(&picture));
        for y in MARGIN..height - MARGIN {
            for x in MARGIN..width - MARGIN {
                let (a, b) = (picture.values[y * width + x], back.values[y * width + x]);
                // Two linear interpolations of waves of 44 pixels and more, at the edge of squeezed ones.
                assert!((a - b).abs() < 0.02, "{x} {y}: {b} for {a}");
            }
        }
        let even = Plane { values: vec![0.3; width * height], ..picture };
        let back = ways.back(&ways.forth(&even));
        assert!(back.values.iter().all(|v| (v - 0.3).abs() < 1e-6));
    }

    #[test]
    fn angles_from_the_middle_are_ways_in_the_field() {
        let field = field();
        let (width, height) = (100 + 2 * MARGIN, 50 + 2 * MARGIN);
        let mut picture = Plane::zero(width, height, MARGIN);
        // A line at 40° to the right: 50 · tan 40° = 42 pixels of the level.
        let tan = 50.0 * libm::tan(40.0_f64.to_radians());
        let at = MARGIN as f64 + 50.0 + tan - 0.5;
        for y in 0..height {
            picture.values[y * width + at as usize] = (1.0 - at.fract()) as f32;
            picture.values[y * width + at as usize + 1] = at.fract() as f32;
        }
        let forth = field.ways([width, height], MARGIN).forth(&picture);
        let row = forth.row((forth.height / 2) as isize);
        let (mut sum, mut first) = (0.0, 0.0);
        for (x, value) in row.iter().enumerate() {
            sum += f64::from(*value);
            first += f64::from(*value) * (x as f64 + 0.5 - 0.5 * forth.width as f64);
        }
        let expected = 50.0 * 40.0_f64.to_radians();
        assert!((first / sum - expected).abs() < 0.5, "{} for {expected}", first / sum);
    }

    #[test]
    fn narrow_pictures_and_screens_are_flat() {
        assert_eq!(Field::new(None, [500.0, 500.0]), None);
        assert_eq!(Field::new(Some(5000.0), [500.0, 500.0]), None);
        assert!(Field::new(Some(1000.0), [500.0, 500.0]).is_some());
    }
}
