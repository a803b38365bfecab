//! One tile: visibility, then interpolation and shading, then out.

use fearless_simd::{Simd, SimdBase, SimdMask, u32x16};
use glanz_math::{Lanes, LanesMask, Real};
use glanz_scene::AlphaMode;

use super::bins::{TILE_HEIGHT, TILE_PIXELS, TILE_WIDTH};
use super::blend::{self, Fragment};
use super::clip::EXTRA;
use super::frame::{FrameView, Pass};
use super::group::{self, Shaded};
use super::raster::{Grid, Triangle, cover, cover_few};
use super::records::{Projected, Records};
use super::runs::{Layers, Run};
use super::samples::SUBPIXEL;
use super::target::{BLOCK, Band, Slot, TilePixels, backdrop};
use super::three;
use crate::Layers as PlaneChoice;

/// No triangle.
pub(crate) const NONE: u32 = u32::MAX;

/// Everything that drawing a tile needs beside the frame. Kept by each thread, for its memory.
#[derive(Debug, Default)]
pub(crate) struct TileScratch {
    /// Depth of the nearest surface, sample after sample.
    depth: Vec<f32>,
    /// Which of `triangles` it is.
    nearest: Vec<u32>,
    /// Triangles that are or were nearest somewhere, with their chunk and their record.
    triangles: Vec<(Triangle, usize, u32)>,
    records: Records,
    layers: Layers,
    fragments: Vec<Fragment>,
    pixels: TilePixels,
}

/// A tile's number and its part of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TilePlace {
    pub column: usize,
    pub row: usize,
}

impl TilePlace {
    fn grid(self, frame: &FrameView) -> Grid {
        let origin = [self.column * TILE_WIDTH, self.row * TILE_HEIGHT];
        let size =
            [TILE_WIDTH.min(frame.eye.width - origin[0]), TILE_HEIGHT.min(frame.eye.height - origin[1])];
        Grid { origin, size, sample: [SUBPIXEL / 2; 2] }
    }
}

/// Draws a tile into its band.
#[inline(always)]
pub(crate) fn draw<S: Simd>(
    simd: S,
    frame: &FrameView,
    projected: &Projected,
    place: TilePlace,
    scratch: &mut TileScratch,
    band: &mut Band,
) {
    let grid = place.grid(frame);
    let [left, top] = grid.origin;
    let slot = Slot { stride: frame.eye.width, left, top, size: grid.size };
    scratch.pixels.clear();
    let bins = |blended: bool| {
        projected.chunks.iter().enumerate().flat_map(move |(number, chunk)| {
            let bins = if blended { &chunk.blended } else { &chunk.solid };
            bins.of(place.column, place.row).iter().map(move |&key| (number, key))
        })
    };
    if bins(false).next().is_some() || bins(true).next().is_some() {
        scratch.clear(frame.samples.len());
        for (chunk, key) in bins(false) {
            scratch.see(simd, frame, projected, &grid, chunk, key);
        }
        scratch.shade_solid(simd, frame, projected, &grid);
        if bins(true).next().is_some() {
            for (chunk, key) in bins(true) {
                scratch.collect(simd, frame, projected, &grid, chunk, key);
            }
            let TileScratch { fragments, records, pixels, .. } = scratch;
            blend::blend(simd, frame, records, &grid, fragments, pixels);
        }
    }
    band.write(simd, &mut scratch.pixels, slot, frame.options.background);
}

fn triangle(frame: &FrameView, projected: &Projected, chunk: usize, key: u32) -> Triangle {
    if key & EXTRA != 0 {
        let extra = &projected.chunks[chunk].extras[(key & !EXTRA) as usize];
        return Triangle { screen: extra.screen, name: extra.original, key };
    }
    let geometry = &frame.prepared.geometry;
    let cluster = &geometry.clusters[(key >> 7) as usize];
    let corners = geometry.triangles[cluster.first_triangle as usize + (key & 127) as usize];
    let first = cluster.first_vertex as usize;
    Triangle {
        screen: three(
            corners,
            #[inline(always)]
            |v| projected.screen[first + v as usize],
        ),
        name: key,
        key,
    }
}

fn object_of(frame: &FrameView, triangle: &Triangle) -> usize {
    frame.prepared.geometry.clusters[(triangle.name >> 7) as usize].object as usize
}

impl TileScratch {
    fn clear(&mut self, samples: usize) {
        self.depth.clear();
        self.depth.resize(samples * TILE_PIXELS, f32::NEG_INFINITY);
        self.nearest.clear();
        self.nearest.resize(samples * TILE_PIXELS, NONE);
        self.triangles.clear();
        self.records.clear();
        self.fragments.clear();
    }

