//! Which samples of a tile a triangle covers, and how deep it is there.
//!
//! Corners are on a grid of 1/256 pixel and edge functions are integers, so that two triangles with a
//! common edge cover every sample on it exactly once (the top-left rule). A tile is gone through in
//! blocks of sixteen pixels: a row of sixteen blocks is tested at once for those that the triangle may
//! touch, and these are tested pixel by pixel.

use crate::cpu::block::{self, COLUMNS, DOWN, Grid, RIGHT, SIDE};
use crate::cpu::geometry::bins::TILE_WIDTH;
use crate::cpu::geometry::clip::fixed;
use crate::cpu::geometry::screen::{SMALL, Screen};
use crate::view::samples::SUBPIXEL;
use fearless_simd::{Simd, SimdBase, SimdMask, i32x16};
use glanz_math::inline::inlined;
use glanz_math::inline::three;
use glanz_math::{Lanes, LanesMask, Real};

/// A triangle on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    pub screen: [Screen; 3],
    /// Its name among all triangles, by which equal depths are decided.
    pub name: u32,
    /// The same, or the name of the extra triangle that it is.
    pub key: u32,
}

/// The depth of a triangle as a plane over the screen, limited to the range of its corners: at the
/// first samples of a row of blocks, and from there on within a block.
struct Depth<S: Simd> {
    y0: f32,
    q0: f32,
    slope: f32,
    across: Lanes<S>,
    within: Lanes<S>,
    range: [Lanes<S>; 2],
    row: [f32; COLUMNS],
}

impl<S: Simd> Depth<S> {
    #[inline(always)]
    fn new(simd: S, [a, b, c]: &[Screen; 3], grid: &Grid) -> Self {
        let (x1, y1, q1) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        let (x2, y2, q2) = (c[0] - a[0], c[1] - a[1], c[2] - a[2]);
        let inverse = 1.0 / (x1 * y2 - y1 * x2);
        let slope = [(q1 * y2 - q2 * y1) * inverse, (q2 * x1 - q1 * x2) * inverse];
        let range = [Real::min(Real::min(a[2], b[2]), c[2]), Real::max(Real::max(a[2], b[2]), c[2])];
        let splat = inlined(
            #[inline(always)]
            |v: f32| Lanes::splat(simd, v),
        );
        let first = Lanes::load(simd, &STEPS) + splat(grid.center(0, 0));
        Self {
            y0: a[1],
            q0: a[2],
            slope: slope[1],
            across: (first - splat(a[0])) * splat(slope[0]),
            within: Lanes::load(simd, &RIGHT) * splat(slope[0]) + Lanes::load(simd, &DOWN) * splat(slope[1]),
            range: range.map(splat),
            row: [0.0; COLUMNS],
        }
    }

    /// Goes to a row of blocks.
    #[inline(always)]
    fn enter(&mut self, simd: S, grid: &Grid, row: usize) {
        let base = self.q0 + (grid.center(row * SIDE, 1) - self.y0) * self.slope;
        (self.across + Lanes::splat(simd, base)).store(&mut self.row);
    }

    /// The depths in a block of the row.
    #[inline(always)]
    fn block(&self, simd: S, column: usize) -> Lanes<S> {
        let depth = Lanes::splat(simd, self.row[column]) + self.within;
        depth.max(self.range[0]).min(self.range[1])
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

    /// First and last pixel of the tile, in its own coordinates, whose sample may be covered.
    #[inline(always)]
    fn pixels(&self, grid: &Grid, axis: usize) -> [i32; 2] {
        let origin = grid.origin[axis] as i32;
        let first = (self.low[axis] + SUBPIXEL - 1 - grid.sample[axis]) >> 8;
        let last = (self.high[axis] - grid.sample[axis]) >> 8;
        [(first - origin).max(0), (last - origin).min(grid.size[axis] as i32 - 1)]
    }
}

/// Calls `visit(place, inside, depth)` for each block in which samples may be covered, where `place` is
/// that of the block in the tile's arrays, and `inside` tells which samples are covered: possibly none,
/// and possibly some beyond the border of the picture.
#[inline(always)]
pub(crate) fn cover<S: Simd>(
    simd: S,
    triangle: &Triangle,
    cull_back: bool,
    grid: &Grid,
    mut visit: impl FnMut(usize, LanesMask<S>, Lanes<S>),
) {
    let Some(edges) = Edges::new(&triangle.screen, cull_back) else { return };
    let [left, right] = edges.pixels(grid, 0);
    let [top, bottom] = edges.pixels(grid, 1);
    if left > right || top > bottom {
        return;
    }
    let side = SIDE as i32;
    let columns = (2 << (right / side)) - (1 << (left / side));
    let rows = (top / side) as usize..(bottom / side) as usize + 1;
    let mut depth = Depth::new(simd, &triangle.screen, grid);
    if !edges.small {
        cover_large(simd, &edges, grid, [left, right, top, bottom], &mut depth, visit);
        return;
    }
    let mut small = Small::new(simd, &edges, grid, rows.start);
    for row in rows {
        let mut touched = small.touched(simd) & columns;
        if touched != 0 {
            small.enter();
            depth.enter(simd, grid, row);
        }
        while touched != 0 {
            let column = touched.trailing_zeros() as usize & (COLUMNS - 1);
            touched &= touched - 1;
            visit(block::place(column, row), small.inside(simd, column), depth.block(simd, column));
        }
        small.go_down();
    }
}

const STEPS: [f32; COLUMNS] =
    [0.0, 4.0, 8.0, 12.0, 16.0, 20.0, 24.0, 28.0, 32.0, 36.0, 40.0, 44.0, 48.0, 52.0, 56.0, 60.0];

const INDICES: [i32; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];

/// A triangle of up to 64 pixels: edge functions of sixteen blocks, then of sixteen pixels, in 32 bits.
struct Small<S: Simd> {
    /// The greatest value of each edge function in each block of a row.
    greatest: [i32x16<S>; 3],
    /// What it gains from one row of blocks to the next.
    down: [i32x16<S>; 3],
    /// How far below the greatest value each pixel of a block is; no number above 0.
    within: [i32x16<S>; 3],
    row: [[i32; COLUMNS]; 3],
}

impl<S: Simd> Small<S> {
    #[inline(always)]
    fn new(simd: S, edges: &Edges, grid: &Grid, row: usize) -> Self {
        const BLOCK_STEP: i32 = SIDE as i32 * SUBPIXEL;
        let int = inlined(
            #[inline(always)]
            |v: i32| simd.splat_i32x16(v),
        );
        let indices = i32x16::from_slice(simd, &INDICES);
        let (right, down) = (indices & int(SIDE as i32 - 1), indices >> 2);
        let (x, y) = (grid.fixed(0, 0), grid.fixed(row * SIDE, 1));
        // What the edge function of this direction gains within a block at most.
        let reach = inlined(
            #[inline(always)]
            |[dx, dy]: [i32; 2]| (dx.max(0) - dy.min(0)) * (BLOCK_STEP - SUBPIXEL),
        );
        let greatest = three(
            edges.edges,
            #[inline(always)]
            |([ax, ay], [dx, dy], bias)| {
                let corner = dx * (y - ay) - dy * (x - ax) + bias + reach([dx, dy]);
                int(corner) - indices * int(dy * BLOCK_STEP)
            },
        );
        let within = three(
            edges.edges,
            #[inline(always)]
            |(_, [dx, dy], _)| down * int(dx * SUBPIXEL) - right * int(dy * SUBPIXEL) - int(reach([dx, dy])),
        );
        let down = three(
            edges.edges,
            #[inline(always)]
            |(_, d, _)| int(d[0] * BLOCK_STEP),
        );
        Self { greatest, down, within, row: [[0; COLUMNS]; 3] }
    }

