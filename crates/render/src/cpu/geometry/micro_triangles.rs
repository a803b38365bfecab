//! Triangles of a few samples, which fine meshes are made of: sixteen of them are tested at once, and
//! what goes on to the tiles is not the triangle but each sample that it covers.

use fearless_simd::{Simd, SimdBase, i32x16};
use glanz_math::{Lanes, LanesMask, Real};

use crate::cpu::block::{BLOCK, COLUMNS, SIDE};
use crate::cpu::frame::FrameView;
use crate::cpu::geometry::bins::{self, Bins, TILE_HEIGHT, TILE_PIXELS, TILE_WIDTH};
use crate::view::samples::SUBPIXEL;
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// A sample that a triangle covers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct MicroSample {
    pub depth: f32,
    /// The triangle's name.
    pub name: u32,
    /// Where the sample is in the tile's arrays.
    pub place: u32,
}

/// Triangles smaller than this (in 1/256 pixel) are tiny. Going through the samples of their boxes,
/// sixteen triangles at a time, is cheaper than setting each of them up for a tile.
pub(crate) const TINY: i32 = 6 * SUBPIXEL;

/// Sixteen triangles that are smaller than [`TINY`].
pub(crate) struct MicroTriangles<S: Simd> {
    /// Corner coordinates, in 1/256 pixel.
    pub x: [i32x16<S>; 3],
    pub y: [i32x16<S>; 3],
    /// Twice the signed area.
    pub area: i32x16<S>,
    /// The first pixel in the box, and how many steps lead to the last.
    pub first: [i32x16<S>; 2],
    pub steps: [i32x16<S>; 2],
    pub depth: [Lanes<S>; 3],
    /// The name of the first.
    pub name: u32,
}

/// An edge function, positive inside: its value at the first sample, and what it gains by a pixel to
/// the right and one down.
struct Edge<S: Simd> {
    value: i32x16<S>,
    gain: [i32x16<S>; 2],
}

impl<S: Simd> MicroTriangles<S> {
    /// Puts the covered samples of the triangles `kept` into the tiles' bins.
    #[inline(always)]
    pub(crate) fn scatter(&self, simd: S, frame: &FrameView, kept: u32, bins: &mut Bins<MicroSample>) {
        let at = self.first.map_samples(simd, frame.samples[0]);
        let edges = three(
            [(0, 1), (1, 2), (2, 0)],
            #[inline(always)]
            |(from, to)| self.edge(simd, from, to, at),
        );
        let plane = Plane::new(simd, self, at);
        let columns = bins::columns(frame.camera.width) as i32;
        let mut row = three(
            edges.each_ref(),
            #[inline(always)]
            |edge| edge.value,
        );
        let mut rows = (0, kept);
        while rows.1 != 0 {
            let mut values = row;
            let mut step = [0, rows.0];
            let mut left = rows.1;
            while left != 0 {
                let [a, b, c] = values;
                let inside = simd.simd_ge_i32x16(a | b | c, simd.splat_i32x16(0));
                let covered = LanesMask(inside).bits() & left;
                if covered != 0 {
                    self.put(covered, plane.at(step), self.words(simd, step, columns), bins);
                }
                step[0] += 1;
                left &= reaching(simd, self.steps[0], step[0]);
                for (value, edge) in values.iter_mut().zip(&edges) {
                    *value += edge.gain[0];
                }
            }
            rows.0 += 1;
            rows.1 &= reaching(simd, self.steps[1], rows.0);
            for (value, edge) in row.iter_mut().zip(&edges) {
                *value += edge.gain[1];
            }
        }
    }

    /// Puts one sample of each triangle `covered` into its bin.
    #[inline(always)]
    fn put(&self, mut covered: u32, depth: Lanes<S>, words: i32x16<S>, bins: &mut Bins<MicroSample>) {
        let (mut depths, mut places) = ([0.0; 16], [0; 16]);
        depth.store(&mut depths);
        words.store_slice(&mut places);
        while covered != 0 {
            let lane = covered.trailing_zeros() as usize & 15;
            covered &= covered - 1;
            let word = places[lane] as usize;
            let place = (word % TILE_PIXELS) as u32;
            bins.push_to(
                word / TILE_PIXELS,
                MicroSample { depth: depths[lane], name: self.name + lane as u32, place },
            );
        }
    }

