//! Sixteen pixels: interpolation and shading.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real, Vec3};
use glanz_scene::{Interpolation, Shading};

use super::frame::{FrameView, ObjectView};
use super::gouraud::unit;
use super::inlined;
use super::records::{GROUP, Record, Records};
use super::reflect::{Point, reflect_lanes};
use super::runs::Run;
use super::{show, texturing};
use crate::Show;
use crate::prepare::PreparedMaterial;

/// What sixteen pixels show of one layer.
#[derive(Clone, Copy)]
pub(crate) struct Shaded<S: Simd> {
    pub rgb: [Lanes<S>; 3],
    pub alpha: Lanes<S>,
    pub distance: Lanes<S>,
    pub normal: Vec3<Lanes<S>>,
    pub object: [u32; 16],
}

/// Barycentric coordinates on the surface, and distance from the eye plane.
#[derive(Clone, Copy)]
pub(crate) struct Place<S: Simd> {
    pub u: Lanes<S>,
    pub v: Lanes<S>,
    pub distance: Lanes<S>,
}

/// Sixteen pixels of one object in one layer.
pub(crate) struct Group<'a, S: Simd> {
    pub simd: S,
    pub frame: &'a FrameView<'a>,
    pub records: &'a Records,
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
    records: &Records,
    runs: &[Run],
    px: Lanes<S>,
    py: Lanes<S>,
) -> Shaded<S> {
    let zero = Lanes::splat(simd, 0.0);
    let null = Vec3::new(zero, zero, zero);
    let mut shaded = Shaded { rgb: [zero; 3], alpha: zero, distance: zero, normal: null, object: [0; 16] };
    let mut rest = runs;
    while let Some(first) = rest.first() {
        let number = records.list[first.record as usize].object;
        // Runs of one object mostly stand together; those that do not are simply shaded again.
        let same = inlined(
            #[inline(always)]
            |run: &&Run| records.list[run.record as usize].object == number,
        );
        let count = rest.iter().take_while(same).count();
        let (own, others) = rest.split_at(count);
        let object = &frame.objects[number as usize];
        let group = Group { simd, frame, records, object, runs: own, px, py };
        let one = group.shade_outlined();
        if count == runs.len() {
            shaded = one;
            shaded.object = [number + 1; 16];
            return shaded;
        }
        let bits = own.iter().fold(0, |bits, run| bits | run.bits);
        shaded.merge(&one, LanesMask::from_bits(simd, bits));
        for lane in (0..16).filter(|lane| bits >> lane & 1 == 1) {
            shaded.object[lane] = number + 1;
        }
        rest = others;
    }
    shaded
}

impl<S: Simd> Shaded<S> {
    #[inline(always)]
    fn merge(&mut self, other: &Self, mask: LanesMask<S>) {
        for c in 0..3 {
            self.rgb[c] = other.rgb[c].select(mask, self.rgb[c]);
        }
        self.alpha = other.alpha.select(mask, self.alpha);
        self.distance = other.distance.select(mask, self.distance);
        self.normal.x = other.normal.x.select(mask, self.normal.x);
        self.normal.y = other.normal.y.select(mask, self.normal.y);
        self.normal.z = other.normal.z.select(mask, self.normal.z);
    }
}

