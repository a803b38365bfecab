//! Blurring an environment map to a chain of widths.
//!
//! Each level is the mean of the level before over a ring of a few points: the kernel at √2 times the width is nearly
//! that mean. The radius of the ring follows from the mean cosines of both kernels and from what reading between pixels
//! blurs by itself. The widest levels are sums over all of a coarse map.

use glanz_math::{PI, SimdLevel, at_level};

use crate::parallel;
use crate::prepare::data::{ChainLevel, EnvironmentChain, EnvironmentMap};

/// The most rows of a level, and the fewest of the map that the chain begins with.
const MOST_ROWS: usize = 512;
const FEWEST_ROWS: usize = 64;

/// Pixels of a level in its standard deviation, at least.
const PIXELS_IN_WIDTH: f64 = 2.7;

/// From this place on, levels are sums over all of a map of so many rows.
const SUMMED: usize = 14;
const SUMMED_ROWS: usize = 32;

/// From this place on, rings have 12 points rather than 6.
const FINE_RINGS: usize = 11;

/// How much of a level that is a whole octave wider comes from the middle of the ring: a ring alone would be too light in
/// the tails. The first of them is narrower still.
const IN_MIDDLE: [f64; 2] = [0.2, 0.27];

/// A level that is made: its pixels, as those of [`EnvironmentChain`].
#[derive(Clone, Copy)]
struct Picture<'a> {
    width: usize,
    height: usize,
    pixels: &'a [[f32; 4]],
}

impl Picture<'_> {
    /// A row with its first and last pixel there twice.
    fn row(&self, row: usize) -> &[[f32; 4]] {
        let stride = self.width + 2;
        &self.pixels[row * stride..(row + 1) * stride]
    }
}

/// The chain of a map.
pub(crate) fn chain(map: &EnvironmentMap) -> EnvironmentChain {
    let mut base = None;
    while base.as_ref().unwrap_or(map).height >= 2 * MOST_ROWS {
        base = Some(base.as_ref().unwrap_or(map).halved());
    }
    let is_mean = base.is_some();
    if map.height < FEWEST_ROWS {
        base = Some(EnvironmentMap::from_fn(2 * FEWEST_ROWS, FEWEST_ROWS, |[x, y, z]| {
            map.at(glanz_math::Vec3::new(x as f32, y as f32, z as f32))
        }));
    }
    let base = base.as_ref().unwrap_or(map);
    let levels = levels(base.width, base.height);
    let count = |level: &ChainLevel| level.stride() * (level.height + 1);
    let mut pixels = vec![[0.0; 4]; levels.iter().map(count).sum()];
    let pixel = PI / base.height as f64;
    // How much of a blur is in the pixels of the last level, as 1 less the mean cosine.
    let mut blur = if is_mean { pixel * pixel / 12.0 } else { 0.0 };
    let mut cells = Vec::new();
    let places: Vec<usize> = EnvironmentChain::places().collect();
    let mut rest = pixels.as_mut_slice();
    let mut last: Option<(Picture, usize)> = None;
    for (level, place) in levels.iter().zip(places) {
        let (own, others) = rest.split_at_mut(count(level));
        rest = others;
        match last {
            None => padded(base, own),
            Some(_) if place >= SUMMED => summed(&cells, place, own),
            Some((before, at)) => blur = next(&before, own, level.height, [at, place], blur),
        }
        finish(own, level.width, level.height);
        let picture = Picture { width: level.width, height: level.height, pixels: own };
        if place == 0 {
            cells = coarse(&picture);
        }
        last = Some((picture, place));
    }
    EnvironmentChain { levels, pixels }
}