    /// Depth-tests an opaque or masked triangle.
    #[inline(always)]
    fn see<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        projected: &Projected,
        grid: &Grid,
        chunk: usize,
        key: u32,
    ) {
        let triangle = triangle(frame, projected, chunk, key);
        let object = object_of(frame, &triangle);
        let view = &frame.objects[object];
        let number = self.triangles.len() as u32;
        let mut used = false;
        let mut record = NONE;
        if view.pass == Pass::Masked {
            record = self.records.add(frame, projected, chunk, &triangle);
        }
        for (sample, &position) in frame.samples.iter().enumerate() {
            let grid = Grid { sample: position, ..*grid };
            let Self { depth, nearest, triangles, records, .. } = self;
            let plane = sample * TILE_PIXELS;
            if view.pass == Pass::Opaque
                && cover_few(
                    &triangle,
                    view.cull_back,
                    &grid,
                    #[inline(always)]
                    |row, column, z| {
                        let at = plane + row * TILE_WIDTH + column;
                        let wins = depth[at] < z
                            || depth[at] == z
                                && triangles
                                    .get(nearest[at] as usize)
                                    .is_some_and(|(other, ..)| triangle.name < other.name);
                        if wins {
                            used = true;
                            depth[at] = z;
                            nearest[at] = number;
                        }
                    },
                )
            {
                continue;
            }
            cover(
                simd,
                &triangle,
                view.cull_back,
                &grid,
                #[inline(always)]
                |row, column, bits, z| {
                    let at = sample * TILE_PIXELS + row * TILE_WIDTH + column;
                    let old: &mut [f32; 16] = (&mut depth[at..at + 16]).try_into().expect("sixteen pixels");
                    let owner: &mut [u32; 16] =
                        (&mut nearest[at..at + 16]).try_into().expect("sixteen pixels");
                    let before = Lanes::load(simd, old);
                    let mut bits =
                        bits & (before.lt(z).bits() | ties(simd, &triangle, triangles, owner, before, z));
                    if bits != 0 && view.pass == Pass::Masked {
                        bits &= opaque_enough(simd, frame, records, record, &grid, row, column);
                    }
                    if bits != 0 {
                        used = true;
                        let mask = LanesMask::from_bits(simd, bits);
                        z.select(mask, before).store(old);
                        write(simd, owner, number, mask);
                    }
                },
            );
        }
        if used {
            self.triangles.push((triangle, chunk, record));
        }
    }

    /// Notes where a blended triangle is in front of what is opaque.
    #[inline(always)]
    fn collect<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        projected: &Projected,
        grid: &Grid,
        chunk: usize,
        key: u32,
    ) {
        let triangle = triangle(frame, projected, chunk, key);
        let view = &frame.objects[object_of(frame, &triangle)];
        let record = self.records.list.len() as u32;
        let start = self.fragments.len();
        let share = 1.0 / frame.samples.len() as f32;
        for (sample, &position) in frame.samples.iter().enumerate() {
            let grid = Grid { sample: position, ..*grid };
            let Self { depth, fragments, .. } = self;
            cover(
                simd,
                &triangle,
                view.cull_back,
                &grid,
                #[inline(always)]
                |row, column, bits, z| {
                    let at = row * TILE_WIDTH + column;
                    let old = depth[sample * TILE_PIXELS + at..].first_chunk().expect("sixteen pixels");
                    let mut bits = bits & Lanes::load(simd, old).lt(z).bits();
                    let mut depths = [0.0; 16];
                    z.store(&mut depths);
                    while bits != 0 {
                        let lane = bits.trailing_zeros() as usize;
                        bits &= bits - 1;
                        let pixel = (at + lane) as u32;
                        fragments.push(Fragment {
                            pixel,
                            depth: depths[lane],
                            name: triangle.name,
                            record,
                            weight: share,
                        });
                    }
                },
            );
        }
        if self.fragments.len() > start {
            self.records.add(frame, projected, chunk, &triangle);
            blend::join_samples(&mut self.fragments, start);
        }
    }

    /// Shades what the depth test left, sixteen pixels at a time.
    #[inline(always)]
    fn shade_solid<S: Simd>(&mut self, simd: S, frame: &FrameView, projected: &Projected, grid: &Grid) {
        let mut runs = [Run { record: 0, bits: 0 }; BLOCK];
        for row in 0..grid.size[1] {
            for column in (0..grid.size[0]).step_by(BLOCK) {
                let at = row * TILE_WIDTH + column;
                if frame.samples.len() == 1 {
                    let count = self.find_runs(simd, frame, projected, at, &mut runs);
                    if count > 0 {
                        self.shade_single(simd, frame, grid, [row, column], &runs[..count]);
                    }
                    continue;
                }
                self.layers.clear();
                self.find_layers(simd, frame, projected, at);
                if !self.layers.list.is_empty() {
                    self.shade_layers(simd, frame, grid, row, column);
                }
            }
        }
    }

    /// Which triangles sixteen samples see, from place `start` of the sample planes on; sets those up
    /// that are new. Returns how many there are.
    #[inline(always)]
    fn find_runs<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        projected: &Projected,
        start: usize,
        runs: &mut [Run; BLOCK],
    ) -> usize {
        let row: &[u32; BLOCK] = self.nearest[start..].first_chunk().expect("tiles are rows of blocks");
        let owners = u32x16::from_slice(simd, row);
        let mut left = simd.simd_ne_u32x16(owners, simd.splat_u32x16(NONE)).to_bitmask() as u32;
        let mut count = 0;
        while left != 0 {
            let number = row[left.trailing_zeros() as usize];
            let same = simd.simd_eq_u32x16(owners, simd.splat_u32x16(number)).to_bitmask() as u32;
            let (triangle, chunk, record) = &mut self.triangles[number as usize];
            if *record == NONE {
                *record = self.records.add(frame, projected, *chunk, triangle);
            }
            runs[count] = Run { record: *record, bits: same };
            count += 1;
            left &= !same;
        }
        count
    }

    /// Collects what the samples of sixteen pixels see into layers.
    #[inline(always)]
    fn find_layers<S: Simd>(&mut self, simd: S, frame: &FrameView, projected: &Projected, at: usize) {
        let samples = frame.samples.len();
        let mut runs = [Run { record: 0, bits: 0 }; BLOCK];
        for sample in 0..samples {
            let count = self.find_runs(simd, frame, projected, sample * TILE_PIXELS + at, &mut runs);
            if count == 0 {
                continue;
            }
            if frame.options.supersample {
                let at = frame.samples[sample].map(|s| s as f32 / SUBPIXEL as f32);
                self.layers.add_sample(&runs[..count], 1.0 / samples as f32, at);
            } else {
                self.layers.note(&runs[..count]);
            }
        }
        if !frame.options.supersample {
            self.layers.pack(samples);
        }
    }

    /// One sample per pixel: a pixel is what its triangle is, or background.
    #[inline(always)]
    fn shade_single<S: Simd>(
        &mut self,
        simd: S,
        frame: &FrameView,
        grid: &Grid,
        [row, column]: [usize; 2],
        runs: &[Run],
    ) {
        let at = row * TILE_WIDTH + column;
        let place = pixel_lanes(simd, grid, row, column, [0.5, 0.5]);
        let mut shaded = Shaded::nothing(simd);
        group::shade(simd, frame, &self.records, runs, place, &mut shaded);
        let bits = runs.iter().fold(0, |bits, run| bits | run.bits);
        if frame.options.layers != PlaneChoice::default() {
            self.pixels.touch(at, frame.options.background);
            self.keep_planes(simd, &shaded, runs, bits, at);
        } else if bits == 0xffff {
            self.pixels.fill_whole(at);
        } else {
            self.pixels.touch(at, frame.options.background);
        }
        let mask = LanesMask::from_bits(simd, bits);
        let [r, g, b] = &mut self.pixels.rgb;
        put(simd, r, at, shaded.rgb[0], mask);
        put(simd, g, at, shaded.rgb[1], mask);
        put(simd, b, at, shaded.rgb[2], mask);
        put(simd, &mut self.pixels.alpha, at, Lanes::splat(simd, 1.0), mask);
    }

    /// Shades the layers of sixteen pixels and adds them up over the background.
    #[inline(always)]
    fn shade_layers<S: Simd>(&mut self, simd: S, frame: &FrameView, grid: &Grid, row: usize, column: usize) {
        let at = row * TILE_WIDTH + column;
        self.pixels.touch(at, frame.options.background);
        let zero = Lanes::splat(simd, 0.0);
        let mut sum = [zero; 3];
        let mut covered = zero;
        for number in 0..self.layers.list.len() {
            let layer = &self.layers.list[number];
            let runs = &self.layers.runs[layer.runs.clone()];
            let place = pixel_lanes(simd, grid, row, column, layer.at);
            let mut shaded = Shaded::nothing(simd);
            group::shade(simd, frame, &self.records, runs, place, &mut shaded);
            let weights = Lanes::load(simd, &layer.weights);
            let weights = weights.select(LanesMask::from_bits(simd, layer.bits), zero);
            for (sum, value) in sum.iter_mut().zip(shaded.rgb) {
                // Where the weight is zero the value may be anything, NaN too.
                *sum = (*sum + value * weights).select(zero.lt(weights), *sum);
            }
            covered = covered + weights;
            if frame.options.layers != PlaneChoice::default() {
                let (runs, bits) = (self.layers.runs[layer.runs.clone()].to_vec(), layer.bits);
                self.keep_planes(simd, &shaded, &runs, bits, at);
            }
        }
        let (background, alpha) = backdrop(frame.options.background);
        let rest = (zero.one() - covered).max(zero);
        for c in 0..3 {
            let plane = (&mut self.pixels.rgb[c][at..at + 16]).try_into().expect("sixteen pixels");
            (sum[c] + rest * Lanes::splat(simd, background[c])).store(plane);
        }
        let plane = (&mut self.pixels.alpha[at..at + 16]).try_into().expect("sixteen pixels");
        (covered + rest * Lanes::splat(simd, alpha)).store(plane);
    }

    /// Keeps distance, normal and object of the nearest layer.
    fn keep_planes<S: Simd>(&mut self, simd: S, shaded: &Shaded<S>, runs: &[Run], bits: u32, at: usize) {
        let old = self.pixels.distance[at..].first_chunk().expect("tiles are rows of blocks");
        let nearer = shaded.distance.lt(Lanes::load(simd, old)).bits() & bits;
        let kept = LanesMask::from_bits(simd, nearer);
        let normal = [shaded.normal.x, shaded.normal.y, shaded.normal.z];
        let planes = self.pixels.normal.iter_mut().zip(normal);
        for (plane, value) in planes.chain([(&mut self.pixels.distance, shaded.distance)]) {
            let plane = plane[at..].first_chunk_mut().expect("tiles are rows of blocks");
            value.select(kept, Lanes::load(simd, plane)).store(plane);
        }
        for run in runs {
            let number = self.records.list[run.record as usize].object + 1;
            for lane in (0..BLOCK).filter(|lane| (run.bits & nearer) >> lane & 1 == 1) {
                self.pixels.object[at + lane] = number;
            }
        }
    }
}