    /// Bit i: the i-th block of the row may be touched.
    #[inline(always)]
    fn touched(&self, simd: S) -> u32 {
        let [a, b, c] = self.greatest;
        !(simd.simd_lt_i32x16(a | b | c, simd.splat_i32x16(0)).to_bitmask() as u32)
    }

    /// Makes the row's values readable block by block.
    #[inline(always)]
    fn enter(&mut self) {
        for edge in 0..3 {
            self.greatest[edge].store_slice(&mut self.row[edge]);
        }
    }

    /// Which pixels of a block are inside.
    #[inline(always)]
    fn inside(&self, simd: S, column: usize) -> LanesMask<S> {
        let [a, b, c] = three(
            [0, 1, 2],
            #[inline(always)]
            |edge: usize| simd.splat_i32x16(self.row[edge][column]) + self.within[edge],
        );
        LanesMask(simd.simd_ge_i32x16(a | b | c, simd.splat_i32x16(0)))
    }

    #[inline(always)]
    fn go_down(&mut self) {
        for edge in 0..3 {
            self.greatest[edge] += self.down[edge];
        }
    }
}

/// A triangle of any size: four rows of pixels as words of 64 bits, one for each pixel of the tile.
#[inline(always)]
fn cover_large<S: Simd>(
    simd: S,
    edges: &Edges,
    grid: &Grid,
    [left, right, top, bottom]: [i32; 4],
    depth: &mut Depth<S>,
    mut visit: impl FnMut(usize, LanesMask<S>, Lanes<S>),
) {
    for row in top as usize / SIDE..bottom as usize / SIDE + 1 {
        let mut words = [0u64; SIDE];
        for (i, word) in words.iter_mut().enumerate() {
            let y = (row * SIDE + i) as i32;
            if (top..=bottom).contains(&y) {
                *word = span(edges, grid, y as usize, [left, right]);
            }
        }
        let mut touched = words.iter().fold(0, |all, word| all | word);
        if touched != 0 {
            depth.enter(simd, grid, row);
        }
        while touched != 0 {
            let column = (touched.trailing_zeros() as usize / SIDE) & (COLUMNS - 1);
            let nibble = SIDE * column;
            touched &= !(0xf << nibble);
            let bits = (0..SIDE).fold(0, |bits, i| bits | (words[i] >> nibble & 0xf) << (SIDE * i));
            let inside = LanesMask::from_bits(simd, bits as u32);
            visit(block::place(column, row), inside, depth.block(simd, column));
        }
    }
}

/// The pixels of a row that are inside, from the edges by exact division.
#[inline(always)]
fn span(edges: &Edges, grid: &Grid, row: usize, [left, right]: [i32; 2]) -> u64 {
    let (x, y) = (i64::from(grid.fixed(0, 0)), i64::from(grid.fixed(row, 1)));
    let (mut first, mut last) = (i64::from(left), i64::from(right));
    for ([ax, ay], [dx, dy], bias) in edges.edges {
        let (dx, dy) = (i64::from(dx), i64::from(dy));
        let value = dx * (y - i64::from(ay)) - dy * (x - i64::from(ax)) + i64::from(bias);
        // value − dy·256·column >= 0
        let step = dy * i64::from(SUBPIXEL);
        match step {
            0 if value < 0 => return 0,
            0 => {}
            1.. => last = last.min(value.div_euclid(step)),
            _ => first = first.max(-(value.div_euclid(-step))),
        }
    }
    if first > last {
        return 0;
    }
    u64::MAX >> (TILE_WIDTH as i64 - 1 - (last - first)) << first
}
