//! Where finished blocks go.

use fearless_simd::{Select, Simd, SimdBase, u32x16};
use glanz_math::{Lanes, LanesMask, Real, SimdLevel, Twice, Vec3};

use crate::Develop;
use crate::cpu::block::Grid;
use crate::cpu::block::{self, BLOCK, SIDE};
use crate::cpu::geometry::bins::{TILE_PIXELS, TILE_WIDTH};
use crate::cpu::shading::background::ViewBackground;
use glanz_math::inline::inlined;
use glanz_picture::DevelopKernel;

/// The pixels of a tile, block by block: linear colour, coverage, and the planes that were asked for.
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
    /// Whether distance, normals and objects are asked for; else they hold anything.
    keeps_planes: bool,
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
            keeps_planes: false,
            touched: [false; TILE_PIXELS / BLOCK],
        }
    }
}

impl TilePixels {
    /// Forgets everything; from now on with planes beside colour and coverage, or without.
    pub(crate) fn clear(&mut self, keeps_planes: bool) {
        self.keeps_planes = keeps_planes;
        self.touched = [false; TILE_PIXELS / BLOCK];
    }

    /// Sees to it that the block of this place holds the background, or what was drawn since.
    #[inline(always)]
    pub(crate) fn touch<S: Simd>(&mut self, simd: S, background: &ViewBackground, grid: &Grid, place: usize) {
        let block = place / BLOCK;
        if self.touched[block] {
            return;
        }
        self.touched[block] = true;
        let range = block * BLOCK..(block + 1) * BLOCK;
        let (color, alpha) = background.block(simd, grid, block * BLOCK);
        self.put(block * BLOCK, color, alpha);
        if !self.keeps_planes {
            return;
        }
        self.distance[range.clone()].fill(f32::INFINITY);
        for plane in &mut self.normal {
            plane[range.clone()].fill(0.0);
        }
        self.object[range].fill(0);
    }

    /// Writes colour and coverage of a whole block.
    #[inline(always)]
    pub(crate) fn put<S: Simd>(&mut self, place: usize, rgb: [Lanes<S>; 3], alpha: Lanes<S>) {
        self.touched[place / BLOCK] = true;
        let store = inlined(
            #[inline(always)]
            |plane: &mut [f32; TILE_PIXELS], value: Lanes<S>| {
                value.store(plane[place..].first_chunk_mut().expect("tiles are whole blocks"));
            },
        );
        let [r, g, b] = &mut self.rgb;
        store(r, rgb[0]);
        store(g, rgb[1]);
        store(b, rgb[2]);
        store(&mut self.alpha, alpha);
    }

    /// Writes distance, normal and object of a whole block, where its pixels are covered by this one object.
    #[inline(always)]
    pub(crate) fn put_planes<S: Simd>(&mut self, place: usize, surface: &Surface<Lanes<S>>, covered: u32) {
        let simd = surface.distance.0.simd;
        let [zero, far] = [Lanes::splat(simd, 0.0), Lanes::splat(simd, f32::INFINITY)];
        let seen = surface.distance.lt(far) & LanesMask::from_bits(simd, covered);
        let store = inlined(
            #[inline(always)]
            |plane: &mut [f32], value: Lanes<S>| {
                value.store(plane[place..].first_chunk_mut().expect("tiles are whole blocks"));
            },
        );
        self.touched[place / BLOCK] = true;
        store(&mut self.distance, surface.distance.select(seen, far));
        let [nx, ny, nz] = &mut self.normal;
        store(nx, surface.normal.x.select(seen, zero));
        store(ny, surface.normal.y.select(seen, zero));
        store(nz, surface.normal.z.select(seen, zero));
        let numbers: u32x16<S> = seen.0.select(simd.splat_u32x16(surface.object), simd.splat_u32x16(0));
        numbers.store_slice(&mut self.object[place..place + BLOCK]);
    }

    #[inline(always)]
    fn touch_all<S: Simd>(&mut self, simd: S, background: &ViewBackground, grid: &Grid) {
        (0..TILE_PIXELS).step_by(BLOCK).for_each(
            #[inline(always)]
            |place| self.touch(simd, background, grid, place),
        );
    }
}

/// What a frame's planes hold of a surface beside its colour.
pub(crate) struct Surface<R> {
    pub distance: R,
    pub normal: Vec3<R>,
    /// 1 + the number of the object.
    pub object: u32,
}

/// Takes two blocks of opaque pixels that were shaded in step.
pub(crate) trait PairTarget {
    /// Takes both, each of which belongs to one of the places.
    fn put_pair<S: Simd>(
        &mut self,
        slot: &Slot,
        places: [usize; 2],
        rgb: [Twice<Lanes<S>>; 3],
        surface: &Surface<Twice<Lanes<S>>>,
    );
}

