//! The first pass: clusters are culled, vertices projected, triangles culled and put into bins.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdMask, f32x16, i32x16, mask32x16};
use glanz_math::{Lanes, Real};

use super::bins::Bins;
use super::clip::{self, Extra};
use super::eye::Eye;
use super::frame::{FrameView, ObjectView, Pass};
use super::gouraud::{self, Lit};
use super::samples::SUBPIXEL;
use super::{inlined, three};
use crate::prepare::{Cluster, Geometry};

/// Screen positions beyond this many pixels from the corner are clipped, so that fixed-point numbers
/// keep their range.
pub(crate) const GUARD: f32 = 30_000.0;

/// Triangles smaller than this (in 1/256 pixel) have edge functions that fit 32 bits.
pub(crate) const SMALL: i32 = 64 * SUBPIXEL;

/// A projected vertex: x and y in pixels, then a depth that is linear on the screen and greater when
/// nearer: 1/distance in perspective, −distance else. NaN marks a vertex that must be clipped. The
/// fourth entry is not used.
pub(crate) type Screen = [f32; 4];

/// What a run of clusters becomes. Kept between frames, for its memory.
#[derive(Debug, Default)]
pub(crate) struct ChunkOutput {
    /// Opaque and masked triangles.
    pub solid: Bins,
    /// Blended triangles.
    pub blended: Bins,
    /// Triangles that clipping made.
    pub extras: Vec<Extra>,
}

/// Fixed-point positions of a cluster's vertices, and which of them need clipping.
struct Local {
    x: [i32; 256],
    y: [i32; 256],
    outside: [bool; 256],
}

/// Projects and bins the clusters `range`. `screen` and `lit` are the parts of the frame's arrays that
/// begin with the first vertex of the first cluster.
#[inline(always)]
pub(crate) fn process<S: Simd>(
    simd: S,
    frame: &FrameView,
    range: core::ops::Range<usize>,
    screen: &mut [Screen],
    lit: &mut [Lit],
    output: &mut ChunkOutput,
) {
    let geometry = &frame.prepared.geometry;
    let Some(first) = geometry.clusters.get(range.start) else { return };
    let base = first.first_vertex as usize;
    let mut local = Local { x: [0; 256], y: [0; 256], outside: [false; 256] };
    for number in range {
        let cluster = &geometry.clusters[number];
        let object = &frame.objects[cluster.object as usize];
        if is_culled(cluster, object, frame) {
            continue;
        }
        let start = cluster.first_vertex as usize - base;
        let count = (cluster.vertices as usize).next_multiple_of(16);
        let own = &mut screen[start..start + count];
        let clipped = project(simd, frame, cluster, object, own, &mut local);
        if object.shading == glanz_scene::Shading::Gouraud {
            gouraud::shade(simd, frame, cluster, &mut lit[start..start + count]);
        }
        bin(simd, frame, number, object, &local, own, clipped, output);
    }
}

/// Whether nothing of the cluster can be seen: it lies outside the view, or turns its back.
fn is_culled(cluster: &Cluster, object: &ObjectView, frame: &FrameView) -> bool {
    let eye = &frame.eye;
    let dot = |a: &[f32; 3], b: glam::Vec3| a[0] * b.x + a[1] * b.y + a[2] * b.z;
    let x = dot(&eye.right, cluster.center) + object.anchor[0];
    let y = dot(&eye.up, cluster.center) + object.anchor[1];
    let distance = object.anchor[2] - dot(&eye.back, cluster.center);
    let radius = cluster.radius;
    if distance + radius < eye.near {
        return true;
    }
    // Half sizes of the picture at distance 1, or everywhere.
    let half = [eye.center[0] * eye.inverse_scale, eye.center[1] * eye.inverse_scale];
    for (along, half) in [x, y].into_iter().zip(half) {
        let (limit, reach) = match eye.perspective {
            true => (half * distance, radius * (1.0 + half * half).sqrt()),
            false => (half, radius),
        };
        if along.abs() - limit > reach * 1.0001 {
            return true;
        }
    }
    object.cull_back && is_turned_away(cluster, object, frame)
}

