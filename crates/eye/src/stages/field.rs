//! The field of view of a perspective camera, in which equal ways are equal angles.
//!
//! A perspective picture is stretched towards its edge: at 30° from the middle a degree is a third longer along the radius. Light that is
//! scattered by an angle must not be spread by pixels there. The planes of this field have directions at their angle from the middle
//! (azimuthal equidistant): angles from the middle are exact, and about it they are too long by θ/sin θ, 5 % at 30°.

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
const LEVEL: usize = 2;

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

    /// The level of the pyramid from which on planes are of the field.
    pub(super) fn level(&self) -> usize {
        LEVEL
    }

    /// Pixels of that level, of those of the picture.
    fn scale() -> f64 {
        libm::exp2(-(LEVEL as f64))
    }

    /// A plane of the picture at that level, taken to the field.
    pub(super) fn forth(&self, picture: &Plane) -> Plane {
        let distance = self.distance * Self::scale();
        let reach = self.reach();
        let [width, height] = reach.map(|reach| 2 * (reach + MARGIN));
        let mut field = Plane::zero(width, height, MARGIN);
        let middle = self.middle.map(|at| at * Self::scale() + picture.margin as f64);
        // By the squared radius in the field: how much farther out it is in the picture, tan θ / θ.
        let most = square(reach[0] as f64 + MARGIN as f64) + square(reach[1] as f64 + MARGIN as f64);
        let table = Table::new(most, |square| {
            let angle = (libm::sqrt(square) / distance).min(MOST);
            if angle > 0.0 { libm::tan(angle) / angle } else { 1.0 }
        });
        let from = [0.5 * width as f64, 0.5 * height as f64];
        resample(picture, &mut field, &table, from, middle);
        field
    }

    /// A plane of the field, taken to the picture at that level; `like` has its size.
    pub(super) fn back(&self, field: &Plane, like: &Plane) -> Plane {
        let distance = self.distance * Self::scale();
        let mut picture = Plane::zero(like.width, like.height, like.margin);
        let middle = self.middle.map(|at| at * Self::scale() + like.margin as f64);
        let far = |size: usize, middle: f64| square(middle.max(size as f64 - middle));
        let most = far(like.width, middle[0]) + far(like.height, middle[1]);
        let table = Table::new(most, |square| {
            let tan = libm::sqrt(square) / distance;
            if tan > 0.0 { libm::atan(tan) / tan } else { 1.0 }
        });
        let to = [0.5 * field.width as f64, 0.5 * field.height as f64];
        resample(field, &mut picture, &table, middle, to);
        picture
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

/// Fills a plane by another one: what is at `from` plus a way is there at `to` plus that way, times the table's factor.
fn resample(source: &Plane, target: &mut Plane, table: &Table, from: [f64; 2], to: [f64; 2]) {
    let width = target.width;
    let [from, to] = [from, to].map(|at| at.map(|at| at as f32));
    let last = [source.width, source.height].map(|size| (size - 1) as f32);
    for_each_row(&mut target.values, width, |y, row| {
        let dy = y as f32 + 0.5 - from[1];
        for (x, value) in row.iter_mut().enumerate() {
            let dx = x as f32 + 0.5 - from[0];
            let factor = table.at(dx * dx + dy * dy);
            let at = |way: f32, c: usize| (to[c] + way * factor - 0.5).clamp(0.0, last[c]);
            *value = linear(source, at(dx, 0), at(dy, 1));
        }
    });
}

/// The value between four pixels.
#[inline(always)]
fn linear(plane: &Plane, x: f32, y: f32) -> f32 {
    let (left, top) = (x as usize, y as usize);
    let (right, bottom) = ((left + 1).min(plane.width - 1), (top + 1).min(plane.height - 1));
    let (tx, ty) = (x - left as f32, y - top as f32);
    let row = |y: usize| {
        let row = &plane.values[y * plane.width..][..plane.width];
        row[left] + tx * (row[right] - row[left])
    };
    let (above, below) = (row(top), row(bottom));
    above + ty * (below - above)
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
        let back = field.back(&field.forth(&picture), &picture);
        for y in MARGIN..height - MARGIN {
            for x in MARGIN..width - MARGIN {
                let (a, b) = (picture.values[y * width + x], back.values[y * width + x]);
                // Two linear interpolations of waves of 44 pixels and more, at the edge of squeezed ones.
                assert!((a - b).abs() < 0.02, "{x} {y}: {b} for {a}");
            }
        }
        let even = Plane { values: vec![0.3; width * height], ..picture };
        let back = field.back(&field.forth(&even), &even);
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
        let forth = field.forth(&picture);
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