impl PairTarget for TilePixels {
    #[inline(always)]
    fn put_pair<S: Simd>(
        &mut self,
        _: &Slot,
        places: [usize; 2],
        [r, g, b]: [Twice<Lanes<S>>; 3],
        surface: &Surface<Twice<Lanes<S>>>,
    ) {
        let one = r.0.one();
        self.put(places[0], [r.0, g.0, b.0], one);
        self.put(places[1], [r.1, g.1, b.1], one);
        if self.keeps_planes {
            let Surface { distance, normal: Vec3 { x, y, z }, object } = *surface;
            let first = Surface { distance: distance.0, normal: Vec3::new(x.0, y.0, z.0), object };
            self.put_planes(places[0], &first, 0xffff);
            let second = Surface { distance: distance.1, normal: Vec3::new(x.1, y.1, z.1), object };
            self.put_planes(places[1], &second, 0xffff);
        }
    }
}

impl PairTarget for Codes<'_> {
    #[inline(always)]
    fn put_pair<S: Simd>(
        &mut self,
        slot: &Slot,
        places: [usize; 2],
        rgb: [Twice<Lanes<S>>; 3],
        _: &Surface<Twice<Lanes<S>>>,
    ) {
        self.put_two(slot, places, rgb);
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
    /// Colour and coverage of the background; none where an environment makes each pixel another.
    pub empty: Option<([f32; 3], f32)>,
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

impl Slot {
    /// Calls `work` with the places of the blocks that are in the picture, at least in part.
    #[inline(always)]
    pub(crate) fn for_each_block(&self, mut work: impl FnMut(usize)) {
        for row in 0..self.size[1].div_ceil(SIDE) {
            for column in 0..self.size[0].div_ceil(SIDE) {
                work(block::place(column, row));
            }
        }
    }
}

impl Band<'_> {
    /// Writes a tile.
    #[inline(always)]
    pub(crate) fn write<S: Simd>(
        &mut self,
        simd: S,
        pixels: &mut TilePixels,
        slot: Slot,
        (background, grid): (&ViewBackground, &Grid),
    ) {
        match self {
            Band::Codes(codes) => {
                if codes.empty.is_none() {
                    pixels.touch_all(simd, background, grid);
                }
                codes.write(simd, pixels, &slot);
            }
            Band::Planes(planes) => {
                pixels.touch_all(simd, background, grid);
                planes.write(pixels, slot);
            }
        }
    }

    /// Whether what is empty is the same everywhere, so that any number of tiles is written at once: a row of the
    /// picture after the other rather than of a tile, which is several times as fast.
    pub(crate) fn fills_empty(&self) -> bool {
        match self {
            Band::Codes(codes) => codes.empty.is_some(),
            Band::Planes(planes) => planes.empty.is_some(),
        }
    }

    /// Writes a tile in which nothing is; several side by side where [`Self::fills_empty`].
    #[inline(always)]
    pub(crate) fn write_empty<S: Simd>(
        &mut self,
        simd: S,
        pixels: &mut TilePixels,
        slot: Slot,
        behind: (&ViewBackground, &Grid),
    ) {
        match self {
            Band::Codes(Codes { out, empty: Some(empty), .. }) => {
                for row in 0..slot.size[1] {
                    let start = 4 * (row * slot.stride + slot.left);
                    let (whole, rest) = out[start..start + 4 * slot.size[0]].as_chunks_mut();
                    whole.fill(*empty);
                    rest.copy_from_slice(&empty[..rest.len()]);
                }
            }
            Band::Planes(planes) if planes.empty.is_some() => planes.fill(&slot),
            _ => self.write(simd, pixels, slot, behind),
        }
    }
}