fn is_turned_away(cluster: &Cluster, object: &ObjectView, frame: &FrameView) -> bool {
    if cluster.cone_sin > 1.0 {
        return false;
    }
    let eye = &frame.eye;
    let back = glam::Vec3::from(eye.back);
    if !eye.perspective {
        return -back.dot(cluster.cone_axis) >= cluster.cone_sin;
    }
    let (right, up) = (glam::Vec3::from(eye.right), glam::Vec3::from(eye.up));
    let anchor = right * object.anchor[0] + up * object.anchor[1] - back * object.anchor[2];
    let center = anchor + cluster.center;
    center.dot(cluster.cone_axis) >= cluster.cone_sin * center.length() + cluster.radius
}

/// Projects a cluster's vertices; returns whether any needs clipping.
#[inline(always)]
fn project<S: Simd>(
    simd: S,
    frame: &FrameView,
    cluster: &Cluster,
    object: &ObjectView,
    screen: &mut [Screen],
    local: &mut Local,
) -> bool {
    let eye = &frame.eye;
    let [px, py, pz] = &frame.prepared.geometry.position;
    let first = cluster.first_vertex as usize;
    let mut clipped = false;
    for row in (0..screen.len()).step_by(16) {
        let at = |array: &[f32]| Lanes(f32x16::from_slice(simd, &array[first + row..first + row + 16]));
        let (x, y, depth, inside) = project_lanes(simd, eye, object, [at(px), at(py), at(pz)]);
        let subpixel = x.lit(f64::from(SUBPIXEL));
        let fixed = inlined(
            #[inline(always)]
            |v: Lanes<S>| -> i32x16<S> { simd.cvt_i32_f32x16((v * subpixel + v.lit(0.5)).0.floor()) },
        );
        fixed(x).store_slice(&mut local.x[row..row + 16]);
        fixed(y).store_slice(&mut local.y[row..row + 16]);
        let bits = inside.0.to_bitmask() as u32;
        clipped |= bits != 0xffff;
        for lane in 0..16 {
            local.outside[row + lane] = bits >> lane & 1 == 0;
        }
        let zero = Lanes::splat(simd, 0.0);
        let (even, odd) = (x.0.interleave(depth.0), y.0.interleave(zero.0));
        let rows = screen[row..row + 16].as_flattened_mut().as_chunks_mut::<16>().0;
        for (rows, half) in rows.chunks_mut(2).zip([even.0.interleave(odd.0), even.1.interleave(odd.1)]) {
            half.0.store_slice(&mut rows[0]);
            half.1.store_slice(&mut rows[1]);
        }
    }
    clipped
}

/// Screen x, y and depth, and whether the vertex is in front of the eye and within the guard band.
#[inline(always)]
fn project_lanes<S: Simd>(
    simd: S,
    eye: &Eye,
    object: &ObjectView,
    p: [Lanes<S>; 3],
) -> (Lanes<S>, Lanes<S>, Lanes<S>, glanz_math::LanesMask<S>) {
    let splat = inlined(
        #[inline(always)]
        |v: f32| Lanes::splat(simd, v),
    );
    let along = inlined(
        #[inline(always)]
        |axis: &[f32; 3]| p[0] * splat(axis[0]) + p[1] * splat(axis[1]) + p[2] * splat(axis[2]),
    );
    let right = along(&eye.right) + splat(object.anchor[0]);
    let up = along(&eye.up) + splat(object.anchor[1]);
    let distance = splat(object.anchor[2]) - along(&eye.back);
    let (factor, depth) = if eye.perspective {
        let inverse = splat(1.0) / distance;
        (inverse * splat(eye.scale), inverse)
    } else {
        (splat(eye.scale), -distance)
    };
    let x = splat(eye.center[0]) + right * factor;
    let y = splat(eye.center[1]) - up * factor;
    let inside = splat(eye.near).le(distance) & x.abs().lt(splat(GUARD)) & y.abs().lt(splat(GUARD));
    let nan = splat(f32::NAN);
    (x.select(inside, splat(0.0)), y.select(inside, splat(0.0)), depth.select(inside, nan), inside)
}

/// Six corner coordinates of sixteen triangles, in 1/256 pixel.
struct Corners<S: Simd> {
    x: [i32x16<S>; 3],
    y: [i32x16<S>; 3],
}

