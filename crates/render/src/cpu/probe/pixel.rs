//! A pixel's surface, and its points.

use glam::DVec3;
use glanz_math::Vec3;
use glanz_scene::{Background, Interpolation, Shading};

use super::point::{self, probed};
use super::share::{Lit, add, array};
use super::{PointPlace, ProbedPoint, ProbedSurface, Record};
use crate::cpu::Renderer;
use crate::cpu::frame::FrameView;
use crate::cpu::lighting::point::{ShadingPoint, mixed};
use crate::prepare::PreparedMaterial;
use crate::view::{Aovs, DrawOptions, Samples, View};
use crate::{DebugView, Prepared};

/// What a pixel of the picture has with one sample in its middle, and the surface there, taken apart.
pub(crate) fn probe(
    prepared: &Prepared,
    view: &View,
    draw: &DrawOptions,
    pixel: (u32, u32),
) -> ([f32; 3], Option<ProbedSurface>) {
    let mut renderer = Renderer::new();
    let aovs = Aovs { depth: true, normal: true, object: true };
    let options = DrawOptions { samples: Samples::One, supersample: false, aovs, ..*draw };
    let drawn = renderer.middle(prepared, view, &options, draw);
    let index = pixel.1 as usize * drawn.width + pixel.0 as usize;
    let middle = drawn.rgb.each_ref().map(|plane| plane[index]);
    let frame = FrameView::new(prepared, view, &options, None).with_rims_of(draw);
    // The nearest surface, also one that lets through what is behind it.
    let nearest = renderer.record(prepared, view, &options, Record::Opacity);
    let object = (nearest.object[index] as usize).checked_sub(1);
    let surface = object.and_then(|object| {
        let place = Looked {
            frame: &frame,
            options: &options,
            view,
            index,
            object,
            at: [pixel.0 as f32 + 0.5, pixel.1 as f32 + 0.5],
            opacity: nearest.rgb[0][index],
            distance: nearest.depth[index],
            normal: nearest.normal.each_ref().map(|plane| plane[index]),
        };
        place.surface(&mut renderer)
    });
    (middle, surface)
}

/// The pixel that shows an object nearest to these texture coordinates, and the coordinates that it shows.
pub(crate) fn pixel_of(
    prepared: &Prepared,
    view: &View,
    object: usize,
    wanted: [f32; 2],
) -> Option<((u32, u32), [f32; 2])> {
    let aovs = Aovs { object: true, ..Aovs::default() };
    let show = DebugView::Uv;
    let options = DrawOptions { aovs, show, ..DrawOptions::new(Background::Transparent) };
    let frame = Renderer::new().record(prepared, view, &options, Record::Uv);
    let [u, v, has_uv] = &frame.rgb;
    let shows = |i: &usize| frame.object[*i] as usize == object + 1 && has_uv[*i] > 0.0;
    let away = |i: usize| (u[i] - wanted[0]).hypot(v[i] - wanted[1]);
    let nearest = (0..u.len()).filter(shows).min_by(|a, b| away(*a).total_cmp(&away(*b)))?;
    let (x, y) = (nearest % frame.width, nearest / frame.width);
    Some(((x as u32, y as u32), [u[nearest], v[nearest]]))
}

/// A pixel that shows an object.
struct Looked<'a> {
    frame: &'a FrameView<'a>,
    options: &'a DrawOptions,
    view: &'a View,
    index: usize,
    object: usize,
    at: [f32; 2],
    opacity: f32,
    distance: f32,
    normal: [f32; 3],
}