impl Codes<'_> {
    #[inline(always)]
    fn write<S: Simd>(&mut self, simd: S, pixels: &TilePixels, slot: &Slot) {
        slot.for_each_block(
            #[inline(always)]
            |place| self.write_block(simd, pixels, slot, place),
        );
    }

    #[inline(always)]
    fn write_block<S: Simd>(&mut self, simd: S, pixels: &TilePixels, slot: &Slot, place: usize) {
        if !pixels.touched[place / BLOCK] && self.put_empty(slot, place) {
            return;
        }
        let lanes = inlined(
            #[inline(always)]
            |plane: &[f32; TILE_PIXELS]| {
                Lanes::load(simd, plane[place..].first_chunk().expect("tiles are whole blocks"))
            },
        );
        let [r, g, b] = &pixels.rgb;
        let rgb = [lanes(r), lanes(g), lanes(b)];
        if self.opaque {
            return self.put(slot, place, rgb);
        }
        let mut bytes = [0; 4 * BLOCK];
        let [column, row] = block::pixel(place);
        let at = [slot.left + column, slot.top + row];
        self.kernel.store_block_rgba(rgb, lanes(&pixels.alpha), at, &mut bytes);
        self.copy(slot, place, &bytes);
    }

    /// Develops a block of opaque pixels into its place.
    #[inline(always)]
    pub(crate) fn put<S: Simd>(&mut self, slot: &Slot, place: usize, rgb: [Lanes<S>; 3]) {
        let mut bytes = [0; 4 * BLOCK];
        let [column, row] = block::pixel(place);
        self.kernel.store_block(rgb, [slot.left + column, slot.top + row], &mut bytes);
        self.copy(slot, place, &bytes);
    }

    /// Develops two blocks of opaque pixels, in step, into their places.
    #[inline(always)]
    pub(crate) fn put_two<S: Simd>(&mut self, slot: &Slot, places: [usize; 2], rgb: [Twice<Lanes<S>>; 3]) {
        let mut bytes = [[0; 4 * BLOCK]; 2];
        let at = inlined(
            #[inline(always)]
            |place: usize| {
                let [column, row] = block::pixel(place);
                [slot.left + column, slot.top + row]
            },
        );
        self.kernel.store_two(rgb, [at(places[0]), at(places[1])], &mut bytes);
        self.copy(slot, places[0], &bytes[0]);
        self.copy(slot, places[1], &bytes[1]);
    }

    /// Writes a block of background, if it is the same everywhere.
    #[inline(always)]
    pub(crate) fn put_empty(&mut self, slot: &Slot, place: usize) -> bool {
        let Some(empty) = self.empty else { return false };
        self.copy(slot, place, &empty);
        true
    }

    #[inline(always)]
    fn copy(&mut self, slot: &Slot, place: usize, bytes: &[u8; 4 * BLOCK]) {
        const ROW: usize = 4 * SIDE;
        let [column, row] = block::pixel(place);
        let rows = SIDE.min(slot.size[1] - row);
        let length = ROW.min(4 * (slot.size[0] - column));
        let [a, b, c, d] = bytes.as_chunks::<ROW>().0 else { return };
        let (start, stride) = (4 * (row * slot.stride + slot.left + column), 4 * slot.stride);
        if rows == SIDE && length == ROW {
            for (i, bytes) in [a, b, c, d].into_iter().enumerate() {
                let out = self.out[start + i * stride..].first_chunk_mut();
                *out.expect("the block is in the picture") = *bytes;
            }
            return;
        }
        for (i, bytes) in [a, b, c, d].into_iter().enumerate().take(rows) {
            self.out[start + i * stride..][..length].copy_from_slice(&bytes[..length]);
        }
    }
}

/// A block of background codes, unless dithering makes each pixel another.
pub(crate) fn empty_block(
    develop: &Develop,
    kernel: &DevelopKernel,
    background: &ViewBackground,
) -> Option<[u8; 64]> {
    if develop.dither {
        return None;
    }
    let (color, alpha) = background.fixed()?;
    let mut block = [0; 4 * BLOCK];
    let simd = glanz_math::narrowest(SimdLevel::best().token());
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

    /// Fills a rectangle with the background.
    fn fill(&mut self, slot: &Slot) {
        let Some((color, alpha)) = self.empty else { return };
        for (plane, value) in self.rgb.iter_mut().zip(color) {
            fill(plane, value, slot);
        }
        fill(self.alpha, alpha, slot);
        fill(self.depth, f32::INFINITY, slot);
        for plane in &mut self.normal {
            fill(plane, 0.0, slot);
        }
        fill(self.object, 0, slot);
    }
}

/// Fills a rectangle of a plane; does nothing where the plane was not asked for.
fn fill<T: Copy>(out: &mut [T], value: T, slot: &Slot) {
    if out.is_empty() {
        return;
    }
    for row in 0..slot.size[1] {
        let start = row * slot.stride + slot.left;
        out[start..start + slot.size[0]].fill(value);
    }
}

/// Copies a tile's plane to its place; does nothing where the plane was not asked for.
fn copy<T: Copy>(out: &mut [T], tile: &[T], slot: Slot) {
    if out.is_empty() {
        return;
    }
    for row in 0..slot.size[1] {
        let start = row * slot.stride + slot.left;
        let blocks = &tile[block::place(0, row / SIDE)..][..TILE_WIDTH * SIDE];
        let mut rows =
            blocks.as_chunks::<BLOCK>().0.iter().map(|block| &block.as_chunks::<SIDE>().0[row % SIDE]);
        // Four values are one move of the processor as long as their number is known to the compiler.
        let (whole, rest) = out[start..start + slot.size[0]].as_chunks_mut::<SIDE>();
        whole.iter_mut().zip(&mut rows).for_each(|(out, four)| *out = *four);
        if let Some(four) = rows.next() {
            rest.copy_from_slice(&four[..rest.len()]);
        }
    }
}
