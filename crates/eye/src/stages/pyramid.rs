//! Sums of Gaussian blurs on an octave pyramid.
//!
//! Each level has half the pixels of the one before in each direction; a Gaussian is applied where its σ is 1.7 to 3.4 pixels, on the
//! first level after the picture itself from 0.8 on. Going down and up again blurs by itself, with a variance that is known and taken
//! off. No transform to frequencies: the same bits on every machine.

use glanz_math::{SimdLevel, at_level};
use libm::log2;

use super::blur::Kernel;
use super::field::{self, Ways};
use super::plane::{Plane, for_each_row};

/// A blur: how much of the light it takes, and how far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Blur {
    pub weight: f64,
    pub sigma_px: f64,
}

/// Below this σ in pixels a blur is none.
const SHARP: f64 = 0.25;

/// The least σ in pixels of a level at which a Gaussian is applied there.
const LEAST: f64 = 1.7;

/// The same of the first level after the picture itself.
const LEAST_OF_FIRST: f64 = 0.8;

/// The sum of `blurs` of a plane, and `rest` of the plane itself. Where the plane ends, it is taken to go on as its edge. Where a field
/// of view is given, widths are angles from its level on.
pub(crate) fn blurred(plane: Plane, rest: f64, blurs: &[Blur], field: Option<&Ways>) -> Plane {
    let mut kept = rest;
    let mut by_level: Vec<Vec<Blur>> = Vec::new();
    for blur in blurs {
        if blur.sigma_px < SHARP {
            kept += blur.weight;
            continue;
        }
        let level = level_of(blur.sigma_px);
        if by_level.len() <= level {
            by_level.resize(level + 1, Vec::new());
        }
        by_level[level].push(*blur);
    }
    descend(plane, 0, kept, &Levels { blurs: by_level, field })
}

/// What the levels add.
struct Levels<'a> {
    /// The blurs of each level.
    blurs: Vec<Vec<Blur>>,
    field: Option<&'a Ways>,
}

impl Levels<'_> {
    /// The field, if the planes of it begin at a level.
    fn field_from(&self, level: usize) -> Option<&Ways> {
        self.field.filter(|_| field::LEVEL == level)
    }

    /// The variance in pixels of a level that is left to be applied there, when going there and back has blurred already.
    fn variance_left(&self, sigma_px: f64, level: usize) -> f64 {
        let left = variance_left(sigma_px, level);
        match self.field {
            Some(_) if level >= field::LEVEL => {
                let scale = libm::exp2((field::LEVEL as f64) - level as f64);
                (left - field::VARIANCE * scale * scale).max(0.0)
            }
            _ => left,
        }
    }
}

/// The level at which a Gaussian is applied.
fn level_of(sigma_px: f64) -> usize {
    let level = log2(sigma_px / LEAST).floor();
    // The first level has four times the pixels of the next one: it is left as soon as it can be.
    let least = if sigma_px >= 2.0 * LEAST_OF_FIRST { 1.0 } else { 0.0 };
    level.max(least) as usize
}

/// The sum of what the levels from `level` on add to a plane at that level, and `kept` of itself.
fn descend(plane: Plane, level: usize, kept: f64, levels: &Levels<'_>) -> Plane {
    let own = levels.blurs.get(level).map_or(&[][..], Vec::as_slice);
    let more = levels.blurs.len() > level + 1;
    let coarse = more.then(|| {
        let half = halved(&plane);
        match levels.field_from(level + 1) {
            None => descend(half, level + 1, 0.0, levels),
            Some(field) => field.back(&descend(field.forth(&half), level + 1, 0.0, levels)),
        }
    });
    let kernels: Vec<_> =
        own.iter().map(|blur| Kernel::new(levels.variance_left(blur.sigma_px, level), blur.weight)).collect();
    if kernels.is_empty() {
        // The plane itself is needed no more: the sum takes its place.
        let mut sum = plane;
        let (width, margin) = (sum.width, sum.margin);
        for_each_row(&mut sum.values, width, |y, row| {
            at_level!(SimdLevel::best(), simd => {
                let _ = simd;
                scale_and_double(row, y, margin, kept as f32, coarse.as_ref());
            });
        });
        return sum;
    }
    let mut sum = Plane::zero(plane.width, plane.height, plane.margin);
    for_each_row(&mut sum.values, plane.width, |y, row| {
        at_level!(SimdLevel::best(), simd => {
            let _ = simd;
            row.copy_from_slice(plane.row(y as isize));
            scale_and_double(row, y, plane.margin, kept as f32, coarse.as_ref());
            kernels.iter().for_each(|kernel| kernel.add_row(&plane, y, row));
        });
    });
    sum
}

