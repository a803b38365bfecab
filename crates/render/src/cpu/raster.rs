//! Which samples of a tile a triangle covers, and how deep it is there.
//!
//! Corners are on a grid of 1/256 pixel and edge functions are integers, so that two triangles with a
//! common edge cover every sample on it exactly once (the top-left rule).

use fearless_simd::{Simd, SimdBase, SimdMask, i32x16};
use glanz_math::{Lanes, Real};

use super::bins::{TILE_HEIGHT, TILE_WIDTH};
use super::clip::fixed;
use super::geometry::{SMALL, Screen};
use super::samples::SUBPIXEL;
use super::{inlined, three};

/// A triangle on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    pub screen: [Screen; 3],
    /// Its name among all triangles, by which equal depths are decided.
    pub name: u32,
    /// The same, or the name of the extra triangle that it is.
    pub key: u32,
}

/// The depth of a triangle as a plane over the screen, limited to the range of its corners.
#[derive(Clone, Copy, Debug)]
struct DepthPlane {
    x0: f32,
    y0: f32,
    q0: f32,
    slope: [f32; 2],
    range: [f32; 2],
}

impl DepthPlane {
    #[inline(always)]
    fn new([a, b, c]: &[Screen; 3]) -> Self {
        let (x1, y1, q1) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        let (x2, y2, q2) = (c[0] - a[0], c[1] - a[1], c[2] - a[2]);
        let inverse = 1.0 / (x1 * y2 - y1 * x2);
        let slope = [(q1 * y2 - q2 * y1) * inverse, (q2 * x1 - q1 * x2) * inverse];
        let range = [Real::min(Real::min(a[2], b[2]), c[2]), Real::max(Real::max(a[2], b[2]), c[2])];
        Self { x0: a[0], y0: a[1], q0: a[2], slope, range }
    }

    #[inline(always)]
    fn at<R: Real>(&self, x: R, y: f32) -> R {
        let splat = inlined(
            #[inline(always)]
            |v: f32| x.lit(f64::from(v)),
        );
        let base = self.q0 + (y - self.y0) * self.slope[1];
        let depth = (x - splat(self.x0)) * splat(self.slope[0]) + splat(base);
        depth.max(splat(self.range[0])).min(splat(self.range[1]))
    }
}

/// The tile's place in the picture, and which sample of each pixel is looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    /// Left and top pixel of the tile.
    pub origin: [usize; 2],
    /// Columns and rows of the tile that are in the picture.
    pub size: [usize; 2],
    /// The sample's place in the pixel, in 1/256.
    pub sample: [i32; 2],
}

impl Grid {
    /// The sample of a pixel of the tile, in pixels of the picture.
    #[inline(always)]
    fn center(&self, pixel: usize, axis: usize) -> f32 {
        (self.origin[axis] + pixel) as f32 + self.sample[axis] as f32 * (1.0 / SUBPIXEL as f32)
    }
}

/// The three edge functions of a triangle in 1/256 pixel, positive inside.
struct Edges {
    /// Corner, direction, and −1 where the edge does not own the samples on it.
    edges: [([i32; 2], [i32; 2], i32); 3],
    low: [i32; 2],
    high: [i32; 2],
    small: bool,
}

impl Edges {
    /// `None` for triangles without area.
    #[inline(always)]
    fn new(screen: &[Screen; 3], cull_back: bool) -> Option<Self> {
        let [a, mut b, mut c] = three(
            *screen,
            #[inline(always)]
            |v| [fixed(v[0]), fixed(v[1])],
        );
        let wide = |p: i32, q: i32| i64::from(p) - i64::from(q);
        let area = wide(b[0], a[0]) * wide(c[1], a[1]) - wide(b[1], a[1]) * wide(c[0], a[0]);
        if area == 0 || cull_back && area > 0 {
            return None;
        }
        if area < 0 {
            core::mem::swap(&mut b, &mut c);
        }
        let low = [a[0].min(b[0]).min(c[0]), a[1].min(b[1]).min(c[1])];
        let high = [a[0].max(b[0]).max(c[0]), a[1].max(b[1]).max(c[1])];
        let edge = inlined(
            #[inline(always)]
            |from: [i32; 2], to: [i32; 2]| {
                let d = [to[0] - from[0], to[1] - from[1]];
                let owns = d[1] < 0 || d[1] == 0 && d[0] > 0;
                (from, d, i32::from(owns) - 1)
            },
        );
        let small = (high[0] - low[0]).max(high[1] - low[1]) < SMALL;
        Some(Self { edges: [edge(a, b), edge(b, c), edge(c, a)], low, high, small })
    }

