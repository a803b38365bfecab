//! Sixteen pixels that see many triangles: set up in lanes rather than one by one.
//!
//! A record pays where several pixels use it. In a fine mesh every other pixel sees another triangle;
//! there the vertices of sixteen triangles are brought into lanes, and the arithmetic of
//! [`TriangleSetups::add`](super::records::TriangleSetups::add) is done for all of them at once.

use fearless_simd::{Simd, SimdBase, f32x16};
use glanz_math::{Lanes, Real};
use glanz_scene::Shading;

use crate::cpu::block::BLOCK;
use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::shading::triangle_setup::{GROUP, Projected, barycentric, differences};
use crate::cpu::visibility::visible::{Owners, Visible, is_named};
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// From this number of triangles on, setting all of them up at once is cheaper than one by one, where
/// they are set up for the block alone; and where they serve several blocks.
const MANY_TINY: usize = 3;
const MANY: usize = 8;

/// Whether [`Dust`] is cheaper than records.
#[inline(always)]
pub(crate) fn pays(owners: &Owners) -> bool {
    owners.count >= MANY || owners.count >= MANY_TINY && is_named(owners.runs[0].setup)
}

/// What records would give: the rows of the position, and of one group of attributes.
pub(crate) type Rows<S> = [[Lanes<S>; GROUP]; 2];

/// The corners of sixteen triangles.
#[derive(Debug, Default)]
pub(crate) struct TriangleBatch {
    vertices: [[u32; BLOCK]; 3],
    screen: [[[f32; 4]; BLOCK]; 3],
    /// Normals, or light.
    values: [[[f32; 4]; BLOCK]; 3],
}

impl TriangleBatch {
    /// Fetches the triangles that sixteen pixels see, if all are of this object and have values at
    /// their corners: false where parts of clipped triangles or of other objects are among them, or where
    /// a value belongs to facets or to one side.
    #[inline(always)]
    pub fn fetch(
        &mut self,
        frame: &FrameView,
        projected: &Projected,
        visible: &Visible,
        owners: &Owners,
        at: usize,
        object: usize,
    ) -> bool {
        let view = &frame.objects[object];
        let gouraud = view.shading == Shading::Gouraud;
        if view.shading == Shading::Flat || gouraud && !view.cull_back {
            return false;
        }
        let geometry = &frame.prepared.geometry;
        let (any, covered) = (owners.runs[0].setup, owners.bits);
        let each = visible.each(at);
        for (lane, own) in each.iter().enumerate() {
            let owner = if covered >> lane & 1 == 1 { *own } else { any };
            let Some(name) = visible.whole(owner) else { return false };
            let cluster = &geometry.clusters[(name >> 7) as usize];
            if cluster.object as usize != object {
                return false;
            }
            let triangle = geometry.triangles[cluster.first_triangle as usize + (name & 127) as usize];
            for (vertices, corner) in self.vertices.iter_mut().zip(triangle) {
                vertices[lane] = cluster.first_vertex + u32::from(corner);
            }
        }
        let vertices = self.vertices.as_flattened();
        for (screen, vertex) in self.screen.as_flattened_mut().iter_mut().zip(vertices) {
            *screen = projected.screen[*vertex as usize];
        }
        let normals = geometry.normals.as_flattened();
        for (value, vertex) in self.values.as_flattened_mut().iter_mut().zip(vertices) {
            *value = match gouraud {
                true => lit(&projected.lit[*vertex as usize][0]),
                false => normal(normals, *vertex as usize),
            };
        }
        true
    }

    /// The rows of the triangles that were fetched.
    #[inline(always)]
    pub fn rows<S: Simd>(&self, simd: S, frame: &FrameView, view: &ObjectView) -> Rows<S> {
        let in_lanes = inlined(
            #[inline(always)]
            |rows: &[[f32; 4]; BLOCK]| columns(simd, rows),
        );
        let (position, back) = barycentric(&three(self.screen.each_ref(), in_lanes));
        let mut values = three(self.values.each_ref(), in_lanes);
        if view.shading == Shading::Phong && !view.cull_back {
            let one = Lanes::splat(simd, 1.0);
            let two_sided = frame.materials[view.material].two_sided;
            let sign = (if two_sided { -one } else { one.zero() }).select(back, one);
            for value in values.iter_mut().flatten() {
                *value = *value * sign;
            }
        }
        [position, differences(&values)]
    }
}

/// A vertex's normal; the fourth number is of no use.
#[inline(always)]
fn normal(normals: &[f32], vertex: usize) -> [f32; 4] {
    let row = &normals[3 * vertex..];
    row.first_chunk().copied().unwrap_or_else(|| [row[0], row[1], row[2], 0.0])
}

#[inline(always)]
fn lit([textured, plain]: &[[f32; 3]; 2]) -> [f32; 4] {
    [textured[0] + plain[0], textured[1] + plain[1], textured[2] + plain[2], 0.0]
}

/// The three columns of sixteen rows.
#[inline(always)]
fn columns<S: Simd>(simd: S, rows: &[[f32; 4]; BLOCK]) -> [Lanes<S>; 3] {
    let rows = rows.as_flattened();
    let load = inlined(
        #[inline(always)]
        |i: usize| f32x16::from_slice(simd, &rows[16 * i..16 * i + 16]),
    );
    let (first, second) = (load(0).deinterleave(load(1)), load(2).deinterleave(load(3)));
    let (even, odd) = (first.0.deinterleave(second.0), first.1.deinterleave(second.1));
    [Lanes(even.0), Lanes(odd.0), Lanes(even.1)]
}