/// The variance in pixels of a level that is left to be applied there, when going down and up has blurred already.
pub(crate) fn variance_left(sigma_px: f64, level: usize) -> f64 {
    let scale = libm::exp2(-(level as f64));
    let way = 0.5 * (1.0 - scale * scale);
    (sigma_px * sigma_px * scale * scale - way).max(0.0)
}

/// Pixels of the levels beyond the picture's edge: as far as a Gaussian of a level reaches. Light that leaves the picture is not
/// counted at its edge again.
pub(crate) const MARGIN: usize = 12;

/// The size of the next level, of that of a level, margins included.
pub(crate) fn next_size(size: [usize; 2], margin: usize) -> [usize; 2] {
    size.map(|size| (size - 2 * margin).div_ceil(2) + 2 * MARGIN)
}

/// The next level: half as wide and high, by the weights 1 3 3 1.
pub(crate) fn halved(plane: &Plane) -> Plane {
    let [width, height] = next_size([plane.width, plane.height], plane.margin);
    let mut half = Plane::zero(width, height, MARGIN);
    let level = SimdLevel::best();
    // The first pixel of the next level lies between these two of this one: the second of them, counted with the margin.
    let first = plane.margin as isize - 2 * MARGIN as isize;
    for_each_row(&mut half.values, width, |y, row| {
        let y = first + 2 * y as isize;
        let rows = [-1, 0, 1, 2].map(|dy| plane.row(y + dy));
        let mut tall = vec![0.0_f32; plane.width];
        at_level!(level, simd => {
            let _ = simd;
            tall_sum(&rows, &mut tall);
            halve_row(&tall, first, row);
        });
    });
    half
}

#[inline(always)]
fn tall_sum(rows: &[&[f32]; 4], tall: &mut [f32]) {
    let [a, b, c, d] = rows;
    let n = tall.len();
    let (a, b, c, d) = (&a[..n], &b[..n], &c[..n], &d[..n]);
    for x in 0..n {
        tall[x] = 0.125 * (a[x] + d[x]) + 0.375 * (b[x] + c[x]);
    }
}

#[inline(always)]
fn halve_row(tall: &[f32], first: isize, row: &mut [f32]) {
    let last = tall.len() as isize - 1;
    let at = |x: isize| tall[x.clamp(0, last) as usize];
    // Inside, no index is beyond the edge: 0 ≤ first + 2x − 1 and first + 2x + 2 ≤ last.
    let from = (((2 - first) / 2).max(0) as usize).min(row.len());
    let to = (((last - first) / 2).max(0) as usize).clamp(from, row.len());
    for x in (0..from).chain(to..row.len()) {
        let at = |d: isize| at(first + 2 * x as isize + d);
        row[x] = 0.125 * (at(-1) + at(2)) + 0.375 * (at(0) + at(1));
    }
    if from < to {
        let inside = &tall[(first + 2 * from as isize - 1) as usize..][..2 * (to - from) + 2];
        for (x, out) in row[from..to].iter_mut().enumerate() {
            let four = &inside[2 * x..2 * x + 4];
            *out = 0.125 * (four[0] + four[3]) + 0.375 * (four[1] + four[2]);
        }
    }
}

/// Multiplies a row by `kept` and adds that of the plane of the next level, twice as wide and high, by the weights 3 and 1.
#[inline(always)]
fn scale_and_double(row: &mut [f32], y: usize, margin: usize, kept: f32, coarse: Option<&Plane>) {
    match coarse {
        Some(coarse) => double_row(&tall_between(coarse, margin, y), first_of_next(margin), row, kept),
        None => row.iter_mut().for_each(|v| *v *= kept),
    }
}

/// Blends a plane with the plane of the next level, twice as wide and high, by the parts that `onward` writes for each row.
pub(crate) fn double_blended(
    mut plane: Plane,
    coarse: &Plane,
    onward: impl Fn(usize, &mut [f32]) + Sync + Send,
) -> Plane {
    let (width, margin) = (plane.width, plane.margin);
    let level = SimdLevel::best();
    for_each_row(&mut plane.values, width, |y, row| {
        let mut parts = vec![0.0; width];
        onward(y, &mut parts);
        if parts.iter().all(|part| *part == 0.0) {
            return;
        }
        let mut doubled = vec![0.0; width];
        at_level!(level, simd => {
            let _ = simd;
            let tall = tall_between(coarse, margin, y);
            double_row(&tall, first_of_next(margin), &mut doubled, 0.0);
            blend(row, &doubled, &parts);
        });
    });
    plane
}

#[inline(always)]
fn blend(row: &mut [f32], other: &[f32], parts: &[f32]) {
    for ((value, other), part) in row.iter_mut().zip(other).zip(parts) {
        *value += part * (other - *value);
    }
}