/// The sizes of all levels of a map of this size.
fn levels(width: usize, height: usize) -> Vec<ChainLevel> {
    let mut first = 0;
    let level = |place: usize| {
        let (width, height) = match place {
            0 => (width, height),
            _ if place >= SUMMED => (2 * SUMMED_ROWS, SUMMED_ROWS),
            _ => {
                let rows = rows(EnvironmentChain::width(place as f64)).min(height);
                (2 * rows, rows)
            }
        };
        let level = ChainLevel { width, height, first };
        first += level.stride() * (height + 1);
        level
    };
    EnvironmentChain::places().map(level).collect()
}

/// 1 less the mean cosine of the kernel of a width.
fn one_less_cosine(width: f64) -> f64 {
    let squared = 10.0 * width * width;
    let least = (1.0 - 4.0 / squared).max(0.0);
    let mean = 0.8 * (1.0 - least.powi(5)) / (1.0 - least.powi(4));
    0.5 * squared * (1.0 - mean)
}

/// Rows that a width needs.
fn rows(width: f64) -> usize {
    let mut rows = MOST_ROWS;
    while rows > FEWEST_ROWS && PI / (rows / 2) as f64 * PIXELS_IN_WIDTH < width {
        rows /= 2;
    }
    rows
}

/// Makes the level at a place of the one at the place before; gives how much of a blur is in its pixels.
fn next(
    last: &Picture,
    pixels: &mut [[f32; 4]],
    height: usize,
    [before, place]: [usize; 2],
    last_blur: f64,
) -> f64 {
    let read = |rows: usize| (PI / rows as f64).powi(2) / 6.0;
    let blur = one_less_cosine(EnvironmentChain::width(place as f64)) - read(height);
    let in_middle = match place - before {
        2 => IN_MIDDLE[usize::from(place > 2)],
        _ => 0.0,
    };
    let step = 1.0 - (1.0 - blur) / (1.0 - last_blur - read(last.height));
    if step <= 0.0 && last.pixels.len() == pixels.len() {
        pixels.copy_from_slice(last.pixels);
        return last_blur;
    }
    let count = if place < FINE_RINGS { 6 } else { 12 };
    // Turned half a step from level to level, so that points do not lie over each other.
    let turn = |i: usize| (i as f64 + 0.5 * (place % 2) as f64) / count as f64 * 2.0 * PI;
    let ring = Ring {
        cosine: (1.0 - step.max(0.0) / (1.0 - in_middle)).max(-1.0),
        turns: (0..count).map(|i| libm::sincos(turn(i))).collect(),
        weight: (1.0 - in_middle) / count as f64,
        in_middle,
    };
    ringed(last, &ring, pixels, height);
    blur
}

/// Points at one angle around each direction.
struct Ring {
    cosine: f64,
    /// Sine and cosine of the azimuth of each.
    turns: Vec<(f64, f64)>,
    weight: f64,
    in_middle: f64,
}

/// A place in another map's pixels for a row: columns to the right, and rows from the first one's centre.
#[derive(Clone, Copy)]
struct Tap {
    columns: f64,
    row: f64,
    weight: f64,
}

/// The mean of a map over a ring around the direction of each pixel.
fn ringed(of: &Picture, ring: &Ring, pixels: &mut [[f32; 4]], height: usize) {
    let stride = 2 * height + 2;
    parallel::chunks(&mut pixels[..stride * height], stride, |row, line| {
        let theta = (row as f64 + 0.5) / height as f64 * PI;
        let taps: Vec<Tap> = taps(of, ring, theta);
        at_level!(SimdLevel::best(), _simd => add_taps(of, &taps, line));
    });
}

/// Where the points of a ring are for a row at a polar angle.
fn taps(of: &Picture, ring: &Ring, theta: f64) -> Vec<Tap> {
    let (sin, cos) = libm::sincos(theta);
    let radius = libm::sqrt((1.0 - ring.cosine * ring.cosine).max(0.0));
    let tap = |across: f64, up: f64, along: f64, weight: f64| Tap {
        columns: libm::atan2(across, up) / (2.0 * PI) * of.width as f64,
        row: libm::acos(along.clamp(-1.0, 1.0)) / PI * of.height as f64 - 0.5,
        weight,
    };
    let around = ring.turns.iter().map(|(turn_sin, turn_cos)| {
        // Away from the pole, and around it.
        let away = ring.cosine * sin + radius * turn_cos * cos;
        tap(radius * turn_sin, away, ring.cosine * cos - radius * turn_cos * sin, ring.weight)
    });
    let middle = (ring.in_middle > 0.0).then(|| tap(0.0, 1.0, cos, ring.in_middle));
    around.chain(middle).collect()
}

