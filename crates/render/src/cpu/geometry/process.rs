//! The first pass: clusters are culled, vertices projected; `sort` then puts triangles into bins.

use crate::cpu::frame::{FrameView, ObjectView};

use crate::cpu::geometry::chunk::{ChunkOutput, Local};
use crate::cpu::geometry::clip;
use crate::cpu::geometry::screen::{GUARD, Screen};
use crate::cpu::geometry::sort::sort;
use crate::cpu::program;
use crate::cpu::shading::gouraud::{self, Made};
use crate::prepare::Cluster;
use crate::view::camera::ViewCamera;
use crate::view::samples::SUBPIXEL;
use fearless_simd::{Simd, SimdBase, SimdFloat, SimdMask, f32x16, i32x16};
use glanz_math::inline::inlined;
use glanz_math::{Lanes, Real};

/// Projects and bins the clusters `range`. `screen` and `lit` are the parts of the frame's arrays that
/// begin with the first vertex of the first cluster.
#[inline(always)]
pub(crate) fn process<S: Simd>(
    simd: S,
    frame: &FrameView,
    range: core::ops::Range<usize>,
    screen: &mut [Screen],
    mut lit: Made,
    output: &mut ChunkOutput,
) {
    let geometry = &frame.prepared.geometry;
    let Some(first) = geometry.clusters.get(range.start) else { return };
    let base = first.first_vertex as usize;
    let mut local = Local { at: [[0; 2]; 256], outside: [0; 16], clip: Vec::new() };
    for number in range {
        let cluster = &geometry.clusters[number];
        let object = &frame.objects[cluster.object as usize];
        if is_culled(cluster, object, frame) {
            continue;
        }
        let start = cluster.first_vertex as usize - base;
        let count = (cluster.vertices as usize).next_multiple_of(16);
        let own = &mut screen[start..start + count];
        let clipped = match object.program {
            true => {
                project_by_program(simd, frame, cluster, object, (own, &mut *lit.varyings, start), &mut local)
            }
            false => project(simd, frame, cluster, object, own, &mut local),
        };
        if object.shading == glanz_scene::Shading::Gouraud {
            gouraud::shade(simd, frame, cluster, lit.part(start..start + count));
        }
        sort(simd, frame, number, object, &local, own, clipped, output);
    }
}

/// Runs the program's vertex shader; returns whether any vertex needs clipping.
#[inline(never)]
fn project_by_program<S: Simd>(
    simd: S,
    frame: &FrameView,
    cluster: &Cluster,
    object: &ObjectView,
    (screen, varyings, start): (&mut [Screen], &mut [f32], usize),
    local: &mut Local,
) -> bool {
    let Some(programs) = frame.programs else { return false };
    let stride = programs.all.stride;
    let own = &mut varyings[start * stride..(start + screen.len()) * stride];
    program::run_vertices(frame, cluster, own);
    match object.placed_by_program {
        true => place_clip(frame, &programs.all.depth_of_ndc, own, stride, screen, local),
        false => simd.vectorize(
            #[inline(always)]
            || project(simd, frame, cluster, object, screen, local),
        ),
    }
}

/// Puts vertices where their places in clip space say; returns whether any needs clipping.
fn place_clip(
    frame: &FrameView,
    [factor, summand]: &[f32; 2],
    varyings: &[f32],
    stride: usize,
    screen: &mut [Screen],
    local: &mut Local,
) -> bool {
    local.outside = [0; 16];
    local.clip.clear();
    let [half_width, half_height] = frame.camera.center;
    let mut clipped = false;
    for (vertex, (out, varyings)) in screen.iter_mut().zip(varyings.chunks(stride)).enumerate() {
        let [x, y, z, w] = [varyings[0], varyings[1], varyings[2], varyings[3]];
        local.clip.push([x, y, z, w]);
        let inverse = 1.0 / w;
        let at = [half_width + x * inverse * half_width, half_height - y * inverse * half_height];
        let inside = w > 0.0 && z.abs() <= w && at.iter().all(|at| at.abs() < GUARD);
        clipped |= !inside;
        local.outside[vertex / 16] |= u16::from(!inside) << (vertex % 16);
        let [x, y] = if inside { at } else { [0.0; 2] };
        *out = [x, y, if inside { z * inverse * factor + summand } else { f32::NAN }, 0.0];
        local.at[vertex] = [clip::fixed(x), clip::fixed(y)];
    }
    clipped
}

