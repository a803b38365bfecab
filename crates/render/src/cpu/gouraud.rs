//! Light at vertices, for Gouraud shading.

use fearless_simd::Simd;
use glanz_color::Rgb;
use glanz_math::{Lanes, Real, Vec3};

use super::eye::Eye;
use super::frame::FrameView;
use super::reflect::{Point, Reflected, reflect_lanes};
use crate::prepare::Cluster;

/// The light of a vertex on a front and on a back face, each as what textures multiply and what not.
pub(crate) type Lit = [[[f32; 3]; 2]; 2];

/// Evaluates the illumination model at a cluster's vertices.
#[inline(always)]
pub(crate) fn shade<S: Simd>(simd: S, frame: &FrameView, cluster: &Cluster, lit: &mut [Lit]) {
    let geometry = &frame.prepared.geometry;
    let object = &frame.prepared.objects[cluster.object as usize];
    let material = &frame.materials[object.material];
    let offset = frame.eye.offset(object);
    let sides = if frame.objects[cluster.object as usize].cull_back { 1 } else { 2 };
    for row in (0..lit.len()).step_by(16) {
        let first = cluster.first_vertex as usize + row;
        let position = |axis: usize| {
            let array = geometry.position[axis][first..].first_chunk::<16>();
            Lanes::load(simd, array.expect("clusters are padded to sixteen vertices"))
        };
        let at = Vec3::new(position(0), position(1), position(2));
        let shift = Vec3::new(offset.x, offset.y, offset.z);
        let position = at + splat(simd, shift);
        let normal = normals(simd, &geometry.normals[first..first + 16]);
        let wo = to_viewer(simd, &frame.eye, position);
        for side in 0..sides {
            let normal = match (side, material.two_sided) {
                (0, _) => normal,
                (_, true) => -normal,
                (_, false) => normal * normal.x.zero(),
            };
            let reflected = reflect_lanes(simd, &frame.lights, material, &Point { position, normal, wo });
            store(&reflected, side, &mut lit[row..row + 16]);
        }
        if object.attributes.color {
            tint(&geometry.colors[first..first + 16], &mut lit[row..row + 16]);
        }
    }
}

#[inline(always)]
fn splat<S: Simd>(simd: S, v: Vec3<f32>) -> Vec3<Lanes<S>> {
    Vec3::new(Lanes::splat(simd, v.x), Lanes::splat(simd, v.y), Lanes::splat(simd, v.z))
}

/// The unit normal, or null where there is none.
#[inline(always)]
pub(crate) fn unit<R: Real>(n: Vec3<R>) -> Vec3<R> {
    n * n.dot(n).max(n.x.lit(1e-30)).rsqrt()
}

#[inline(always)]
fn normals<S: Simd>(simd: S, rows: &[[f32; 3]]) -> Vec3<Lanes<S>> {
    let mut columns = [[0.0f32; 16]; 3];
    for (lane, n) in rows.iter().enumerate() {
        for c in 0..3 {
            columns[c][lane] = n[c];
        }
    }
    let [x, y, z] = &columns;
    unit(Vec3::new(Lanes::load(simd, x), Lanes::load(simd, y), Lanes::load(simd, z)))
}

#[inline(always)]
fn to_viewer<S: Simd>(simd: S, eye: &Eye, position: Vec3<Lanes<S>>) -> Vec3<Lanes<S>> {
    match eye.perspective {
        true => unit(-position),
        false => splat(simd, Vec3::new(eye.back[0], eye.back[1], eye.back[2])),
    }
}

#[inline(always)]
fn store<S: Simd>(reflected: &Reflected<Lanes<S>>, side: usize, lit: &mut [Lit]) {
    let mut lanes = [0.0f32; 16];
    for (part, values) in [reflected.textured, reflected.plain].into_iter().enumerate() {
        for (c, value) in values.into_iter().enumerate() {
            value.store(&mut lanes);
            for (vertex, value) in lit.iter_mut().zip(lanes) {
                vertex[side][part][c] = value;
            }
        }
    }
}

/// Vertex colours multiply the textured part.
fn tint(colors: &[[f32; 4]], lit: &mut [Lit]) {
    for (vertex, color) in lit.iter_mut().zip(colors) {
        for side in vertex {
            side[0] = (Rgb(side[0]) * Rgb([color[0], color[1], color[2]])).0;
        }
    }
}