#[expect(clippy::too_many_arguments, reason = "a cluster on its way from one array to the next")]
#[inline(always)]
fn bin<S: Simd>(
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
    let bins = if object.pass == Pass::Blended { &mut output.blended } else { &mut output.solid };
    for (block, sixteen) in triangles.chunks(16).enumerate() {
        let mut x = [[0i32; 16]; 3];
        let mut y = [[0i32; 16]; 3];
        let mut outside = 0u32;
        for (lane, corners) in sixteen.iter().enumerate() {
            for c in 0..3 {
                let vertex = corners[c] as usize;
                x[c][lane] = local.x[vertex];
                y[c][lane] = local.y[vertex];
            }
            if clipped && corners.iter().any(|&v| local.outside[v as usize]) {
                outside |= 1 << lane;
            }
        }
        let corners = Corners {
            x: three(
                x,
                #[inline(always)]
                |v| i32x16::from_slice(simd, &v),
            ),
            y: three(
                y,
                #[inline(always)]
                |v| i32x16::from_slice(simd, &v),
            ),
        };
        let mut first = [[0i32; 16]; 2];
        let mut last = [[0i32; 16]; 2];
        let valid = (1u32 << sixteen.len()) - 1;
        let mut kept = visible(simd, frame, object, &corners, &mut first, &mut last) & valid & !outside;
        let name = |lane: u32| (number as u32) << 7 | (block as u32 * 16 + lane);
        while kept != 0 {
            let lane = kept.trailing_zeros();
            kept &= kept - 1;
            let l = lane as usize;
            bins.push([first[0][l], first[1][l]], [last[0][l], last[1][l]], name(lane));
        }
        while outside != 0 {
            let lane = outside.trailing_zeros();
            outside &= outside - 1;
            clip::clip(frame, name(lane), screen, bins, &mut output.extras);
        }
    }
}

/// Which triangles may cover a sample, and the first and last pixel column and row of each.
#[inline(always)]
fn visible<S: Simd>(
    simd: S,
    frame: &FrameView,
    object: &ObjectView,
    corners: &Corners<S>,
    first: &mut [[i32; 16]; 2],
    last: &mut [[i32; 16]; 2],
) -> u32 {
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
    let large = simd.simd_ge_i32x16(simd.max_i32x16(high[0] - low[0], high[1] - low[1]), int(SMALL));
    // Twice the signed area; with y downwards, front faces are negative. Exact where not large.
    let area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    let facing = match object.cull_back {
        true => simd.simd_lt_i32x16(area, int(0)),
        false => simd.simd_ne_i32x16(area, int(0)),
    };
    let mut kept = (facing | large).to_bitmask() as u32;
    let size = [frame.eye.width as i32, frame.eye.height as i32];
    let mut single = !large;
    let mut sample = [area; 2];
    for axis in 0..2 {
        let (least_sample, most_sample) = sample_range(frame.samples, axis);
        let from = (low[axis] + int(SUBPIXEL - 1 - most_sample)) >> 8;
        let to = (high[axis] - int(least_sample)) >> 8;
        let from = simd.max_i32x16(from, int(0));
        let to = simd.min_i32x16(to, int(size[axis] - 1));
        kept &= simd.simd_le_i32x16(from, to).to_bitmask() as u32;
        from.store_slice(&mut first[axis]);
        to.store_slice(&mut last[axis]);
        single &= simd.simd_eq_i32x16(from, to);
        sample[axis] = (from << 8) + int(most_sample);
    }
    if frame.samples.len() == 1 {
        kept &= !(single & is_missed(simd, corners, area, sample)).to_bitmask() as u32;
    }
    kept
}

/// Which triangles miss the one sample that their box holds. Of fine meshes this is about every second.
#[inline(always)]
fn is_missed<S: Simd>(
    simd: S,
    Corners { x, y }: &Corners<S>,
    area: i32x16<S>,
    sample: [i32x16<S>; 2],
) -> mask32x16<S> {
    // The sign of the area in every bit: adding and flipping it turns edge functions positive inside.
    let sign = area >> 31;
    let edge = inlined(
        #[inline(always)]
        |a: usize, b: usize| {
            let value = (x[b] - x[a]) * (sample[1] - y[a]) - (y[b] - y[a]) * (sample[0] - x[a]);
            (value ^ sign) - sign
        },
    );
    let outside = edge(0, 1) | edge(1, 2) | edge(2, 0);
    simd.simd_lt_i32x16(outside, simd.splat_i32x16(0))
}

/// The least and greatest coordinate of the samples of a pixel.
#[inline(always)]
pub(crate) fn sample_range(samples: &[[i32; 2]], axis: usize) -> (i32, i32) {
    samples.iter().fold((SUBPIXEL, 0), |(low, high), s| (low.min(s[axis]), high.max(s[axis])))
}
