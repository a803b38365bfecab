//! Sixteen pixels of an object: where they are on its surface, and what is interpolated there.

use fearless_simd::Simd;
use glanz_math::inline::{inlined, nine};
use glanz_math::{Lanes, LanesMask, Real, Vec3};

use super::surface::{interpolated, on_surface, place};
use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::lighting::point::{ShadingPoint, unit};
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetup, TriangleSetups};
use crate::cpu::visibility::coverage_layers::Run;

/// What sixteen pixels show of one layer.
#[derive(Clone, Copy)]
pub(crate) struct Shaded<S: Simd> {
    pub rgb: [Lanes<S>; 3],
    pub alpha: Lanes<S>,
    /// The fraction of what is behind that is seen nevertheless.
    pub transmittance: [Lanes<S>; 3],
    pub distance: Lanes<S>,
    pub normal: Vec3<Lanes<S>>,
}

/// Barycentric coordinates on the surface, and distance from the eye plane.
#[derive(Clone, Copy)]
pub(crate) struct Place<S: Simd> {
    pub u: Lanes<S>,
    pub v: Lanes<S>,
    pub distance: Lanes<S>,
}

/// Sixteen pixels of one object in one layer.
pub(crate) struct ShadeBlock<'a, S: Simd> {
    pub simd: S,
    pub frame: &'a FrameView<'a>,
    pub setups: &'a TriangleSetups,
    pub object: &'a ObjectView,
    pub runs: &'a [Run],
    pub px: Lanes<S>,
    pub py: Lanes<S>,
}

/// The three values of the attribute group with these rows.
#[inline(always)]
pub(crate) fn interpolate<S: Simd>(rows: &[Lanes<S>; GROUP], place: &Place<S>) -> [Lanes<S>; 3] {
    interpolated(rows, place.u, place.v)
}

impl<S: Simd> Shaded<S> {
    /// All zero.
    #[inline(always)]
    pub(crate) fn nothing(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let normal = Vec3::new(zero, zero, zero);
        Self { rgb: [zero; 3], alpha: zero, transmittance: [zero; 3], distance: zero, normal }
    }

    #[inline(always)]
    pub(crate) fn merge(&mut self, other: &Self, mask: LanesMask<S>) {
        for c in 0..3 {
            self.rgb[c] = other.rgb[c].select(mask, self.rgb[c]);
            self.transmittance[c] = other.transmittance[c].select(mask, self.transmittance[c]);
        }
        self.alpha = other.alpha.select(mask, self.alpha);
        self.distance = other.distance.select(mask, self.distance);
        self.normal.x = other.normal.x.select(mask, self.normal.x);
        self.normal.y = other.normal.y.select(mask, self.normal.y);
        self.normal.z = other.normal.z.select(mask, self.normal.z);
    }
}

impl TriangleSetups {
    /// Nine floats of a run's record, from the `part`-th nine on.
    #[inline(always)]
    pub(crate) fn row(&self, run: &Run, part: usize) -> &[f32; GROUP] {
        let start = self.list[run.setup as usize].offset as usize + part * GROUP;
        self.floats[start..].first_chunk().expect("records hold whole groups")
    }

    /// Nine floats of each pixel's record, from the `part`-th nine on; 0 where there are no records.
    #[inline(always)]
    pub(crate) fn gather<S: Simd>(&self, simd: S, runs: &[Run], part: usize) -> [Lanes<S>; GROUP] {
        let Some((first, others)) = runs.split_first() else {
            return [Lanes::splat(simd, 0.0); GROUP];
        };
        let first = self.row(first, part);
        let mut lanes = nine(
            #[inline(always)]
            |i| Lanes::splat(simd, first[i]),
        );
        for run in others {
            let mask = LanesMask::from_bits(simd, run.bits);
            let row = self.row(run, part);
            lanes = nine(
                #[inline(always)]
                |i| Lanes::splat(simd, row[i]).select(mask, lanes[i]),
            );
        }
        lanes
    }
}

