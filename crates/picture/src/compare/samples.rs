//! Pictures for tests, of whole numbers, so that another program can make the same ones.

use glanz_color::srgb_decode;

use super::{Pair, Picture, Scale};

pub(super) const WIDTH: usize = 40;
pub(super) const HEIGHT: usize = 30;

/// 40×30 pixels of light.
pub(super) fn light(value: impl Fn(i64, i64, i64) -> f64) -> Picture {
    let at = |i: usize, channel: i64| value((i % WIDTH) as i64, (i / WIDTH) as i64, channel);
    let plane = |channel| (0..WIDTH * HEIGHT).map(|i| at(i, channel) as f32).collect();
    picture((WIDTH, HEIGHT), [0, 1, 2].map(plane), Scale::Light)
}

/// 40×30 pixels of 8-bit codes.
pub(super) fn codes(code: impl Fn(i64, i64, i64) -> i64) -> Picture {
    let decoded = light(|x, y, c| f64::from(srgb_decode((code(x, y, c) as f64 / 255.0) as f32)));
    Picture { scale: Scale::Codes, ..decoded }
}

/// A picture of these planes.
pub(super) fn picture((width, height): (usize, usize), rgb: [Vec<f32>; 3], scale: Scale) -> Picture {
    Picture { width, height, rgb, scale, notes: Vec::new() }
}

/// A grey picture of one row, of codes.
pub(super) fn greys(codes: &[f32]) -> Picture {
    let plane: Vec<f32> = codes.iter().map(|code| srgb_decode(*code)).collect();
    picture((codes.len(), 1), [plane.clone(), plane.clone(), plane], Scale::Codes)
}

pub(super) fn pair(reference: Picture, test: Picture) -> Pair {
    Pair::new(reference, test, false).unwrap()
}

pub(super) fn noise(seed: i64) -> Picture {
    codes(|x, y, c| (x * x * 31 + y * y * 17 + x * y * (13 + seed) + c * 97 + seed * 59) % 256)
}

pub(super) fn ramp(seed: i64) -> Picture {
    codes(|x, y, c| (x * 6 + y * 2 * i64::from(c == 1) + 40 * i64::from(c == 2) * seed) % 256)
}

pub(super) fn edge(seed: i64) -> Picture {
    codes(|x, y, c| if x + y / 2 < 18 + seed { 40 + c * 30 } else { 200 - c * 50 })
}

pub(super) fn flat(color: [i64; 3]) -> Picture {
    codes(|_, _, c| color[c as usize])
}

pub(super) fn dot() -> Picture {
    codes(|x, y, _| if (x, y) == (20, 15) { 255 } else { 128 })
}

/// A bright disc, a dark strip and a ramp between: luminances over four decades.
pub(super) fn sun(x: i64, y: i64, c: i64) -> f64 {
    let base = ((x * 7 + y * 5 + c * 11) % 64 + 1) as f64 / 64.0;
    let sun = if (x - 25) * (x - 25) + (y - 10) * (y - 10) < 16 { 64.0 } else { 1.0 };
    base * sun * if x < 12 { 0.03125 } else { 1.0 }
}
