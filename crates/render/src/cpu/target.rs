//! Where finished tiles go.

use fearless_simd::Simd;
use glanz_math::Lanes;
use glanz_scene::Background;

use super::bins::{TILE_HEIGHT, TILE_PIXELS, TILE_WIDTH};
use super::inlined;
use crate::Develop;
use crate::develop::DevelopKernel;

/// Sixteen neighbouring pixels are a block; a tile is whole rows of them.
pub(crate) const BLOCK: usize = 16;

/// The pixels of a tile: linear colour, coverage, and the planes that were asked for.
///
/// Blocks are given their background when they are first touched, so that empty parts of the picture
/// cost next to nothing.
#[derive(Debug)]
pub(crate) struct TilePixels {
    pub rgb: [[f32; TILE_PIXELS]; 3],
    pub alpha: [f32; TILE_PIXELS],
    pub distance: Vec<f32>,
    pub normal: [Vec<f32>; 3],
    pub object: Vec<u32>,
    touched: [bool; TILE_PIXELS / BLOCK],
}

impl Default for TilePixels {
    fn default() -> Self {
        Self {
            rgb: [[0.0; TILE_PIXELS]; 3],
            alpha: [0.0; TILE_PIXELS],
            distance: vec![f32::INFINITY; TILE_PIXELS],
            normal: core::array::from_fn(|_| vec![0.0; TILE_PIXELS]),
            object: vec![0; TILE_PIXELS],
            touched: [false; TILE_PIXELS / BLOCK],
        }
    }
}

impl TilePixels {
    /// Forgets everything.
    pub fn clear(&mut self) {
        self.touched = [false; TILE_PIXELS / BLOCK];
    }

    /// Sees to it that the block of this pixel holds the background, or what was drawn since.
    #[inline(always)]
    pub fn touch(&mut self, pixel: usize, background: Background) {
        let block = pixel / BLOCK;
        if self.touched[block] {
            return;
        }
        self.touched[block] = true;
        let range = block * BLOCK..(block + 1) * BLOCK;
        let (color, alpha) = backdrop(background);
        for (plane, value) in self.rgb.iter_mut().zip(color) {
            plane[range.clone()].fill(value);
        }
        self.alpha[range.clone()].fill(alpha);
        self.distance[range.clone()].fill(f32::INFINITY);
        for plane in &mut self.normal {
            plane[range.clone()].fill(0.0);
        }
        self.object[range].fill(0);
    }

    /// Says that the block of this pixel is about to be written whole.
    #[inline(always)]
    pub fn fill_whole(&mut self, pixel: usize) {
        self.touched[pixel / BLOCK] = true;
    }

    fn touch_all(&mut self, background: Background) {
        (0..TILE_PIXELS).step_by(BLOCK).for_each(|pixel| self.touch(pixel, background));
    }
}

/// A band of the picture, one tile high: the part of the output that one task writes.
pub(crate) enum Band<'a> {
    /// 8-bit RGBA, developed.
    Codes(Codes<'a>),
    /// Linear planes.
    Planes(PlaneBand<'a>),
}

/// The rows of an 8-bit RGBA picture that belong to a band.
pub(crate) struct Codes<'a> {
    pub out: &'a mut [u8],
    pub kernel: &'a DevelopKernel,
    /// Whether alpha is 1 everywhere.
    pub opaque: bool,
    /// A block of background; none where dithering makes each pixel another.
    pub empty: Option<[u8; 4 * BLOCK]>,
}

/// The rows of a frame's planes that belong to a band; planes that were not asked for are empty.
#[derive(Default)]
pub(crate) struct PlaneBand<'a> {
    pub rgb: [&'a mut [f32]; 3],
    pub alpha: &'a mut [f32],
    pub depth: &'a mut [f32],
    pub normal: [&'a mut [f32]; 3],
    pub object: &'a mut [u32],
}

/// A tile's place in its band.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slot {
    /// Width of the picture.
    pub stride: usize,
    /// First column and first row in the picture.
    pub left: usize,
    pub top: usize,
    /// Columns and rows that are in the picture.
    pub size: [usize; 2],
}

/// What is where nothing is: colour and coverage.
#[inline(always)]
pub(crate) fn backdrop(background: Background) -> ([f32; 3], f32) {
    match background {
        Background::Color(color) => (color.0, 1.0),
        Background::Transparent => ([0.0; 3], 0.0),
    }
}