/// Picture coordinates of sixteen pixels of a tile, at a place within each.
#[inline(always)]
fn pixel_lanes<S: Simd>(simd: S, grid: &Grid, row: usize, column: usize, at: [f32; 2]) -> [Lanes<S>; 2] {
    const STEPS: [f32; 16] =
        [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0];
    let x = (grid.origin[0] + column) as f32 + at[0];
    let y = (grid.origin[1] + row) as f32 + at[1];
    [Lanes::load(simd, &STEPS) + Lanes::splat(simd, x), Lanes::splat(simd, y)]
}

/// Writes a block of a plane where the mask holds.
#[inline(always)]
fn put<S: Simd>(simd: S, plane: &mut [f32; TILE_PIXELS], at: usize, value: Lanes<S>, mask: LanesMask<S>) {
    let plane = plane[at..].first_chunk_mut().expect("tiles are rows of blocks");
    value.select(mask, Lanes::load(simd, plane)).store(plane);
}

/// Writes `number` where the mask holds.
#[inline(always)]
fn write<S: Simd>(simd: S, owner: &mut [u32; 16], number: u32, mask: LanesMask<S>) {
    use fearless_simd::Select;
    let old = u32x16::from_slice(simd, owner);
    let new: u32x16<S> = mask.0.select(simd.splat_u32x16(number), old);
    new.store_slice(owner);
}

