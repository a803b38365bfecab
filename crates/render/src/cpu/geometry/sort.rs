//! The second half of the first pass: a cluster's triangles are culled, sixteen at a time, and what is
//! left is put into the bins of the tiles that it touches.

use fearless_simd::{Simd, SimdBase, SimdMask, i32x16};
use glanz_math::Lanes;

use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::geometry::bins::Bins;
use crate::cpu::geometry::chunk::{ChunkOutput, Local};
use crate::cpu::geometry::clip::{self, ClippedTriangle};
use crate::cpu::geometry::micro_triangles::{MicroTriangles, TINY};
use crate::cpu::geometry::screen::{SMALL, Screen, sample_range};
use crate::cpu::program::{self, ProgramClip};
use crate::prepare::Geometry;
use crate::view::objects::Pass;
use crate::view::samples::SUBPIXEL;
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// Six corner coordinates of sixteen triangles, in 1/256 pixel.
struct Corners<S: Simd> {
    x: [i32x16<S>; 3],
    y: [i32x16<S>; 3],
}

/// Which of sixteen triangles may cover a sample, and where.
struct Boxes<S: Simd> {
    area: i32x16<S>,
    /// First and last pixel column and row of each.
    first: [i32x16<S>; 2],
    last: [i32x16<S>; 2],
    kept: u32,
    /// Those of a few samples.
    tiny: u32,
}

/// Culls and sorts the triangles of cluster `number`.
#[expect(
    clippy::too_many_arguments,
    reason = "the outputs of projection, in and out, without a struct between"
)]
#[inline(always)]
pub(crate) fn sort<S: Simd>(
    simd: S,
    frame: &FrameView,
    number: usize,
    object: &ObjectView,
    local: &Local,
    screen: &[Screen],
    clipped: bool,
    output: &mut ChunkOutput,
) {
    let geometry: &Geometry = &frame.prepared.geometry;
    let cluster = &geometry.clusters[number];
    let triangles = &geometry.triangles[cluster.first_triangle as usize..][..cluster.triangles as usize];
    let ChunkOutput { solid, points, blended, clipped_triangles } = output;
    let bins = if object.pass == Pass::Blended { blended } else { solid };
    // With more samples a pixel than one, or where a texture decides, triangles stay triangles.
    let pointed = frame.samples.len() == 1 && object.pass == Pass::Opaque;
    for (block, sixteen) in triangles.chunks(16).enumerate() {
        let first_name = ((number as u32) << 7) | (block as u32 * 16);
        let corners = gather(simd, local, sixteen);
        let boxes = visible(simd, frame, object, &corners);
        let mut outside = if clipped { needing_clip(local, sixteen) } else { 0 };
        let mut kept = boxes.kept & ((1 << sixteen.len()) - 1) & !outside;
        let tiny = kept & boxes.tiny;
        if pointed && tiny != 0 {
            kept &= !tiny;
            let Corners { x, y } = corners;
            let Boxes { area, first, last, .. } = boxes;
            let steps = [last[0] - first[0], last[1] - first[1]];
            let depth = depths(simd, screen, sixteen);
            MicroTriangles { x, y, area, first, steps, depth, name: first_name }
                .scatter(simd, frame, tiny, points);
        }
        if kept != 0 {
            let (first, last) = (stored(boxes.first), stored(boxes.last));
            while kept != 0 {
                let l = kept.trailing_zeros() as usize & 15;
                kept &= kept - 1;
                let box_of = |ends: &[[i32; 16]; 2]| [ends[0][l], ends[1][l]];
                bins.push(box_of(&first), box_of(&last), first_name + l as u32);
            }
        }
        while outside != 0 {
            let lane = outside.trailing_zeros();
            outside &= outside - 1;
            cut(frame, object, first_name + lane, (local, screen), bins, clipped_triangles);
        }
    }
}

/// Clips a triangle, by the camera or by where a program put it.
#[cold]
#[inline(never)]
fn cut(
    frame: &FrameView,
    object: &ObjectView,
    name: u32,
    (local, screen): (&Local, &[Screen]),
    bins: &mut Bins<u32>,
    clipped_triangles: &mut Vec<ClippedTriangle>,
) {
    match frame.programs.filter(|_| object.placed_by_program) {
        Some(programs) => {
            let depth_of_ndc = programs.all.depth_of_ndc;
            let place = ProgramClip { screen, clip: &local.clip, depth_of_ndc };
            program::clip(frame, name, place, bins, clipped_triangles);
        }
        None => clip::clip(frame, name, screen, bins, clipped_triangles),
    }
}