/// The pixel of the next level in which the first one of this level lies, both counted with their margins.
fn first_of_next(margin: usize) -> usize {
    MARGIN - margin / 2
}

/// A row of the next level at the height of a row of this one: between the two that it lies between.
#[inline(always)]
fn tall_between(coarse: &Plane, margin: usize, y: usize) -> Vec<f32> {
    let near = (first_of_next(margin) + y / 2) as isize;
    let far = if y.is_multiple_of(2) { near - 1 } else { near + 1 };
    let (near, far) = (coarse.row(near), coarse.row(far));
    near.iter().zip(far).map(|(near, far)| 0.75 * near + 0.25 * far).collect()
}

/// `first` is the value of `tall` for the first two pixels of the row; there are more before and behind, since levels have margins.
#[inline(always)]
fn double_row(tall: &[f32], first: usize, row: &mut [f32], kept: f32) {
    let pairs = row.len() / 2;
    let three = &tall[first - 1..];
    let (wholes, rest) = row.as_chunks_mut::<2>();
    for (pair, three) in wholes.iter_mut().zip(three.windows(3)) {
        let middle = 0.75 * three[1];
        pair[0] = pair[0] * kept + (middle + 0.25 * three[0]);
        pair[1] = pair[1] * kept + (middle + 0.25 * three[2]);
    }
    if let [last] = rest {
        *last = *last * kept + (0.75 * three[pairs + 1] + 0.25 * three[pairs]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(size: usize) -> Plane {
        let mut plane = Plane::zero(size, size, 0);
        plane.values[size / 2 * size + size / 2] = 1.0;
        plane
    }

    /// The variance of what a point becomes, along x.
    fn variance(plane: &Plane) -> f64 {
        let middle = (plane.width / 2) as f64;
        let (mut sum, mut second) = (0.0, 0.0);
        for y in 0..plane.height {
            for (x, value) in plane.row(y as isize).iter().enumerate() {
                sum += f64::from(*value);
                second += f64::from(*value) * (x as f64 - middle) * (x as f64 - middle);
            }
        }
        assert!((sum - 1.0).abs() < 1e-4, "light is lost: {sum}");
        second / sum
    }

    #[test]
    fn blurs_have_the_width_that_was_asked_for() {
        for sigma in [0.4, 0.9, 1.5, 2.3, 3.0, 4.7, 6.0, 9.5, 13.0] {
            let blurred = blurred(point(160), 0.0, &[Blur { weight: 1.0, sigma_px: sigma }], None);
            let found = libm::sqrt(variance(&blurred));
            // A point on the coarse grid lies up to a quarter of a pixel of the level off its middle.
            assert!((found / sigma - 1.0).abs() < 0.01, "{sigma}: {found}");
        }
    }

    #[test]
    fn uniform_light_stays_uniform() {
        let plane = Plane::of(vec![0.7; 53 * 37], 53);
        let blurs = [0.8, 3.0, 10.0, 50.0, 400.0].map(|sigma_px| Blur { weight: 0.15, sigma_px });
        let blurred = blurred(plane, 0.25, &blurs, None);
        assert!(blurred.values.iter().all(|v| (v - 0.7).abs() < 1e-6));
    }

    #[test]
    fn halves_are_the_same_inside_and_at_the_edge() {
        for (width, first) in [(1, -24), (2, -24), (7, -24), (40, -12), (41, -12), (64, 0)] {
            let tall: Vec<f32> = (0..width).map(|x| ((x * 37) % 11) as f32).collect();
            let mut row = vec![0.0; width + 24];
            halve_row(&tall, first, &mut row);
            for (x, found) in row.iter().enumerate() {
                let at = |d: isize| tall[(first + 2 * x as isize + d).clamp(0, width as isize - 1) as usize];
                let expected = 0.125 * (at(-1) + at(2)) + 0.375 * (at(0) + at(1));
                assert_eq!(*found, expected, "{width}, {first}: {x}");
            }
        }
    }

    #[test]
    fn a_sum_is_the_sum_of_its_blurs() {
        let plane = point(64);
        let blurs = [(0.3, 1.4), (0.2, 5.0), (0.1, 5.5)].map(|(weight, sigma_px)| Blur { weight, sigma_px });
        let together = blurred(plane.clone(), 0.4, &blurs, None);
        let mut sum = blurred(plane.clone(), 0.4, &[], None);
        for blur in blurs {
            let one = blurred(plane.clone(), 0.0, &[blur], None);
            sum.values.iter_mut().zip(&one.values).for_each(|(sum, value)| *sum += value);
        }
        for (a, b) in together.values.iter().zip(&sum.values) {
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
}
