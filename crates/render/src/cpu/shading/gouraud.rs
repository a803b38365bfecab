//! Light at vertices, for Gouraud shading.

use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::point::unit;
use crate::cpu::lighting::reflect::reflect_lanes;
use crate::prepare::Cluster;
use crate::view::camera::ViewCamera;
use fearless_simd::Simd;
use glanz_color::Rgb;
use glanz_math::inline::three;
use glanz_math::{Lanes, Real, Vec3};

/// The light of a vertex on a front and on a back face, each as what textures multiply and what not.
pub(crate) type Lit = [[[f32; 3]; 2]; 2];

/// What the first pass makes of vertices beside their places: their light, and of those whose texels mix spectra the light through the second and third
/// spectrum in place of textured and plain; empty where no object has such.
pub(crate) struct Made<'a> {
    pub lit: &'a mut [Lit],
    pub mix: &'a mut [Lit],
    /// What programs make of them; empty where there are none.
    pub varyings: &'a mut [f32],
}

impl Made<'_> {
    /// The part of some vertices.
    pub(crate) fn part(&mut self, range: core::ops::Range<usize>) -> Made<'_> {
        let mix = if self.mix.is_empty() { &mut [] } else { &mut self.mix[range.clone()] };
        Made { lit: &mut self.lit[range], mix, varyings: &mut [] }
    }
}

/// Evaluates the illumination model at a cluster's vertices.
#[inline(always)]
pub(crate) fn shade<S: Simd>(simd: S, frame: &FrameView, cluster: &Cluster, vertices: Made) {
    let Made { lit, mix, .. } = vertices;
    let geometry = &frame.prepared.geometry;
    let object = &frame.prepared.objects[cluster.object as usize];
    let view = &frame.objects[cluster.object as usize];
    let material = &frame.materials[object.material];
    let offset = frame.camera.offset(object);
    let sides = if view.cull_back { 1 } else { 2 };
    for row in (0..lit.len()).step_by(16) {
        let first = cluster.first_vertex as usize + row;
        let position = positions(simd, &geometry.position, first) + splat(simd, offset);
        let normal = normals(simd, &geometry.normals[first..first + 16]);
        let wo = to_viewer(simd, &frame.camera, position);
        let colors = object.attributes.color.then(|| &geometry.colors[first..first + 16]);
        for side in 0..sides {
            let normal = match (side, material.two_sided) {
                (0, _) => normal,
                (_, true) => -normal,
                (_, false) => normal * normal.x.zero(),
            };
            let mut point = ShadingPoint::plain(position, normal, wo).at_means(material);
            if material.anisotropic && object.attributes.tangent {
                let [x, y, z] = columns(simd, &geometry.tangents[first..first + 16]);
                point.tangent = Some(Vec3::new(x, y, z));
            }
            let vertices = VertexBlock { simd, frame, view, point, colors };
            let (parts, more) = vertices.reflect();
            store(parts, side, &mut lit[row..row + 16]);
            if let Some(more) = more {
                store(more, side, &mut mix[row..row + 16]);
            }
        }
        if let (Some(colors), None) = (colors, &material.mix) {
            tint(colors, &mut lit[row..row + 16]);
        }
    }
}

/// Two kinds of light of sixteen vertices.
type Parts<S> = [[Lanes<S>; 3]; 2];

/// Sixteen vertices, seen from one side.
struct VertexBlock<'a, S: Simd> {
    simd: S,
    frame: &'a FrameView<'a>,
    view: &'a ObjectView,
    point: ShadingPoint<'a, Lanes<S>>,
    colors: Option<&'a [[f32; 4]]>,
}

impl<S: Simd> VertexBlock<'_, S> {
    /// What textures multiply and what not; and where texels mix spectra at the pixels, the light through the
    /// second and the third, the first of both parts then being that through the first.
    #[inline(always)]
    fn reflect(&self) -> (Parts<S>, Option<Parts<S>>) {
        let material = &self.frame.materials[self.view.material];
        let transmittance =
            |texel| reflect_lanes(self.simd, &self.frame.lights, material, &self.point, texel);
        let one = self.point.position.x.one();
        let zero = one.zero();
        let [r, g, b] = self.colors.map_or([one; 3], |colors| columns(self.simd, colors));
        let mixes = material.mix.is_some();
        if self.view.layout.mix.is_none() {
            let texel = (mixes && self.colors.is_some()).then_some([r, g, b]);
            let reflected = transmittance(texel);
            return ([reflected.textured, reflected.plain], None);
        }
        let first = transmittance(Some([r, zero, zero]));
        let more = [[zero, g, zero], [zero, zero, b]].map(|texel| transmittance(Some(texel)).textured);
        ([first.textured, first.plain], Some(more))
    }
}

#[inline(always)]
fn splat<S: Simd>(simd: S, v: Vec3<f32>) -> Vec3<Lanes<S>> {
    Vec3::new(Lanes::splat(simd, v.x), Lanes::splat(simd, v.y), Lanes::splat(simd, v.z))
}

/// The positions of sixteen vertices from the first on, relative to their object's anchor.
#[inline(always)]
fn positions<S: Simd>(simd: S, columns: &[Vec<f32>; 3], first: usize) -> Vec3<Lanes<S>> {
    let [x, y, z] = three(
        [0, 1, 2],
        #[inline(always)]
        |axis: usize| {
            let array = columns[axis][first..].first_chunk::<16>();
            Lanes::load(simd, array.expect("clusters are padded to sixteen vertices"))
        },
    );
    Vec3::new(x, y, z)
}

#[inline(always)]
fn normals<S: Simd>(simd: S, rows: &[[f32; 3]]) -> Vec3<Lanes<S>> {
    let [x, y, z] = columns(simd, rows);
    unit(Vec3::new(x, y, z))
}

/// The first three numbers of sixteen rows.
#[inline(always)]
fn columns<S: Simd, const N: usize>(simd: S, rows: &[[f32; N]]) -> [Lanes<S>; 3] {
    let mut columns = [[0.0f32; 16]; 3];
    for (lane, n) in rows.iter().enumerate() {
        for c in 0..3 {
            columns[c][lane] = n[c];
        }
    }
    let [x, y, z] = &columns;
    [Lanes::load(simd, x), Lanes::load(simd, y), Lanes::load(simd, z)]
}

#[inline(always)]
fn to_viewer<S: Simd>(simd: S, camera: &ViewCamera, position: Vec3<Lanes<S>>) -> Vec3<Lanes<S>> {
    match camera.perspective {
        true => unit(-position),
        false => splat(simd, Vec3::new(camera.back[0], camera.back[1], camera.back[2])),
    }
}

#[inline(always)]
fn store<S: Simd>(parts: Parts<S>, side: usize, lit: &mut [Lit]) {
    let mut lanes = [0.0f32; 16];
    for (part, values) in parts.into_iter().enumerate() {
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