/// Whether nothing of the cluster can be seen: it lies outside the view, or turns its back.
fn is_culled(cluster: &Cluster, object: &ObjectView, frame: &FrameView) -> bool {
    // Only a program knows where its vertices are.
    if object.placed_by_program {
        return false;
    }
    let camera = &frame.camera;
    let dot = |a: &[f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let x = dot(&camera.right, cluster.center) + object.anchor[0];
    let y = dot(&camera.up, cluster.center) + object.anchor[1];
    let distance = object.anchor[2] - dot(&camera.back, cluster.center);
    let radius = cluster.radius;
    if distance + radius < camera.near {
        return true;
    }
    // Half sizes of the picture at distance 1, or everywhere.
    let half = [camera.center[0] * camera.inverse_scale, camera.center[1] * camera.inverse_scale];
    for (along, half) in [x, y].into_iter().zip(half) {
        let (limit, reach) = match camera.perspective {
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
    let camera = &frame.camera;
    let (back, axis) = (glam::Vec3::from(camera.back), glam::Vec3::from(cluster.cone_axis));
    if !camera.perspective {
        return -back.dot(axis) >= cluster.cone_sin;
    }
    let (right, up) = (glam::Vec3::from(camera.right), glam::Vec3::from(camera.up));
    let anchor = right * object.anchor[0] + up * object.anchor[1] - back * object.anchor[2];
    let center = anchor + glam::Vec3::from(cluster.center);
    center.dot(axis) >= cluster.cone_sin * center.length() + cluster.radius
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
    let camera = &frame.camera;
    let [px, py, pz] = &frame.prepared.geometry.position;
    let first = cluster.first_vertex as usize;
    let mut clipped = false;
    for row in (0..screen.len()).step_by(16) {
        let at = |array: &[f32]| Lanes(f32x16::from_slice(simd, &array[first + row..first + row + 16]));
        let (x, y, depth, inside) = project_lanes(simd, camera, object, [at(px), at(py), at(pz)]);
        let subpixel = x.lit(f64::from(SUBPIXEL));
        let fixed = inlined(
            #[inline(always)]
            |v: Lanes<S>| -> i32x16<S> { simd.cvt_i32_f32x16((v * subpixel + v.lit(0.5)).0.floor()) },
        );
        let (low, high) = fixed(x).interleave(fixed(y));
        let rows = local.at[row..row + 16].as_flattened_mut();
        low.store_slice(&mut rows[..16]);
        high.store_slice(&mut rows[16..]);
        let bits = inside.0.to_bitmask() as u16;
        clipped |= bits != 0xffff;
        local.outside[row / 16] = !bits;
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

/// Screen x, y and depth, and whether the vertex is far enough before the eye and within the guard band.
#[inline(always)]
fn project_lanes<S: Simd>(
    simd: S,
    camera: &ViewCamera,
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
    let right = along(&camera.right) + splat(object.anchor[0]);
    let up = along(&camera.up) + splat(object.anchor[1]);
    let distance = splat(object.anchor[2]) - along(&camera.back);
    let (factor, depth) = if camera.perspective {
        let inverse = splat(1.0) / distance;
        (inverse * splat(camera.scale), inverse)
    } else {
        (splat(camera.scale), -distance)
    };
    let x = splat(camera.center[0]) + right * factor;
    let y = splat(camera.center[1]) - up * factor;
    let inside = splat(object.steep).le(distance) & x.abs().lt(splat(GUARD)) & y.abs().lt(splat(GUARD));
    let nan = splat(f32::NAN);
    (x.select(inside, splat(0.0)), y.select(inside, splat(0.0)), depth.select(inside, nan), inside)
}