impl<'a, S: Simd> ShadeBlock<'a, S> {
    /// The record of a run.
    pub(crate) fn setup(&self, run: &Run) -> &TriangleSetup {
        &self.setups.list[run.setup as usize]
    }

    /// A group without records.
    #[inline(always)]
    pub(crate) fn bare(
        simd: S,
        frame: &'a FrameView<'a>,
        setups: &'a TriangleSetups,
        object: &'a ObjectView,
        [px, py]: [Lanes<S>; 2],
    ) -> Self {
        Self { simd, frame, setups, object, runs: &[], px, py }
    }

    /// [`ShadeBlock::gather`] where there is one record.
    #[inline(always)]
    pub(crate) fn splat(&self, part: usize) -> [Lanes<S>; GROUP] {
        let row = self.setups.row(&self.runs[0], part);
        nine(
            #[inline(always)]
            |i| Lanes::splat(self.simd, row[i]),
        )
    }

    /// The place on the surface from the rows of the position, and the values of the attribute group
    /// with the second rows there.
    #[inline(always)]
    pub(crate) fn locate(&self, [position, attribute]: &[[Lanes<S>; GROUP]; 2]) -> (Place<S>, [Lanes<S>; 3]) {
        let place = self.place(position, self.px, self.py);
        (place, interpolate(attribute, &place))
    }

    /// Nine floats of each pixel's record, from the `part`-th nine on.
    #[inline(always)]
    pub(crate) fn gather(&self, part: usize) -> [Lanes<S>; GROUP] {
        self.setups.gather(self.simd, self.runs, part)
    }

    /// See [`place`].
    #[inline(always)]
    pub(crate) fn place(&self, rows: &[Lanes<S>; GROUP], px: Lanes<S>, py: Lanes<S>) -> Place<S> {
        let [u, v, distance] = place(self.frame, self.object, rows, px, py);
        Place { u, v, distance }
    }

    /// See [`on_surface`].
    #[inline(always)]
    fn on_surface(&self, rows: &[Lanes<S>; GROUP], u: Lanes<S>, v: Lanes<S>) -> Place<S> {
        let [u, v, distance] = on_surface(self.frame, self.object, rows, u, v);
        Place { u, v, distance }
    }

    /// The three values of an attribute group.
    #[inline(always)]
    pub(crate) fn attribute(&self, shade_block: usize, place: &Place<S>) -> [Lanes<S>; 3] {
        interpolate(&self.gather(1 + shade_block), place)
    }

    /// Position, normal and viewer of the pixels, from the interpolated normal.
    #[inline(always)]
    pub(crate) fn point(
        &self,
        place: &Place<S>,
        [x, y, z]: [Lanes<S>; 3],
    ) -> ShadingPoint<'static, Lanes<S>> {
        let (position, wo) = self.frame.camera.unproject(self.px, self.py, place.distance);
        let normal = Vec3::new(x, y, z);
        let normal = if self.frame.options.raw_normals { normal } else { unit(normal) };
        ShadingPoint { pixel: self.frame.lights.pixel, ..ShadingPoint::plain(position, normal, wo) }
    }

    /// Texture coordinates at another pixel position, for the footprint of textures; also beyond the
    /// triangle, so that the footprint does not shrink at its border.
    #[inline(always)]
    pub(crate) fn uv_at(
        &self,
        rows: &[Lanes<S>; GROUP],
        shade_block: usize,
        dx: f32,
        dy: f32,
    ) -> [Lanes<S>; 2] {
        let splat = inlined(
            #[inline(always)]
            |x| Lanes::splat(self.simd, x),
        );
        let [x0, y0, ux, uy, vx, vy, ..] = *rows;
        let (dx, dy) = (self.px + splat(dx) - x0, self.py + splat(dy) - y0);
        let place = self.on_surface(rows, dx * ux + dy * uy, dx * vx + dy * vy);
        let [u, v, _] = self.attribute(shade_block, &place);
        [u, v]
    }
}
