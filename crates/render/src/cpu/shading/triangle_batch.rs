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
use crate::cpu::visibility::visible::{NONE, Owners, Visible, is_named};
use glanz_math::inline::inlined;
use glanz_math::inline::three;

/// From this number of triangles on, setting all of them up at once is cheaper than one by one, where
/// they are set up for the block alone; and where they serve several blocks.
const MANY_TINY: usize = 3;
const MANY: usize = 8;

/// How many owners of a block are enough to know that a batch is cheaper than records, judged by the first.
#[inline(always)]
pub(crate) fn enough(visible: &Visible, at: usize) -> usize {
    let first = visible.each(at)[0];
    if is_named(first) && first != NONE { MANY_TINY } else { MANY }
}

/// Whether a batch is cheaper than records.
#[inline(always)]
pub(crate) fn pays(owners: &Owners) -> bool {
    owners.count >= MANY || owners.count >= MANY_TINY && is_named(owners.runs[0].setup)
}

/// What records would give: the rows of the position, and of one group of attributes.
pub(crate) type Rows<S> = [[Lanes<S>; GROUP]; 2];

/// Which triangles sixteen pixels see.
struct Lookup<'a> {
    frame: &'a FrameView<'a>,
    visible: &'a Visible,
    each: &'a [u32; BLOCK],
    owners: &'a Owners,
    object: usize,
}

/// The corners of sixteen triangles.
#[derive(Debug, Default)]
pub(crate) struct TriangleBatch {
    screen: [[[f32; 4]; BLOCK]; 3],
    /// Normals, or light.
    values: [[[f32; 4]; BLOCK]; 3],
}

impl TriangleBatch {
    /// Fetches the triangles that sixteen pixels see, if all are of this object and have values at
    /// their corners: false where parts of clipped triangles or of other objects are among them, or where
    /// a value belongs to facets or to one side.
    #[inline(always)]
    pub(crate) fn fetch(
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
        let lanes = Lookup { frame, visible, each: visible.each(at), owners, object };
        match gouraud {
            true => {
                let rows = projected.lit;
                lanes.fetch(
                    self,
                    projected,
                    rows,
                    #[inline(always)]
                    |[front, _]| sum(front),
                )
            }
            false => {
                let rows = &frame.prepared.geometry.normals;
                lanes.fetch(
                    self,
                    projected,
                    rows,
                    #[inline(always)]
                    |normal| *normal,
                )
            }
        }
    }

    /// The rows of the triangles that were fetched.
    #[inline(always)]
    pub(crate) fn rows<S: Simd>(&self, simd: S, frame: &FrameView, view: &ObjectView) -> Rows<S> {
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

impl Lookup<'_> {
    /// Brings the corners' places and their values into lanes; false where a triangle does not fit.
    #[inline(always)]
    fn fetch<T>(
        &self,
        triangle_batch: &mut TriangleBatch,
        projected: &Projected,
        rows: &[T],
        value: impl Fn(&T) -> [f32; 3],
    ) -> bool {
        let geometry = &self.frame.prepared.geometry;
        // As many of both, so that one comparison does for a vertex.
        let count = projected.screen.len().min(rows.len());
        let (screen, rows) = (&projected.screen[..count], &rows[..count]);
        let (any, covered) = (self.owners.runs[0].setup, self.owners.bits);
        for (lane, own) in self.each.iter().enumerate() {
            let owner = if covered >> lane & 1 == 1 { *own } else { any };
            let Some(name) = self.visible.whole(owner) else { return false };
            let cluster = &geometry.clusters[(name >> 7) as usize];
            if cluster.object as usize != self.object {
                return false;
            }
            let triangle = geometry.triangles[cluster.first_triangle as usize + (name & 127) as usize];
            for (c, corner) in triangle.into_iter().enumerate() {
                let vertex = cluster.first_vertex as usize + corner as usize;
                triangle_batch.screen[c][lane] = screen[vertex];
                // The fourth number is of no use, whatever it is.
                let [x, y, z, _] = &mut triangle_batch.values[c][lane];
                [*x, *y, *z] = value(&rows[vertex]);
            }
        }
        true
    }
}

#[inline(always)]
fn sum([textured, plain]: &[[f32; 3]; 2]) -> [f32; 3] {
    [textured[0] + plain[0], textured[1] + plain[1], textured[2] + plain[2]]
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