impl Looked<'_> {
    fn record(&self, renderer: &mut Renderer, record: Record) -> [f32; 3] {
        let options = DrawOptions { aovs: Aovs::default(), ..*self.options };
        let frame = renderer.record(self.frame.prepared, self.view, &options, record);
        frame.rgb.each_ref().map(|plane| plane[self.index])
    }

    fn surface(&self, renderer: &mut Renderer) -> Option<ProbedSurface> {
        let prepared = &self.frame.prepared.objects[self.object];
        let [high, low, back] = self.record(renderer, Record::Facet);
        let (facet, back) = ((high as u32) << 16 | low as u32, back > 0.0);
        let (relative, wo) = self.frame.camera.unproject(self.at[0], self.at[1], self.distance);
        let position = DVec3::from_array(self.frame.camera.position()) + double(relative);
        let [u, v, _] = self.record(renderer, Record::Place);
        let corners = point::triangle(self.frame, self.object, facet, (position, [u, v]))?;
        let base = self.record(renderer, Record::Base);
        let emitted = self.record(renderer, Record::Emission);
        let [s, t, has_uv] = self.record(renderer, Record::Uv);
        let points = match prepared.shading {
            Shading::Phong => vec![self.phong(renderer, (relative, wo), base, position)],
            Shading::Flat => vec![self.flat(facet, back, base)?],
            Shading::Gouraud => self.gouraud([u, v], &corners, back, base),
        };
        let material = &self.frame.materials[prepared.material];
        let emission = emission(material, &emitted);
        let mut light = [0.0; 3];
        for point in &points {
            light = add(light, point.light.map(|c| c * point.weight));
        }
        let side = if back { -1.0 } else { 1.0 };
        Some(ProbedSurface {
            object: self.object,
            material: prepared.material,
            shading: prepared.shading,
            interpolation: prepared.interpolation,
            facet,
            back,
            facet_normal: (corners.normal * side).to_array(),
            position: position.to_array(),
            distance: self.distance,
            uv: (has_uv > 0.0).then_some([s, t]),
            base,
            points,
            emission,
            light: add(light, emission),
            opacity: self.opacity,
            transmits: material.transmittance.is_some(),
        })
    }

    fn lit<'a>(&'a self, point: &'a ShadingPoint<f32>, color: [f32; 3], mixes: bool) -> Lit<'a> {
        let material = &self.frame.materials[self.frame.prepared.objects[self.object].material];
        let mixes = mixes && material.mix.is_some();
        Lit { lights: &self.frame.lights, material, point, color, mixes }
    }

    /// The pixel itself.
    fn phong(
        &self,
        renderer: &mut Renderer,
        (relative, wo): (Vec3<f32>, Vec3<f32>),
        base: [f32; 3],
        world: DVec3,
    ) -> ProbedPoint {
        let [x, y, z] = self.normal;
        let mut point = ShadingPoint::plain(relative, Vec3::new(x, y, z), wo);
        point.pixel = self.frame.lights.pixel;
        let [alpha_scale, metal, has_tangent] = self.record(renderer, Record::Roughness);
        (point.alpha_scale, point.metal) = (alpha_scale, metal);
        if has_tangent > 0.0 {
            let [x, y, z] = self.record(renderer, Record::Tangent);
            point.tangent = Some(Vec3::new(x, y, z));
        }
        let object = &self.frame.objects[self.object];
        let material = &self.frame.materials[object.material];
        let groups = (0..material.channels.len()).step_by(3);
        let channels: Vec<f32> =
            groups.flat_map(|first| self.record(renderer, Record::Channels(first))).collect();
        if object.layout.uv.is_some() {
            point.channels = &channels[..material.channels.len()];
        }
        let varies = object.layout.color.is_some() || material.base_color.is_some();
        probed(&self.lit(&point, base, varies), PointPlace::Pixel, 1.0, world)
    }

    /// The centroid of the facet.
    fn flat(&self, facet: u32, back: bool, base: [f32; 3]) -> Option<ProbedPoint> {
        let (point, color, relative) = point::centroid(self.frame, self.object, facet, back)?;
        let anchor = DVec3::from_array(self.frame.prepared.objects[self.object].anchor);
        let world = anchor + DVec3::from_array(relative.map(f64::from));
        let color = core::array::from_fn(|c| color[c] * base[c]);
        Some(probed(&self.lit(&point, color, true), PointPlace::Centroid, 1.0, world))
    }

    /// The corners of the triangle.
    fn gouraud(
        &self,
        [u, v]: [f32; 2],
        corners: &point::Corners,
        back: bool,
        base: [f32; 3],
    ) -> Vec<ProbedPoint> {
        let weights = [1.0 - u - v, u, v];
        let geometry = &self.frame.prepared.geometry;
        let prepared = &self.frame.prepared.objects[self.object];
        let textured = self.frame.materials[prepared.material].base_color.is_some();
        let corner = |(vertex, weight): (usize, f32)| {
            let (point, color) = point::vertex(self.frame, self.object, vertex, back);
            let color = core::array::from_fn(|c| color[c] * base[c]);
            let mixes = textured || prepared.attributes.color;
            let world = DVec3::from_array(self.frame.camera.position()) + double(point.position);
            let place = PointPlace::Vertex(geometry.sources[vertex]);
            probed(&self.lit(&point, color, mixes), place, weight, world)
        };
        corners.vertices.into_iter().zip(weights).map(corner).collect()
    }
}

/// Light of a surface's own, of which textures leave so much.
fn emission(material: &PreparedMaterial, left: &[f32; 3]) -> [f32; 3] {
    match &material.mix {
        Some(mix) => mixed(&mix.emission, left),
        None => core::array::from_fn(|c| material.emission[c] * left[c]),
    }
}

fn double(v: Vec3<f32>) -> DVec3 {
    DVec3::from_array(array(v).map(f64::from))
}

impl ProbedSurface {
    /// Whether the sum of the points is what the picture has: along scan lines values are interpolated over whole polygons,
    /// and not by the weights of three corners.
    pub fn is_exact(&self) -> bool {
        self.interpolation != Interpolation::Scanline || self.shading == Shading::Flat
    }
}
