//! Sixteen pixels: interpolation and shading.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real, Vec3};
use glanz_scene::Shading;

use super::surface::{interpolated, on_surface, place};
use crate::cpu::frame::{FrameView, ObjectView};
use crate::cpu::lighting::reflect::{Reflected, ShadingPoint, mixed, reflect_lanes};
use crate::cpu::lighting::shade_material::ShadeMaterial;
use crate::cpu::shading::debug_view;
use crate::cpu::shading::gouraud::unit;
use crate::cpu::shading::texturing;
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetup, TriangleSetups};
use crate::cpu::visibility::coverage_layers::Run;
use crate::view::DebugView;
use glanz_math::inline::inlined;
use glanz_math::inline::nine;
use glanz_math::inline::three;

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

/// Shades a layer, object by object.
#[inline(always)]
pub(crate) fn shade<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    runs: &[Run],
    [px, py]: [Lanes<S>; 2],
    out: &mut Shaded<S>,
) {
    let object_of = inlined(
        #[inline(always)]
        |run: &Run| setups.list[run.setup as usize].object,
    );
    let mut rest = runs;
    while let Some(first) = rest.first() {
        let number = object_of(first);
        // Runs of one object mostly stand together; those that do not are simply shaded again.
        let mut count = 1;
        while count < rest.len() && object_of(&rest[count]) == number {
            count += 1;
        }
        let (own, others) = rest.split_at(count);
        let object = &frame.objects[number as usize];
        let shade_block = ShadeBlock { simd, frame, setups, object, runs: own, px, py };
        if count == runs.len() {
            shade_block.shade_outlined(out);
            return;
        }
        let mut one = Shaded::nothing(simd);
        shade_block.shade_outlined(&mut one);
        let bits = own.iter().fold(0, |bits, run| bits | run.bits);
        out.merge(&one, LanesMask::from_bits(simd, bits));
        rest = others;
    }
}

/// Whether [`ShadeBlock::simple`] gives the object's colours.
#[inline(always)]
pub(crate) fn is_simple(object: &ObjectView, show: DebugView) -> bool {
    object.layout.groups == 1
        && object.polygons.is_none()
        && matches!(show, DebugView::Shaded | DebugView::Diffuse | DebugView::Specular | DebugView::Ambient)
}

/// The three values of the attribute group with these rows.
#[inline(always)]
pub(crate) fn interpolate<S: Simd>(rows: &[Lanes<S>; GROUP], place: &Place<S>) -> [Lanes<S>; 3] {
    interpolated(rows, place.u, place.v)
}

impl<S: Simd> Shaded<S> {
    /// All zero.
    #[inline(always)]
    pub fn nothing(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let normal = Vec3::new(zero, zero, zero);
        Self { rgb: [zero; 3], alpha: zero, transmittance: [zero; 3], distance: zero, normal }
    }

