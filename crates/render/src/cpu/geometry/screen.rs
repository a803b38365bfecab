//! Places on the screen.

use crate::view::samples::SUBPIXEL;

/// Screen positions beyond this many pixels from the corner are clipped, so that fixed-point numbers
/// keep their range.
pub(crate) const GUARD: f32 = 30_000.0;

/// Triangles smaller than this (in 1/256 pixel) have edge functions that fit 32 bits.
pub(crate) const SMALL: i32 = 64 * SUBPIXEL;

/// A projected vertex: x and y in pixels, then a depth that is linear on the screen and greater when
/// nearer: 1/distance in perspective, −distance else. NaN marks a vertex that must be clipped. The
/// fourth entry is not used.
pub(crate) type Screen = [f32; 4];

/// The least and greatest coordinate of the samples of a pixel.
#[inline(always)]
pub(crate) fn sample_range(samples: &[[i32; 2]], axis: usize) -> (i32, i32) {
    samples.iter().fold((SUBPIXEL, 0), |(low, high), s| (low.min(s[axis]), high.max(s[axis])))
}
