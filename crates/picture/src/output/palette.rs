//! Pictures of 256 colours: a palette for each, and ordered dithering between its colours.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use color_quant::NeuQuant;

/// The most colours of a frame, one of which may stand for transparent pixels.
const COLORS: usize = 256;
/// Of how many pixels one is looked at when a palette is made: of all.
const EVERY: i32 = 1;
/// The most colours that are kept for many pixels that have them.
const MOST_FLAT: usize = 64;
/// The greatest amplitude of dithering, in codes: more would be seen as a pattern.
const MOST: f32 = 24.0;
/// Bayer's matrix of 8×8 is made of the bits of x and y; it has no mean.
const SIDE: usize = 8;

/// A frame of at most 256 colours.
pub(super) struct Indexed {
    /// Red, green and blue of each colour.
    pub palette: Vec<u8>,
    /// The number of each pixel's colour.
    pub pixels: Vec<u8>,
    /// The colour that stands for transparent pixels.
    pub transparent: Option<u8>,
}

/// Finds a palette for RGBA pixels, in rows of this width, whose alpha is 0 or 255. Few colours are kept as they are, and
/// those of many that are frequent; all others are dithered, as strongly as the palette is coarse, so that slopes of colour
/// do not break up into patches.
pub(super) fn indexed(rgba: &[u8], width: usize) -> Indexed {
    let counts = counts(rgba);
    let has_holes = rgba.chunks_exact(4).any(|p| p[3] == 0);
    let room = COLORS - usize::from(has_holes);
    if counts.len() <= room {
        return exact_frame(rgba, counts.into_keys().collect(), has_holes);
    }
    let flat = frequent(&counts);
    // Each of the others counts once, however many pixels have it.
    let others = counts.into_keys().filter(|color| flat.binary_search(color).is_err());
    let others: Vec<u8> = others.flat_map(|[r, g, b]| [r, g, b, 255]).collect();
    let palette = NeuQuant::new(EVERY, room - flat.len(), &others);
    let amplitude = (3.0 * mean_error(&palette, &others)).clamp(2.0, MOST);
    let hole = has_holes.then_some(room as u8);
    let pixel = |(i, p): (usize, &[u8])| {
        let color = [p[0], p[1], p[2]];
        if p[3] == 0 {
            return hole.unwrap_or_default();
        }
        if let Ok(number) = flat.binary_search(&color) {
            return number as u8;
        }
        // Another phase for each channel: the palette is as coarse across grey as along it.
        let (x, y) = (i % width, i / width);
        let shifted = [(p[0], x, y), (p[1], x + 3, y + 5), (p[2], x + 5, y + 2)]
            .map(|(code, x, y)| (f32::from(code) + amplitude * offset(x, y)).round().clamp(0.0, 255.0) as u8);
        (flat.len() + palette.index_of(&[shifted[0], shifted[1], shifted[2], 255])) as u8
    };
    let pixels = rgba.chunks_exact(4).enumerate().map(pixel).collect();
    let mut colors = flat.as_flattened().to_vec();
    colors.extend(palette.color_map_rgb());
    colors.extend(hole.iter().flat_map(|_| [0; 3]));
    Indexed { palette: colors, pixels, transparent: hole }
}

/// The colours of the pixels that are opaque, and how many have each.
fn counts(rgba: &[u8]) -> BTreeMap<[u8; 3], usize> {
    let mut counts = BTreeMap::new();
    for pixel in rgba.chunks_exact(4).filter(|p| p[3] != 0) {
        *counts.entry([pixel[0], pixel[1], pixel[2]]).or_insert(0) += 1;
    }
    counts
}

/// The colours that many pixels have, a flat background before all, in order.
fn frequent(counts: &BTreeMap<[u8; 3], usize>) -> Vec<[u8; 3]> {
    let total: usize = counts.values().sum();
    let mut many: Vec<_> = counts.iter().filter(|(_, count)| **count * COLORS > total).collect();
    many.sort_by_key(|(color, count)| (Reverse(**count), **color));
    many.truncate(MOST_FLAT);
    let mut colors: Vec<_> = many.into_iter().map(|(color, _)| *color).collect();
    colors.sort_unstable();
    colors
}

fn exact_frame(rgba: &[u8], list: Vec<[u8; 3]>, has_holes: bool) -> Indexed {
    let hole = has_holes.then_some(list.len() as u8);
    let pixel = |p: &[u8]| match p[3] {
        0 => hole.unwrap_or_default(),
        _ => list.binary_search(&[p[0], p[1], p[2]]).unwrap_or_default() as u8,
    };
    let pixels = rgba.chunks_exact(4).map(pixel).collect();
    let palette = list.iter().flatten().copied().chain(hole.iter().flat_map(|_| [0; 3])).collect();
    Indexed { palette, pixels, transparent: hole }
}