impl<S: Simd> Group<'_, S> {
    /// The record of a run.
    pub fn record(&self, run: &Run) -> &Record {
        &self.records.list[run.record as usize]
    }

    /// Nine floats of each pixel's record, from the `part`-th nine on.
    #[inline(always)]
    fn gather(&self, part: usize) -> [Lanes<S>; GROUP] {
        let row = inlined(
            #[inline(always)]
            |run: &Run| -> &[f32; GROUP] {
                let start = self.record(run).offset as usize + part * GROUP;
                self.records.floats[start..].first_chunk().expect("records hold whole groups")
            },
        );
        let Some((first, others)) = self.runs.split_first() else {
            return [self.px.zero(); GROUP];
        };
        let mut lanes = row(first).map(
            #[inline(always)]
            |x| Lanes::splat(self.simd, x),
        );
        for run in others {
            let mask = LanesMask::from_bits(self.simd, run.bits);
            let row = row(run);
            for i in 0..GROUP {
                lanes[i] = Lanes::splat(self.simd, row[i]).select(mask, lanes[i]);
            }
        }
        lanes
    }

    /// The place on the surface that pixel positions show. Positions outside the triangle, by rounding
    /// or because a pixel is shaded at its centre, are brought to its border.
    #[inline(always)]
    fn place(&self, rows: &[Lanes<S>; GROUP], px: Lanes<S>, py: Lanes<S>) -> Place<S> {
        let [x0, y0, ux, uy, vx, vy, q0, dq1, dq2] = *rows;
        let (dx, dy) = (px - x0, py - y0);
        let u = (dx * ux + dy * uy).clamp(0.0, 1.0);
        let v = (dx * vx + dy * vy).clamp(0.0, 1.0);
        let depth = q0 + u * dq1 + v * dq2;
        if !self.frame.eye.perspective {
            return Place { u, v, distance: -depth };
        }
        let distance = depth.one() / depth;
        match self.object.interpolation {
            Interpolation::Perspective => {
                Place { u: u * (q0 + dq1) * distance, v: v * (q0 + dq2) * distance, distance }
            }
            _ => Place { u, v, distance },
        }
    }

    /// The three values of an attribute group.
    #[inline(always)]
    pub fn attribute(&self, group: usize, place: &Place<S>) -> [Lanes<S>; 3] {
        let rows = self.gather(1 + group);
        [0, 1, 2].map(
            #[inline(always)]
            |c| rows[c] + place.u * rows[3 + c] + place.v * rows[6 + c],
        )
    }

    /// [`Group::shade`] as a function of its own, which exists once per SIMD level.
    #[inline(never)]
    fn shade_outlined(&self) -> Shaded<S> {
        self.simd.vectorize(
            #[inline(always)]
            || self.shade(),
        )
    }

    #[inline(always)]
    fn shade(&self) -> Shaded<S> {
        let rows = self.gather(0);
        let place = self.place(&rows, self.px, self.py);
        let mut values = [self.attribute(0, &place), [self.px.zero(); 3]];
        let layout = &self.object.layout;
        let material = &self.frame.materials[self.object.material];
        let simple = layout.groups == 1
            && self.object.polygons.is_none()
            && matches!(
                self.frame.options.show,
                Show::Shaded | Show::Diffuse | Show::Specular | Show::Ambient
            );
        if simple {
            return self.simple(material, &place, values[0]);
        }
        let mut extra = texturing::Extra::new(self.px);
        extra.read(self, layout, material, &place, &rows);
        if let Some(plain) = layout.plain {
            values[1] = self.attribute(plain, &place);
        }
        if let Some(polygons) = &self.object.polygons {
            texturing::scanline(self, polygons, &mut values, &mut extra);
        }
        self.full(material, &place, values, &extra, &rows)
    }

    /// Position, normal and viewer of the pixels, from the interpolated normal.
    #[inline(always)]
    fn point(&self, place: &Place<S>, [x, y, z]: [Lanes<S>; 3]) -> Point<Lanes<S>> {
        let (position, wo) = self.frame.eye.unproject(self.px, self.py, place.distance);
        Point { position, normal: unit(Vec3::new(x, y, z)), wo }
    }

    /// No textures, no vertex colours, no special view.
    #[inline(always)]
    fn simple(&self, material: &PreparedMaterial, place: &Place<S>, value: [Lanes<S>; 3]) -> Shaded<S> {
        let like = self.px;
        let mut normal = Vec3::new(like.zero(), like.zero(), like.zero());
        let mut rgb = value;
        if self.object.shading == Shading::Phong {
            let point = self.point(place, value);
            normal = point.normal;
            let light = reflect_lanes(self.simd, &self.frame.lights, material, &point);
            rgb = [0, 1, 2].map(
                #[inline(always)]
                |c| light.textured[c] + light.plain[c],
            );
        }
        for c in 0..3 {
            rgb[c] = rgb[c] + like.lit(f64::from(material.emission[c]));
        }
        let alpha = like.lit(f64::from(material.alpha));
        Shaded { rgb, alpha, distance: place.distance, normal, object: [0; 16] }
    }

    /// Everything else.
    #[inline(always)]
    fn full(
        &self,
        material: &PreparedMaterial,
        place: &Place<S>,
        values: [[Lanes<S>; 3]; 2],
        extra: &texturing::Extra<S>,
        rows: &[Lanes<S>; GROUP],
    ) -> Shaded<S> {
        let mut point = self.point(place, values[0]);
        let [mut textured, mut plain] = values;
        if self.object.shading == Shading::Phong {
            point.normal = extra.bend(material, point.normal);
            let light = reflect_lanes(self.simd, &self.frame.lights, material, &point);
            textured = light.textured;
            plain = light.plain;
        }
        let mut rgb = [0, 1, 2].map(
            #[inline(always)]
            |c| {
                let emitted = self.px.lit(f64::from(material.emission[c])) * extra.emission[c];
                textured[c] * extra.base[c] + plain[c] + emitted
            },
        );
        let mut alpha = self.px.lit(f64::from(material.alpha)) * extra.alpha;
        show::replace(self, place, rows, point.normal, extra, &mut rgb, &mut alpha);
        Shaded { rgb, alpha, distance: place.distance, normal: point.normal, object: [0; 16] }
    }

    /// Texture coordinates at another pixel position, for the footprint of textures.
    #[inline(always)]
    pub fn uv_at(&self, rows: &[Lanes<S>; GROUP], group: usize, dx: f32, dy: f32) -> [Lanes<S>; 2] {
        let splat = inlined(
            #[inline(always)]
            |x| Lanes::splat(self.simd, x),
        );
        let place = self.place(rows, self.px + splat(dx), self.py + splat(dy));
        let [u, v, _] = self.attribute(group, &place);
        [u, v]
    }
}