#[inline(always)]
fn gather<S: Simd>(simd: S, local: &Local, sixteen: &[[u8; 3]]) -> Corners<S> {
    let mut rows = [[[0i32; 2]; 16]; 3];
    for (lane, corners) in sixteen.iter().enumerate() {
        for c in 0..3 {
            rows[c][lane] = local.at[corners[c] as usize];
        }
    }
    let [a, b, c] = three(
        rows.each_ref(),
        #[inline(always)]
        |rows| {
            let (low, high) = rows.as_flattened().split_at(16);
            i32x16::from_slice(simd, low).deinterleave(i32x16::from_slice(simd, high))
        },
    );
    Corners { x: [a.0, b.0, c.0], y: [a.1, b.1, c.1] }
}

#[inline(always)]
fn depths<S: Simd>(simd: S, screen: &[Screen], sixteen: &[[u8; 3]]) -> [Lanes<S>; 3] {
    let mut depth = [[0.0; 16]; 3];
    for (lane, corners) in sixteen.iter().enumerate() {
        for c in 0..3 {
            depth[c][lane] = screen[corners[c] as usize][2];
        }
    }
    three(
        depth.each_ref(),
        #[inline(always)]
        |values| Lanes::load(simd, values),
    )
}

fn needing_clip(local: &Local, sixteen: &[[u8; 3]]) -> u32 {
    let outside =
        |corners: &[u8; 3]| corners.iter().any(|&v| local.outside[usize::from(v / 16)] >> (v % 16) & 1 == 1);
    sixteen.iter().enumerate().fold(0, |bits, (lane, corners)| bits | u32::from(outside(corners)) << lane)
}

#[inline(always)]
fn stored<S: Simd>([x, y]: [i32x16<S>; 2]) -> [[i32; 16]; 2] {
    let mut arrays = [[0; 16]; 2];
    x.store_slice(&mut arrays[0]);
    y.store_slice(&mut arrays[1]);
    arrays
}

/// Finds the triangles that may cover a sample, and their boxes.
#[inline(always)]
fn visible<S: Simd>(simd: S, frame: &FrameView, object: &ObjectView, corners: &Corners<S>) -> Boxes<S> {
    let int = inlined(
        #[inline(always)]
        |v: i32| simd.splat_i32x16(v),
    );
    let Corners { x, y } = corners;
    let least = inlined(
        #[inline(always)]
        |v: &[i32x16<S>; 3]| simd.min_i32x16(simd.min_i32x16(v[0], v[1]), v[2]),
    );
    let most = inlined(
        #[inline(always)]
        |v: &[i32x16<S>; 3]| simd.max_i32x16(simd.max_i32x16(v[0], v[1]), v[2]),
    );
    let (low, high) = ([least(x), least(y)], [most(x), most(y)]);
    let extent = simd.max_i32x16(high[0] - low[0], high[1] - low[1]);
    let large = simd.simd_ge_i32x16(extent, int(SMALL));
    // Twice the signed area; with y downwards, front faces are negative. Exact where not large.
    let area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    let facing = match object.cull_back {
        true => simd.simd_lt_i32x16(area, int(0)),
        false => simd.simd_ne_i32x16(area, int(0)),
    };
    let mut kept = (facing | large).to_bitmask() as u32;
    let tiny = simd.simd_lt_i32x16(extent, int(TINY));
    let size = [frame.camera.width as i32, frame.camera.height as i32];
    let (mut first, mut last) = ([area; 2], [area; 2]);
    for axis in 0..2 {
        let (least_sample, most_sample) = sample_range(frame.samples, axis);
        let from = (low[axis] + int(SUBPIXEL - 1 - most_sample)) >> 8;
        let to = (high[axis] - int(least_sample)) >> 8;
        first[axis] = simd.max_i32x16(from, int(0));
        last[axis] = simd.min_i32x16(to, int(size[axis] - 1));
        kept &= simd.simd_le_i32x16(first[axis], last[axis]).to_bitmask() as u32;
    }
    Boxes { area, first, last, kept, tiny: tiny.to_bitmask() as u32 }
}
