//! Blocks of four by four pixels: the sixteen lanes of the pixel loop.
//!
//! A square block sees fewer triangles than a row of sixteen pixels does. All arrays over a tile's
//! pixels are in the order of its blocks, row by row, and within a block again row by row, so that the
//! pixels of a block are neighbours in memory.

use fearless_simd::Simd;
use glanz_math::Lanes;

use crate::cpu::geometry::bins::TILE_WIDTH;
use crate::view::samples::SUBPIXEL;

/// Pixels of a block.
pub(crate) const BLOCK: usize = 16;
/// Pixels along the side of a block.
pub(crate) const SIDE: usize = 4;
/// Blocks that stand side by side in a tile.
pub(crate) const COLUMNS: usize = TILE_WIDTH / SIDE;

/// How far to the right each pixel of a block is.
pub(crate) const RIGHT: [f32; BLOCK] =
    [0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0, 0.0, 1.0, 2.0, 3.0];
/// How far down each pixel of a block is.
pub(crate) const DOWN: [f32; BLOCK] =
    [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0];

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
    /// The sample of a pixel of the tile, in 1/256 pixel of the picture.
    #[inline(always)]
    pub(super) fn fixed(&self, pixel: usize, axis: usize) -> i32 {
        (self.origin[axis] + pixel) as i32 * SUBPIXEL + self.sample[axis]
    }

    /// The same in pixels.
    #[inline(always)]
    pub(super) fn center(&self, pixel: usize, axis: usize) -> f32 {
        (self.origin[axis] + pixel) as f32 + self.sample[axis] as f32 * (1.0 / SUBPIXEL as f32)
    }
}

/// Column and row in the tile of the pixel at a place of the tile's arrays.
pub(crate) fn pixel(place: usize) -> [usize; 2] {
    let (block, lane) = (place / BLOCK, place % BLOCK);
    [block % COLUMNS * SIDE + lane % SIDE, block / COLUMNS * SIDE + lane / SIDE]
}

/// Picture coordinates of the pixels of the block that begins at a place of the tile's arrays, at a
/// point within each.
#[inline(always)]
pub(crate) fn coordinates<S: Simd>(simd: S, grid: &Grid, place: usize, at: [f32; 2]) -> [Lanes<S>; 2] {
    let block = place / BLOCK;
    let x = (grid.origin[0] + block % COLUMNS * SIDE) as f32 + at[0];
    let y = (grid.origin[1] + block / COLUMNS * SIDE) as f32 + at[1];
    [Lanes::load(simd, &RIGHT) + Lanes::splat(simd, x), Lanes::load(simd, &DOWN) + Lanes::splat(simd, y)]
}

/// Where the block begins that is the `column`-th of the `row`-th row of blocks.
#[inline(always)]
pub(crate) fn place(column: usize, row: usize) -> usize {
    (row * COLUMNS + column) * BLOCK
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cpu::geometry::bins::TILE_PIXELS;

    #[test]
    fn every_pixel_of_a_tile_has_one_place() {
        let mut seen = vec![false; TILE_PIXELS];
        for at in 0..TILE_PIXELS {
            let [column, row] = pixel(at);
            let lane = at % BLOCK;
            assert_eq!(place(column / SIDE, row / SIDE) + lane, at);
            assert_eq!([RIGHT[lane], DOWN[lane]], [(column % SIDE) as f32, (row % SIDE) as f32]);
            assert!(!core::mem::replace(&mut seen[row * TILE_WIDTH + column], true));
        }
    }
}
