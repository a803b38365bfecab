//! Sixteen pixels shaded: light, textures and views together.

use fearless_simd::Simd;
use glanz_math::inline::{inlined, three};
use glanz_math::{Lanes, LanesMask, Real, Vec3};
use glanz_scene::Shading;

use crate::cpu::frame::FrameView;
use crate::cpu::lighting::point::{Reflected, ShadingPoint, mixed, unit};
use crate::cpu::lighting::reflect::reflect_lanes;
use crate::cpu::lighting::shade_material::ShadeMaterial;
use crate::cpu::probe;
use crate::cpu::program;
use crate::cpu::shading::shade_block::{Place, ShadeBlock, Shaded};
use crate::cpu::shading::triangle_setup::{GROUP, TriangleSetups};
use crate::cpu::shading::{debug_view, texturing};
use crate::cpu::visibility::coverage_layers::Run;
use crate::view::DebugView;

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
        if object.program {
            shade_by_program(simd, frame, setups, own, [px, py], out);
            rest = others;
            continue;
        }
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

/// Runs the program of the runs' object for one triangle after the other.
#[inline(never)]
fn shade_by_program<S: Simd>(
    simd: S,
    frame: &FrameView,
    setups: &TriangleSetups,
    runs: &[Run],
    place: [Lanes<S>; 2],
    out: &mut Shaded<S>,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            for run in runs {
                let mut one = Shaded::nothing(simd);
                program::shade(simd, frame, setups, run, place, &mut one);
                out.merge(&one, LanesMask::from_bits(simd, run.bits));
            }
        },
    );
}

impl<S: Simd> ShadeBlock<'_, S> {
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
        if self.frame.record.is_none() && self.object.is_simple(self.frame.options.show) {
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

    /// Colour and normal where there are no textures, no vertex colours and no special view. `value` is
    /// the first attribute group, and `reflect` sums up the light at a point.
    #[inline(always)]
    pub(crate) fn simple(
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
        let mut rgb = with_emission(material, extra, textured, plain);
        let mut alpha = self.px.lit(f64::from(material.alpha)) * extra.alpha;
        if let Some(record) = self.frame.record {
            let rgb = probe::replace(record, self, place, (&point, alpha), extra);
            let alpha = self.px.one();
            let transmittance = [self.px.zero(); 3];
            return Shaded { rgb, alpha, transmittance, distance: place.distance, normal: point.normal };
        }
        debug_view::replace(self, place, rows, point.normal, extra, &mut rgb, &mut alpha);
        let transmittance = self.transmittance(material, place, point.normal);
        let normal = self.object.layout.normal.map_or(point.normal, |group| {
            let [x, y, z] = self.attribute(group, place);
            unit(Vec3::new(x, y, z))
        });
        Shaded { rgb, alpha, transmittance, distance: place.distance, normal }
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
}

/// The light of a textured surface: what it reflects and what it emits.
#[inline(always)]
fn with_emission<S: Simd>(
    material: &ShadeMaterial,
    extra: &texturing::SurfaceAttributes<S>,
    textured: [Lanes<S>; 3],
    plain: [Lanes<S>; 3],
) -> [Lanes<S>; 3] {
    match &material.mix {
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
                let emission = extra.emission[c];
                let emitted = emission.lit(f64::from(material.emission[c])) * emission;
                textured[c] * extra.base[c] + plain[c] + emitted
            },
        ),
    }
}