    /// Whether a small triangle covers the sample of this pixel of the picture.
    #[inline(always)]
    fn hold(&self, px: usize, py: usize, grid: &Grid) -> bool {
        let (x, y) = (px as i32 * SUBPIXEL + grid.sample[0], py as i32 * SUBPIXEL + grid.sample[1]);
        let mut outside = 0;
        for ([ax, ay], [dx, dy], bias) in self.edges {
            outside |= dx * (y - ay) - dy * (x - ax) + bias;
        }
        outside >= 0
    }

    /// First and last pixel of the tile, in its own coordinates, whose sample may be covered.
    #[inline(always)]
    fn pixels(&self, grid: &Grid, axis: usize) -> (i32, i32) {
        let origin = grid.origin[axis] as i32;
        let first = (self.low[axis] + SUBPIXEL - 1 - grid.sample[axis]) >> 8;
        let last = (self.high[axis] - grid.sample[axis]) >> 8;
        ((first - origin).max(0), (last - origin).min(grid.size[axis] as i32 - 1))
    }
}

/// Calls `visit(row, column, depth)` for each covered sample of a triangle within 2×2 pixels, and
/// returns true; returns false for greater ones. The same samples and depths as [`cover`] gives, but
/// cheaper for the dust that fine meshes are.
#[inline(always)]
pub(crate) fn cover_few(
    triangle: &Triangle,
    cull_back: bool,
    grid: &Grid,
    mut visit: impl FnMut(usize, usize, f32),
) -> bool {
    let Some(edges) = Edges::new(&triangle.screen, cull_back) else { return true };
    let (left, right) = edges.pixels(grid, 0);
    let (top, bottom) = edges.pixels(grid, 1);
    if !edges.small || right - left > 1 || bottom - top > 1 {
        return false;
    }
    for row in top..=bottom {
        for column in left..=right {
            let [px, py] = [grid.origin[0] + column as usize, grid.origin[1] + row as usize];
            if edges.hold(px, py, grid) {
                let plane = DepthPlane::new(&triangle.screen);
                let depth = plane.at(grid.center(column as usize, 0), grid.center(row as usize, 1));
                visit(row as usize, column as usize, depth);
            }
        }
    }
    true
}

/// Calls `visit(row, column, bits, depth)` for each run of 16 pixels in which samples are covered:
/// `bits` tells which. `column` is at most 48, so that the run stays in the tile.
#[inline(always)]
pub(crate) fn cover<S: Simd>(
    simd: S,
    triangle: &Triangle,
    cull_back: bool,
    grid: &Grid,
    mut visit: impl FnMut(usize, usize, u32, Lanes<S>),
) {
    let Some(edges) = Edges::new(&triangle.screen, cull_back) else { return };
    let (left, right) = edges.pixels(grid, 0);
    let (top, bottom) = edges.pixels(grid, 1);
    if left > right || top > bottom {
        return;
    }
    let plane = DepthPlane::new(&triangle.screen);
    let depth = inlined(
        #[inline(always)]
        |row: i32, column: i32| {
            let x = Lanes::load(simd, &STEPS) + Lanes::splat(simd, grid.center(column as usize, 0));
            plane.at(x, grid.center(row as usize, 1))
        },
    );
    debug_assert!(bottom < TILE_HEIGHT as i32 && right < TILE_WIDTH as i32);
    if edges.small {
        cover_small(
            simd,
            &edges,
            grid,
            [left, right, top, bottom],
            #[inline(always)]
            |row, column, bits| {
                visit(row as usize, column as usize, bits, depth(row, column));
            },
        );
    } else {
        cover_large(
            &edges,
            grid,
            [left, right, top, bottom],
            #[inline(always)]
            |row, column, bits| {
                visit(row as usize, column as usize, bits, depth(row, column));
            },
        );
    }
}

