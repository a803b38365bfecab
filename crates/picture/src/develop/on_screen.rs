//! Whole frames brought to linear sRGB.

use glanz_math::{SimdLevel, at_level};

use super::ToScreen;
use crate::Frame;

/// Pixels that are brought to the screen at a time.
const LANES: usize = 16;

/// Pixels of a task.
const PART: usize = 1 << 13;

/// Replaces the colours of a frame by linear sRGB: for each pixel [`ToScreen::apply`]. The bits do not depend on the
/// level.
pub(crate) fn to_screen_with(frame: &mut Frame, to_screen: &ToScreen, level: SimdLevel) {
    let Frame { rgb, more, .. } = frame;
    let columns = to_screen.columns();
    for_each_part(rgb, |start, planes| {
        at_level!(level, simd => {
            let _ = simd;
            part(columns, more, start, planes);
        });
    });
}

/// Calls `work` for parts of the three planes, and the number of the first pixel of each, in parallel where the
/// feature `rayon` is on.
fn for_each_part(planes: &mut [Vec<f32>; 3], work: impl Fn(usize, [&mut [f32]; 3]) + Sync + Send) {
    let [x, y, z] = planes;
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let parts = (x.par_chunks_mut(PART), y.par_chunks_mut(PART), z.par_chunks_mut(PART));
        parts.into_par_iter().enumerate().for_each(|(i, (x, y, z))| work(i * PART, [x, y, z]));
    }
    #[cfg(not(feature = "rayon"))]
    for (i, ((x, y), z)) in x.chunks_mut(PART).zip(y.chunks_mut(PART)).zip(z.chunks_mut(PART)).enumerate() {
        work(i * PART, [x, y, z]);
    }
}

/// Brings a part of a frame to the screen.
#[inline(always)]
fn part(columns: &[[f64; 3]], more: &[Vec<f32>], start: usize, [x, y, z]: [&mut [f32]; 3]) {
    for at in (0..x.len()).step_by(LANES) {
        let mut sums = [[0.0; LANES]; 3];
        for (i, column) in columns.iter().enumerate() {
            match i {
                0 => add(&mut sums, column, &load(x, at)),
                1 => add(&mut sums, column, &load(y, at)),
                2 => add(&mut sums, column, &load(z, at)),
                _ if i - 3 < more.len() => add(&mut sums, column, &load(&more[i - 3], start + at)),
                _ => {}
            }
        }
        store(&sums[0], x, at);
        store(&sums[1], y, at);
        store(&sums[2], z, at);
    }
}

/// Adds what one channel gives.
#[inline(always)]
fn add(sums: &mut [[f64; LANES]; 3], column: &[f64; 3], channel: &[f32; LANES]) {
    for (sums, c) in sums.iter_mut().zip(column) {
        for (sum, value) in sums.iter_mut().zip(channel) {
            *sum += c * f64::from(*value);
        }
    }
}

/// Sixteen values of a plane; beyond its end 0.
#[inline(always)]
fn load(plane: &[f32], at: usize) -> [f32; LANES] {
    if let Some(whole) = plane[at..].first_chunk() {
        return *whole;
    }
    let mut values = [0.0; LANES];
    let rest = &plane[at..];
    values[..rest.len()].copy_from_slice(rest);
    values
}

/// Writes as many of the values as the plane has left.
#[inline(always)]
fn store(values: &[f64; LANES], plane: &mut [f32], at: usize) {
    for (out, value) in plane[at..].iter_mut().zip(values) {
        *out = *value as f32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Meaning;

    #[test]
    fn every_level_gives_the_bits_of_one_pixel_after_the_other() {
        let count = PART + 37;
        let plane = |seed: usize| -> Vec<f32> {
            let value = |i: usize| match (i * 7919 + seed * 104_729) % 65_521 {
                0 => f32::INFINITY,
                k => k as f32 / 4000.0 - 2.0,
            };
            (0..count).map(value).collect()
        };
        for channels in 1..=5 {
            let column = |c: usize| [0.3 + c as f64, -0.7 / (1.0 + c as f64), 1e-3 * c as f64 + 0.1];
            let to_screen = ToScreen::of_columns(Meaning::Receptors, (0..channels).map(column));
            let rgb = [plane(1), plane(2), plane(3)];
            let more: Vec<Vec<f32>> = (3..channels).map(plane).collect();
            let frame = Frame { width: count, height: 1, rgb, more, ..Frame::default() };
            for (name, level) in SimdLevel::available() {
                let mut shown = frame.clone();
                to_screen_with(&mut shown, &to_screen, level);
                for i in 0..count {
                    let all = frame.rgb.iter().chain(&frame.more).map(|plane| plane[i]);
                    let found = [0, 1, 2].map(|c| shown.rgb[c][i].to_bits());
                    let expected = to_screen.apply(all).map(f32::to_bits);
                    assert_eq!(found, expected, "{name}, {channels} channels, pixel {i}");
                }
            }
        }
    }
}