    #[inline(always)]
    fn edge(&self, simd: S, from: usize, to: usize, at: [i32x16<S>; 2]) -> Edge<S> {
        // The sign of the area in every bit: adding and flipping it makes all triangles turn alike.
        let sign = self.area >> 31;
        let turned = inlined(
            #[inline(always)]
            |v: i32x16<S>| (v ^ sign) - sign,
        );
        let (dx, dy) = (turned(self.x[to] - self.x[from]), turned(self.y[to] - self.y[from]));
        // −1 where the edge does not own the samples on it. It owns them if it goes up, or level to the
        // right; no coordinate difference of a tiny triangle is as great as 2048.
        let bias = !((dy << 11) - dx) >> 31;
        let value = dx * (at[1] - self.y[from]) - dy * (at[0] - self.x[from]) + bias;
        let zero = simd.splat_i32x16(0);
        Edge { value, gain: [zero - (dy << 8), dx << 8] }
    }

    /// The number of the tile and the place in it, as one number, of the pixel so many steps away.
    #[inline(always)]
    fn words(&self, simd: S, step: [i32; 2], columns: i32) -> i32x16<S> {
        let int = inlined(
            #[inline(always)]
            |v: i32| simd.splat_i32x16(v),
        );
        let [x, y] = [self.first[0] + int(step[0]), self.first[1] + int(step[1])];
        let (column, row) = (x & int(TILE_WIDTH as i32 - 1), y & int(TILE_HEIGHT as i32 - 1));
        let tile = (y >> const { TILE_HEIGHT.trailing_zeros() }) * int(columns)
            + (x >> const { TILE_WIDTH.trailing_zeros() });
        let block = (row >> 2) * int(COLUMNS as i32) + (column >> 2);
        let lane = ((row & int(SIDE as i32 - 1)) << 2) + (column & int(SIDE as i32 - 1));
        tile * int(TILE_PIXELS as i32) + block * int(BLOCK as i32) + lane
    }
}

/// Which triangles' boxes reach so many steps.
#[inline(always)]
fn reaching<S: Simd>(simd: S, steps: i32x16<S>, step: i32) -> u32 {
    LanesMask(simd.simd_ge_i32x16(steps, simd.splat_i32x16(step))).bits()
}

/// Where the samples of some pixels are, in 1/256 pixel.
trait Samples<S: Simd> {
    fn map_samples(self, simd: S, sample: [i32; 2]) -> Self;
}

impl<S: Simd> Samples<S> for [i32x16<S>; 2] {
    #[inline(always)]
    fn map_samples(self, simd: S, sample: [i32; 2]) -> Self {
        let [x, y] = self;
        [(x << 8) + simd.splat_i32x16(sample[0]), (y << 8) + simd.splat_i32x16(sample[1])]
    }
}

/// The depths of sixteen triangles as planes over the screen, limited to the range of their corners.
struct Plane<S: Simd> {
    first: Lanes<S>,
    gain: [Lanes<S>; 2],
    range: [Lanes<S>; 2],
}

impl<S: Simd> Plane<S> {
    #[inline(always)]
    fn new(simd: S, sixteen: &MicroTriangles<S>, at: [i32x16<S>; 2]) -> Self {
        let MicroTriangles { x, y, area, depth: [a, b, c], .. } = sixteen;
        let float = inlined(
            #[inline(always)]
            |v: i32x16<S>| Lanes(simd.cvt_f32_i32x16(v)),
        );
        let (x1, y1, q1) = (float(x[1] - x[0]), float(y[1] - y[0]), *b - *a);
        let (x2, y2, q2) = (float(x[2] - x[0]), float(y[2] - y[0]), *c - *a);
        let inverse = a.one() / float(*area);
        let slope = [(q1 * y2 - q2 * y1) * inverse, (q2 * x1 - q1 * x2) * inverse];
        let first = *a + float(at[0] - x[0]) * slope[0] + float(at[1] - y[0]) * slope[1];
        let pixel = a.lit(f64::from(SUBPIXEL));
        let range = [a.min(*b).min(*c), a.max(*b).max(*c)];
        Self { first, gain: [slope[0] * pixel, slope[1] * pixel], range }
    }

    #[inline(always)]
    fn at(&self, step: [i32; 2]) -> Lanes<S> {
        let [right, down] = [self.first.lit(f64::from(step[0])), self.first.lit(f64::from(step[1]))];
        let depth = self.first + right * self.gain[0] + down * self.gain[1];
        depth.max(self.range[0]).min(self.range[1])
    }
}