const STEPS: [f32; 16] =
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0];
const INDICES: [i32; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
const LAST_COLUMN: i32 = TILE_WIDTH as i32 - 16;

/// Up to 64 pixels: edge functions of 16 pixels at a time, in 32 bits.
#[inline(always)]
fn cover_small<S: Simd>(
    simd: S,
    edges: &Edges,
    grid: &Grid,
    [left, right, top, bottom]: [i32; 4],
    mut visit: impl FnMut(i32, i32, u32),
) {
    let indices = i32x16::from_slice(simd, &INDICES);
    let int = inlined(
        #[inline(always)]
        |v: i32| simd.splat_i32x16(v),
    );
    // The sample of the tile's first pixel.
    let [sx, sy] = [0, 1].map(|axis| grid.origin[axis] as i32 * SUBPIXEL + grid.sample[axis]);
    let columns = u64::MAX >> (TILE_WIDTH - grid.size[0]);
    let mut column = left.min(LAST_COLUMN);
    let mut fresh = columns;
    loop {
        let (x, y) = (sx + column * SUBPIXEL, sy + top * SUBPIXEL);
        let mut values = three(
            edges.edges,
            #[inline(always)]
            |([ax, ay], [dx, dy], bias)| {
                let corner = dx * (y - ay) - dy * (x - ax) + bias;
                int(corner) - indices * int(dy * SUBPIXEL)
            },
        );
        let steps = three(
            edges.edges,
            #[inline(always)]
            |(_, d, _)| int(d[0] * SUBPIXEL),
        );
        let inside = (fresh >> column) as u32 & 0xffff;
        for row in top..=bottom {
            let outside = values[0] | values[1] | values[2];
            let bits = !(simd.simd_lt_i32x16(outside, int(0)).to_bitmask() as u32) & inside;
            if bits != 0 {
                visit(row, column, bits);
            }
            for i in 0..3 {
                values[i] += steps[i];
            }
        }
        if column + 15 >= right {
            return;
        }
        // The last run of a row may overlap the one before it: its pixels are not visited again.
        fresh = columns & u64::MAX << (column + 16);
        column = (column + 16).min(LAST_COLUMN);
    }
}

/// Any size: the span of each row, from the edges by exact division.
#[inline(always)]
fn cover_large(
    edges: &Edges,
    grid: &Grid,
    [left, right, top, bottom]: [i32; 4],
    mut visit: impl FnMut(i32, i32, u32),
) {
    let [sx, sy] =
        [0, 1].map(|axis| grid.origin[axis] as i64 * i64::from(SUBPIXEL) + i64::from(grid.sample[axis]));
    for row in top..=bottom {
        let y = sy + i64::from(row * SUBPIXEL);
        let (mut first, mut last) = (i64::from(left), i64::from(right));
        for ([ax, ay], [dx, dy], bias) in edges.edges {
            let (dx, dy) = (i64::from(dx), i64::from(dy));
            let value = dx * (y - i64::from(ay)) - dy * (sx - i64::from(ax)) + i64::from(bias);
            // value − dy·256·column >= 0
            let step = dy * i64::from(SUBPIXEL);
            match step {
                0 if value < 0 => last = -1,
                0 => {}
                1.. => last = last.min(value.div_euclid(step)),
                _ => first = first.max(-(value.div_euclid(-step))),
            }
        }
        let (mut column, last) = (first, last);
        while column <= last {
            let start = column.min(i64::from(LAST_COLUMN));
            let end = last.min(start + 15);
            let bits = ((1u64 << (end - start + 1)) - 1) & !((1u64 << (column - start)) - 1);
            visit(row, start as i32, bits as u32);
            column = end + 1;
        }
    }
}