/// Adds what the points of a ring see to a row, without its ends that are there twice.
#[inline(always)]
fn add_taps(of: &Picture, taps: &[Tap], line: &mut [[f32; 4]]) {
    let width = line.len() - 2;
    let mut mixed = vec![[0.0f32; 4]; of.width + 2];
    for tap in taps {
        let row = tap.row.clamp(0.0, (of.height - 1) as f64);
        let (upper, t) = (row as usize, (row - libm::floor(row)) as f32);
        let (upper, lower) = (of.row(upper), of.row((upper + 1).min(of.height - 1)));
        let lines = mixed.as_flattened_mut().iter_mut().zip(upper.as_flattened()).zip(lower.as_flattened());
        for ((mixed, a), b) in lines {
            *mixed = a + (b - a) * t;
        }
        if width == of.width {
            shifted(&mixed, tap, line);
        } else {
            resampled(&mixed, tap, line);
        }
    }
}

/// Adds a row that is as long, some columns on.
#[inline(always)]
fn shifted(of: &[[f32; 4]], tap: &Tap, line: &mut [[f32; 4]]) {
    let width = line.len() - 2;
    let whole = libm::floor(tap.columns);
    let t = tap.columns - whole;
    let shift = (whole as i64).rem_euclid(width as i64) as usize;
    let (left, right) = ((tap.weight * (1.0 - t)) as f32, (tap.weight * t) as f32);
    let (head, tail) = line[1..=width].split_at_mut(width - shift);
    for (line, from) in [(head, 1 + shift), (tail, 1)] {
        let count = 4 * line.len();
        let first = &of.as_flattened()[4 * from..][..count];
        let second = &of.as_flattened()[4 * (from + 1)..][..count];
        for ((sum, a), b) in line.as_flattened_mut().iter_mut().zip(first).zip(second) {
            *sum += left * a + right * b;
        }
    }
}

/// Adds a row of another length.
#[inline(always)]
fn resampled(of: &[[f32; 4]], tap: &Tap, line: &mut [[f32; 4]]) {
    let (width, from) = (line.len() - 2, of.len() - 2);
    let ratio = from as f64 / width as f64;
    let weight = tap.weight as f32;
    let whole_step = ratio == libm::floor(ratio);
    let start = 0.5 * ratio - 0.5 + tap.columns;
    let (first, t) = (libm::floor(start), (start - libm::floor(start)) as f32);
    for (column, sum) in line[1..=width].iter_mut().enumerate() {
        let (place, t) = match whole_step {
            true => (first as i64 + column as i64 * ratio as i64, t),
            false => {
                let at = start + column as f64 * ratio;
                (libm::floor(at) as i64, (at - libm::floor(at)) as f32)
            }
        };
        let left = place.rem_euclid(from as i64) as usize + 1;
        for c in 0..4 {
            sum[c] += weight * (of[left][c] + (of[left + 1][c] - of[left][c]) * t);
        }
    }
}

/// Fills in what is there twice.
fn finish(pixels: &mut [[f32; 4]], width: usize, height: usize) {
    let stride = width + 2;
    for line in pixels.chunks_exact_mut(stride) {
        (line[0], line[width + 1]) = (line[width], line[1]);
    }
    pixels.copy_within(stride * (height - 1)..stride * height, stride * height);
}