impl Band<'_> {
    /// Writes a tile.
    #[inline(always)]
    pub fn write<S: Simd>(&mut self, simd: S, pixels: &mut TilePixels, slot: Slot, background: Background) {
        match self {
            Band::Codes(codes) => {
                if codes.empty.is_none() {
                    pixels.touch_all(background);
                }
                write_codes(simd, codes, pixels, slot);
            }
            Band::Planes(planes) => {
                pixels.touch_all(background);
                planes.write(pixels, slot);
            }
        }
    }
}

#[inline(always)]
fn write_codes<S: Simd>(simd: S, codes: &mut Codes, pixels: &TilePixels, slot: Slot) {
    let mut sixteen = [0u8; 64];
    let untouched = codes.empty.as_ref().filter(|_| !pixels.touched.contains(&true));
    for row in 0..slot.size[1] {
        let start = 4 * (row * slot.stride + slot.left);
        let line = &mut codes.out[start..start + 4 * slot.size[0]];
        if let (Some(empty), (whole, [])) = (untouched, line.as_chunks_mut::<{ 4 * BLOCK }>()) {
            whole.fill(*empty);
            continue;
        }
        for (block, out) in line.chunks_mut(4 * BLOCK).enumerate() {
            let at = row * TILE_WIDTH + block * BLOCK;
            if let Some(empty) = codes.empty.as_ref().filter(|_| !pixels.touched[at / BLOCK]) {
                match <&mut [u8; 4 * BLOCK]>::try_from(&mut *out) {
                    Ok(whole) => *whole = *empty,
                    Err(_) => out.copy_from_slice(&empty[..out.len()]),
                }
                continue;
            }
            let lanes = inlined(
                #[inline(always)]
                |plane: &[f32; TILE_PIXELS]| {
                    Lanes::load(simd, plane[at..].first_chunk().expect("tiles are rows of whole blocks"))
                },
            );
            let rgb = [lanes(&pixels.rgb[0]), lanes(&pixels.rgb[1]), lanes(&pixels.rgb[2])];
            let (x, y) = (slot.left + block * BLOCK, slot.top + row);
            let whole = out.as_mut_array();
            let target = whole.unwrap_or(&mut sixteen);
            match codes.opaque {
                true => codes.kernel.store_opaque(rgb, x, y, target),
                false => codes.kernel.store_rgba(rgb, lanes(&pixels.alpha), x, y, target),
            }
            if out.len() < 64 {
                out.copy_from_slice(&sixteen[..out.len()]);
            }
        }
    }
}

/// A block of background codes, unless dithering makes each pixel another.
pub(crate) fn empty_block(
    develop: &Develop,
    kernel: &DevelopKernel,
    background: Background,
) -> Option<[u8; 64]> {
    if develop.dither {
        return None;
    }
    let (color, alpha) = backdrop(background);
    let mut block = [0; 4 * BLOCK];
    let simd = glanz_math::narrowest(fearless_simd::Level::baseline());
    let splat = |value| Lanes::splat(simd, value);
    kernel.store_rgba(color.map(splat), splat(alpha), 0, 0, &mut block);
    Some(block)
}

impl PlaneBand<'_> {
    fn write(&mut self, pixels: &TilePixels, slot: Slot) {
        let planes = self.rgb.iter_mut().zip(&pixels.rgb).chain([(&mut self.alpha, &pixels.alpha)]);
        for (out, plane) in planes {
            copy(out, plane, slot);
        }
        copy(self.depth, &pixels.distance, slot);
        for (out, plane) in self.normal.iter_mut().zip(&pixels.normal) {
            copy(out, plane, slot);
        }
        copy(self.object, &pixels.object, slot);
    }
}

/// Copies a tile's plane to its place; does nothing where the plane was not asked for.
fn copy<T: Copy>(out: &mut [T], tile: &[T], slot: Slot) {
    if out.is_empty() {
        return;
    }
    debug_assert!(slot.size[1] <= TILE_HEIGHT);
    for row in 0..slot.size[1] {
        let start = row * slot.stride + slot.left;
        let from = &tile[row * TILE_WIDTH..][..slot.size[0]];
        out[start..start + slot.size[0]].copy_from_slice(from);
    }
}