/// How far a channel of the pixels is from that of the nearest colour, on average of a few thousand that are not of the
/// palette.
fn mean_error(palette: &NeuQuant, opaque: &[u8]) -> f32 {
    let step = (opaque.len() / 4 / 4096).max(1);
    let (mut sum, mut count) = (0_u64, 0_u64);
    for pixel in opaque.chunks_exact(4).step_by(step) {
        let near = palette.lookup(palette.index_of(pixel)).unwrap_or_default();
        let error: u64 = pixel.iter().zip(near).take(3).map(|(a, b)| u64::from(a.abs_diff(b))).sum();
        sum += error;
        count += if error > 0 { 3 } else { 0 };
    }
    sum as f32 / count.max(1) as f32
}

/// Bayer's pattern, −1/2 to 1/2: the bits of y and of x xor y in turn, the lowest first.
fn offset(x: usize, y: usize) -> f32 {
    let (mixed, y) = ((x ^ y) % SIDE, y % SIDE);
    let order = (0..3).fold(0, |order, bit| order << 2 | (mixed >> bit & 1) << 1 | (y >> bit & 1));
    (order as f32 + 0.5) / (SIDE * SIDE) as f32 - 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: usize = 96;

    /// A slope of colour, as between the corners of a triangle.
    fn slope() -> Vec<u8> {
        let pixel = |i: usize| {
            let (x, y) = (i % WIDTH, i / WIDTH);
            [255 - 2 * x as u8, 30 + 2 * y as u8, (x + y) as u8, 255]
        };
        (0..WIDTH * WIDTH).flat_map(pixel).collect()
    }

    /// How far a channel is off on average in blocks of 8×8 pixels, whose codes are added before they are compared.
    fn off_by(rgba: &[u8], shown: impl Fn(usize) -> [u8; 3]) -> f64 {
        let blocks = (WIDTH / 8) * (WIDTH / 8);
        let of_block = |block: usize, c: usize| {
            let (left, top) = (block % (WIDTH / 8) * 8, block / (WIDTH / 8) * 8);
            let places = (0..64).map(|i| (top + i / 8) * WIDTH + left + i % 8);
            let sum: f64 = places.map(|at| f64::from(rgba[4 * at + c]) - f64::from(shown(at)[c])).sum();
            (sum / 64.0).abs()
        };
        (0..blocks).flat_map(|block| (0..3).map(move |c| of_block(block, c))).sum::<f64>()
            / (3 * blocks) as f64
    }

    #[test]
    fn dithering_keeps_the_means_of_a_slope_of_colour() {
        let rgba = slope();
        let frame = indexed(&rgba, WIDTH);
        let dithered = off_by(&rgba, |at| {
            let color = &frame.palette[3 * usize::from(frame.pixels[at])..];
            [color[0], color[1], color[2]]
        });
        let palette = NeuQuant::new(EVERY, COLORS, &rgba);
        let plain = off_by(&rgba, |at| {
            let color = palette.lookup(palette.index_of(&rgba[4 * at..4 * at + 4])).unwrap();
            [color[0], color[1], color[2]]
        });
        assert!(dithered < plain, "{dithered} with dithering, {plain} without");
    }

    #[test]
    fn a_flat_background_takes_nothing_from_a_slope_of_colour() {
        let alone = slope();
        let before_grey = [alone.clone(), [64, 62, 80, 255].repeat(WIDTH * WIDTH * 8)].concat();
        let off = |rgba: &[u8]| {
            let frame = indexed(rgba, WIDTH);
            off_by(&alone, |at| {
                let color = &frame.palette[3 * usize::from(frame.pixels[at])..];
                [color[0], color[1], color[2]]
            })
        };
        let (own, with_grey) = (off(&alone), off(&before_grey));
        assert!(with_grey < 1.1 * own, "{with_grey} before grey, {own} alone");
        let frame = indexed(&before_grey, WIDTH);
        let last = 3 * usize::from(frame.pixels[frame.pixels.len() - 1]);
        assert_eq!(frame.palette[last..last + 3], [64, 62, 80], "grey stays flat");
    }

    #[test]
    fn few_colours_are_kept_as_they_are() {
        let rgba: Vec<u8> = (0..64_u8).flat_map(|i| [i, 2 * i, 255 - i, 255]).collect();
        let frame = indexed(&rgba, 8);
        for (pixel, number) in rgba.chunks_exact(4).zip(&frame.pixels) {
            assert_eq!(pixel[..3], frame.palette[3 * usize::from(*number)..][..3]);
        }
        assert_eq!(frame.transparent, None);
    }

    #[test]
    fn holes_have_a_colour_of_their_own() {
        let mut rgba = slope();
        rgba[3] = 0;
        let frame = indexed(&rgba, WIDTH);
        assert_eq!(Some(frame.pixels[0]), frame.transparent);
        assert!(frame.pixels[1..].iter().all(|number| Some(*number) != frame.transparent));
        assert!(frame.palette.len() <= 768);
    }

    #[test]
    fn nothing_but_holes_is_a_frame() {
        let frame = indexed(&[0; 64], 4);
        assert_eq!((frame.pixels.len(), frame.transparent), (16, Some(0)));
    }
}