fn padded(map: &EnvironmentMap, pixels: &mut [[f32; 4]]) {
    let stride = map.width + 2;
    parallel::chunks(&mut pixels[..stride * map.height], stride, |row, line| {
        let own = &map.pixels[row * map.width..(row + 1) * map.width];
        for (to, [r, g, b]) in line[1..].iter_mut().zip(own) {
            *to = [*r, *g, *b, 0.0];
        }
    });
}

/// The means of a map over its pixels in the cells of a coarse one, by the solid angle of each, times the cell's.
fn coarse(map: &Picture) -> Vec<[f64; 3]> {
    let (width, height) = (2 * SUMMED_ROWS, SUMMED_ROWS);
    let edge = |row: usize| libm::cos(PI * row as f64 / map.height as f64);
    let line = |of: usize| {
        let mut sums = vec![[0.0f64; 3]; width];
        for row in of * map.height / height..((of + 1) * map.height / height) {
            let solid = (edge(row) - edge(row + 1)) * 2.0 * PI / map.width as f64;
            for (column, pixel) in map.row(row)[1..=map.width].iter().enumerate() {
                let sum = &mut sums[column * width / map.width];
                for c in 0..3 {
                    sum[c] += solid * f64::from(pixel[c]);
                }
            }
        }
        sums
    };
    parallel::collect(height, line).concat()
}

/// The level at a place as a sum over all of a coarse map.
fn summed(coarse: &[[f64; 3]], place: usize, pixels: &mut [[f32; 4]]) {
    let (width, height) = (2 * SUMMED_ROWS, SUMMED_ROWS);
    let squared_width = EnvironmentChain::width(place as f64).powi(2);
    // What the coarse map and reading between pixels blur by themselves.
    let own = (PI / height as f64).powi(2) * (1.0 / 12.0 + 1.0 / 6.0);
    let reach = 10.0 * (squared_width - own);
    let angle = |row: usize| libm::sincos((row as f64 + 0.5) / height as f64 * PI);
    let turns: Vec<f64> = (0..width).map(|i| libm::cos(2.0 * PI * i as f64 / width as f64)).collect();
    let stride = width + 2;
    let solid = |row: usize| {
        let edge = |row: usize| libm::cos(PI * row as f64 / height as f64);
        (edge(row) - edge(row + 1)) * 2.0 * PI / width as f64
    };
    parallel::chunks(&mut pixels[..stride * height], stride, |row, line| {
        let (sin, cos) = angle(row);
        let mut sums = [[0.0f64; 2 * SUMMED_ROWS]; 3];
        let mut total = 0.0;
        for of in 0..height {
            let (other_sin, other_cos) = angle(of);
            let kernel = |turn: &f64| {
                let chord = 2.0 - 2.0 * (cos * other_cos + sin * other_sin * turn);
                (1.0 - chord / reach).max(0.0).powi(3)
            };
            let mut kernel: Vec<f64> = turns.iter().map(kernel).collect();
            total += kernel.iter().sum::<f64>() * solid(of);
            // Twice, so that it can begin at each column.
            kernel.extend_from_within(..);
            let lights = &coarse[of * width..(of + 1) * width];
            at_level!(SimdLevel::best(), _simd => add_row(&mut sums, &kernel, lights));
        }
        let [red, green, blue] = sums;
        for (column, pixel) in line[1..=width].iter_mut().enumerate() {
            *pixel = [red[column], green[column], blue[column], 0.0].map(|sum| (sum / total) as f32);
        }
    });
}

/// Adds a row of lights, each by a kernel that begins at its column.
#[inline(always)]
fn add_row(sums: &mut [[f64; 2 * SUMMED_ROWS]; 3], kernel: &[f64], lights: &[[f64; 3]]) {
    for (column, light) in lights.iter().enumerate() {
        let kernel = &kernel[lights.len() - column..][..lights.len()];
        for (sums, light) in sums.iter_mut().zip(light) {
            for (sum, weight) in sums.iter_mut().zip(kernel) {
                *sum += weight * light;
            }
        }
    }
}