    #[inline(always)]
    fn merge(&mut self, other: &Self, mask: LanesMask<S>) {
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

impl<'a, S: Simd> ShadeBlock<'a, S> {
    /// The record of a run.
    pub fn setup(&self, run: &Run) -> &TriangleSetup {
        &self.setups.list[run.setup as usize]
    }

    /// A group without records.
    #[inline(always)]
    pub fn bare(
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
    pub fn splat(&self, part: usize) -> [Lanes<S>; GROUP] {
        let start = self.setup(&self.runs[0]).offset as usize + part * GROUP;
        let row: &[f32; GROUP] =
            self.setups.floats[start..].first_chunk().expect("records hold whole groups");
        nine(
            #[inline(always)]
            |i| Lanes::splat(self.simd, row[i]),
        )
    }

    /// The place on the surface from the rows of the position, and the values of the attribute group
    /// with the second rows there.
    #[inline(always)]
    pub fn locate(&self, [position, attribute]: &[[Lanes<S>; GROUP]; 2]) -> (Place<S>, [Lanes<S>; 3]) {
        let place = self.place(position, self.px, self.py);
        (place, interpolate(attribute, &place))
    }

    /// Nine floats of each pixel's record, from the `part`-th nine on.
    #[inline(always)]
    pub fn gather(&self, part: usize) -> [Lanes<S>; GROUP] {
        let row = inlined(
            #[inline(always)]
            |run: &Run| -> &[f32; GROUP] {
                let start = self.setup(run).offset as usize + part * GROUP;
                self.setups.floats[start..].first_chunk().expect("records hold whole groups")
            },
        );
        let Some((first, others)) = self.runs.split_first() else {
            return [self.px.zero(); GROUP];
        };
        let first = row(first);
        let mut lanes = nine(
            #[inline(always)]
            |i| Lanes::splat(self.simd, first[i]),
        );
        for run in others {
            let mask = LanesMask::from_bits(self.simd, run.bits);
            let row = row(run);
            lanes = nine(
                #[inline(always)]
                |i| Lanes::splat(self.simd, row[i]).select(mask, lanes[i]),
            );
        }
        lanes
    }

    /// See [`place`].
    #[inline(always)]
    pub fn place(&self, rows: &[Lanes<S>; GROUP], px: Lanes<S>, py: Lanes<S>) -> Place<S> {
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
    pub fn attribute(&self, shade_block: usize, place: &Place<S>) -> [Lanes<S>; 3] {
        interpolate(&self.gather(1 + shade_block), place)
    }

    /// [`ShadeBlock::shade`] as a function of its own, which exists once per SIMD level.
    #[inline(never)]
    fn shade_outlined(&self, out: &mut Shaded<S>) {
        self.simd.vectorize(
            #[inline(always)]
            || self.shade(out),
        );
    }

    #[inline(always)]
    fn shade(&self, out: &mut Shaded<S>) {
        let rows = self.gather(0);
        let place = self.place(&rows, self.px, self.py);
        let mut values = [[self.px.zero(); 3]; 4];
        values[0] = self.attribute(0, &place);
        let layout = &self.object.layout;
        let material = &self.frame.materials[self.object.material];
        if is_simple(self.object, self.frame.options.show) {
            let lights = &self.frame.lights;
            let light =
                |point: &ShadingPoint<Lanes<S>>| reflect_lanes(self.simd, lights, material, point, None);
            let (rgb, normal) = self.simple(material, &place, values[0], light);
            let alpha = self.px.lit(f64::from(material.alpha));
            let transmittance = self.transmittance(material, &place, normal);
            *out = Shaded { rgb, alpha, transmittance, distance: place.distance, normal };
            return;
        }
        let mut extra = texturing::SurfaceAttributes::new(self.px);
        extra.read(self, layout, material, &place, &rows);
        if let Some(plain) = layout.plain {
            values[1] = self.attribute(plain, &place);
        }
        if let Some(mix) = layout.mix {
            values[2] = self.attribute(mix, &place);
            values[3] = self.attribute(mix + 1, &place);
        }
        if let Some(polygons) = &self.object.polygons {
            texturing::scanline(self, polygons, &mut values, &mut extra);
        }
        *out = self.full(material, &place, values, &extra, &rows);
    }

    /// Position, normal and viewer of the pixels, from the interpolated normal.
    #[inline(always)]
    fn point(&self, place: &Place<S>, [x, y, z]: [Lanes<S>; 3]) -> ShadingPoint<Lanes<S>> {
        let (position, wo) = self.frame.camera.unproject(self.px, self.py, place.distance);
        ShadingPoint::plain(position, unit(Vec3::new(x, y, z)), wo)
    }

    /// Colour and normal where there are no textures, no vertex colours and no special view. `value` is
    /// the first attribute group, and `reflect` sums up the light at a point.
    #[inline(always)]
    pub fn simple(
        &self,
        material: &ShadeMaterial,
        place: &Place<S>,
        value: [Lanes<S>; 3],
        reflect: impl Fn(&ShadingPoint<Lanes<S>>) -> Reflected<Lanes<S>>,
    ) -> ([Lanes<S>; 3], Vec3<Lanes<S>>) {
        let like = self.px;
        let mut normal = Vec3::new(like.zero(), like.zero(), like.zero());
        let mut rgb = value;
        if self.object.shading == Shading::Phong {
            let point = self.point(place, value);
            normal = point.normal;
            let light = reflect(&point);
            rgb = three(
                [0, 1, 2],
                #[inline(always)]
                |c| light.textured[c] + light.plain[c],
            );
        }
        for (value, emission) in rgb.iter_mut().zip(material.emission) {
            *value = *value + like.lit(f64::from(emission));
        }
        (rgb, normal)
    }

    /// Everything else.
    #[inline(always)]
    fn full(
        &self,
        material: &ShadeMaterial,
        place: &Place<S>,
        values: [[Lanes<S>; 3]; 4],
        extra: &texturing::SurfaceAttributes<S>,
        rows: &[Lanes<S>; GROUP],
    ) -> Shaded<S> {
        let mut point = self.point(place, values[0]);
        let [mut textured, mut plain, second, third] = values;
        if self.object.layout.mix.is_some() {
            let [r, g, b] = extra.base;
            let first = textured;
            textured = three(
                [0, 1, 2],
                #[inline(always)]
                |c| first[c] * r + second[c] * g + third[c] * b,
            );
        }
        if self.object.shading == Shading::Phong {
            extra.apply(material, &mut point);
            let varies = self.object.layout.color.is_some() || material.base_color.is_some();
            let texel = varies.then_some(extra.base);
            let light = reflect_lanes(self.simd, &self.frame.lights, material, &point, texel);
            textured = light.textured;
            plain = light.plain;
        }
        let mut rgb = match &material.mix {
            Some(mix) => {
                let emitted = mixed(&mix.emission, &extra.emission);
                three(
                    [0, 1, 2],
                    #[inline(always)]
                    |c| textured[c] + plain[c] + emitted[c],
                )
            }
            None => three(
                [0, 1, 2],
                #[inline(always)]
                |c| {
                    let emitted = self.px.lit(f64::from(material.emission[c])) * extra.emission[c];
                    textured[c] * extra.base[c] + plain[c] + emitted
                },
            ),
        };
        let mut alpha = self.px.lit(f64::from(material.alpha)) * extra.alpha;
        debug_view::replace(self, place, rows, point.normal, extra, &mut rgb, &mut alpha);
        let transmittance = self.transmittance(material, place, point.normal);
        Shaded { rgb, alpha, transmittance, distance: place.distance, normal: point.normal }
    }

    /// The transmittance of the surface along the line of sight. Where no normal is known for the pixel, as on
    /// objects that are not shaded per pixel, the surface is taken to face the viewer.
    #[inline(always)]
    fn transmittance(
        &self,
        material: &ShadeMaterial,
        place: &Place<S>,
        normal: Vec3<Lanes<S>>,
    ) -> [Lanes<S>; 3] {
        let zero = self.px.zero();
        let Some(series) =
            material.transmittance.as_ref().filter(|_| self.frame.options.show == DebugView::Shaded)
        else {
            return [zero; 3];
        };
        let mut cosine = zero.one();
        if self.object.shading == Shading::Phong {
            let (_, wo) = self.frame.camera.unproject(self.px, self.py, place.distance);
            cosine = normal.dot(wo).abs().min(cosine);
        }
        series.at(cosine).map(
            #[inline(always)]
            |fraction| fraction.clamp(0.0, 1.0),
        )
    }

    /// Texture coordinates at another pixel position, for the footprint of textures; also beyond the
    /// triangle, so that the footprint does not shrink at its border.
    #[inline(always)]
    pub fn uv_at(&self, rows: &[Lanes<S>; GROUP], shade_block: usize, dx: f32, dy: f32) -> [Lanes<S>; 2] {
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