/// Lanes where two triangles are equally deep and the new one has the smaller name.
#[inline(always)]
fn ties<S: Simd>(
    simd: S,
    triangle: &Triangle,
    triangles: &[(Triangle, usize, u32)],
    owner: &[u32; 16],
    before: Lanes<S>,
    z: Lanes<S>,
) -> u32 {
    let mut equal = simd.simd_eq_f32x16(before.0, z.0).to_bitmask() as u32;
    let mut won = 0;
    while equal != 0 {
        let lane = equal.trailing_zeros();
        equal &= equal - 1;
        // The triangle itself is not in the list while it is being drawn.
        let other = triangles.get(owner[lane as usize] as usize);
        won |= u32::from(other.is_some_and(|(other, ..)| triangle.name < other.name)) << lane;
    }
    won
}

/// Which of sixteen pixels a masked triangle is opaque enough at to be seen.
#[inline(always)]
fn opaque_enough<S: Simd>(
    simd: S,
    frame: &FrameView,
    records: &Records,
    record: u32,
    grid: &Grid,
    row: usize,
    column: usize,
) -> u32 {
    let object = &frame.objects[records.list[record as usize].object as usize];
    let AlphaMode::Mask { cutoff } = frame.materials[object.material].alpha_mode else { return u32::MAX };
    let place = pixel_lanes(simd, grid, row, column, [0.5, 0.5]);
    let mut shaded = Shaded::nothing(simd);
    group::shade(simd, frame, records, &[Run { record, bits: 0xffff }], place, &mut shaded);
    Lanes::splat(simd, cutoff).le(shaded.alpha).bits()
}
