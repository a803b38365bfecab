//! The scheme of 1971: values run linearly along the edges of the whole polygon, then along the
//! scanline. What comes out depends on how the polygon is turned on the screen.

use std::sync::Arc;

use glanz_color::Rgb;
use glanz_math::Vec3;
use glanz_scene::Shading;

use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::lighting::point::unit;
use crate::cpu::lighting::reflect::reflect;
use crate::cpu::lighting::shade_material::{ShadeLights, ShadeMaterial};
use crate::prepare::{Polygons, PreparedObject};
use crate::view::camera::ViewCamera;

/// The values that are interpolated at a corner: normal or light, plain light, texture coordinates,
/// colour with alpha, light through the second and third spectrum that texels mix.
pub(crate) type PolygonCorner = [f32; CORNER];

/// The numbers of a corner.
pub(crate) const CORNER: usize = 18;

/// An object's polygons as seen from the eye.
#[derive(Clone, Debug)]
pub(crate) struct PolygonView {
    polygons: Arc<Polygons>,
    /// Screen position of each corner; none behind the eye.
    screen: Vec<Option<[f32; 2]>>,
    /// Values on front and back faces.
    values: [Vec<PolygonCorner>; 2],
}

impl PolygonView {
    pub(crate) fn new(
        polygons: &Arc<Polygons>,
        object: &PreparedObject,
        camera: &ViewCamera,
        lights: &ShadeLights,
        material: &ShadeMaterial,
    ) -> Self {
        let offset = camera.offset(object);
        let count = polygons.positions.len();
        let at = |i: usize| {
            let [x, y, z] = polygons.positions[i];
            offset + Vec3::new(x, y, z)
        };
        let screen = (0..count).map(|i| project(camera, at(i))).collect();
        let has_texels = object.attributes.uv && material.base_color.is_some();
        let values = [1.0, if material.two_sided { -1.0 } else { 0.0 }].map(|side| {
            (0..count)
                .map(|i| {
                    corner(polygons, i, at(i), side, object.shading, camera, lights, material, has_texels)
                })
                .collect()
        });
        Self { polygons: Arc::clone(polygons), screen, values }
    }

    /// The values at a pixel position inside a facet, or `None` where a corner is behind the eye and
    /// the scheme has no edges to follow.
    pub(crate) fn interpolate(&self, facet: u32, back: bool, px: f32, py: f32) -> Option<PolygonCorner> {
        let corners = self.polygons.corners(facet);
        let values = &self.values[usize::from(back)];
        let mut left: Option<(f32, PolygonCorner)> = None;
        let mut right: Option<(f32, PolygonCorner)> = None;
        for i in corners.clone() {
            let next = if i + 1 == corners.end { corners.start } else { i + 1 };
            let (a, b) = (self.screen[i]?, self.screen[next]?);
            if (a[1] <= py) == (b[1] <= py) {
                continue;
            }
            let t = (py - a[1]) / (b[1] - a[1]);
            let x = a[0] + (b[0] - a[0]) * t;
            let value = mix(&values[i], &values[next], t);
            // Of a polygon that is not convex: the span around the pixel.
            if x <= px && left.as_ref().is_none_or(|(nearest, _)| x > *nearest) {
                left = Some((x, value));
            } else if x > px && right.as_ref().is_none_or(|(nearest, _)| x < *nearest) {
                right = Some((x, value));
            }
        }
        match (left, right) {
            (Some((from, a)), Some((to, b))) => Some(mix(&a, &b, (px - from) / (to - from))),
            (one, other) => one.or(other).map(|(_, value)| value),
        }
    }
}

fn mix(a: &PolygonCorner, b: &PolygonCorner, t: f32) -> PolygonCorner {
    core::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
}

fn project(camera: &ViewCamera, p: Vec3<f32>) -> Option<[f32; 2]> {
    let axis = |a: &[f32; 3]| Vec3::new(a[0], a[1], a[2]);
    let distance = -p.dot(axis(&camera.back));
    if distance < camera.near {
        return None;
    }
    let factor = if camera.perspective { camera.scale / distance } else { camera.scale };
    Some([
        camera.center[0] + p.dot(axis(&camera.right)) * factor,
        camera.center[1] - p.dot(axis(&camera.up)) * factor,
    ])
}

#[expect(clippy::too_many_arguments, reason = "a corner takes a value from each stage of the frame")]
fn corner(
    polygons: &Polygons,
    i: usize,
    position: Vec3<f32>,
    side: f32,
    shading: Shading,
    camera: &ViewCamera,
    lights: &ShadeLights,
    material: &ShadeMaterial,
    has_texels: bool,
) -> PolygonCorner {
    let [x, y, z] = polygons.normals[i];
    let normal = Vec3::new(x, y, z) * side;
    let [r, g, b, alpha] = polygons.colors[i];
    let mut more = [[0.0; 3]; 2];
    let (first, plain) = match shading {
        Shading::Gouraud => {
            let wo = if camera.perspective {
                unit(-position)
            } else {
                Vec3::new(camera.back[0], camera.back[1], camera.back[2])
            };
            let point = ShadingPoint::plain(position, unit(normal), wo).at_means(material);
            match (&material.mix, has_texels) {
                (None, _) => {
                    let reflected = reflect(lights, material, &point, None);
                    ((Rgb(reflected.textured) * Rgb([r, g, b])).0, reflected.plain)
                }
                (Some(_), false) => {
                    let reflected = reflect(lights, material, &point, Some([r, g, b]));
                    (reflected.textured, reflected.plain)
                }
                (Some(_), true) => {
                    let transmittance = |texel| reflect(lights, material, &point, Some(texel));
                    let first = transmittance([r, 0.0, 0.0]);
                    more = [[0.0, g, 0.0], [0.0, 0.0, b]].map(|texel| transmittance(texel).textured);
                    (first.textured, first.plain)
                }
            }
        }
        _ => ([normal.x, normal.y, normal.z], [0.0; 3]),
    };
    let [u, v] = polygons.uvs[i];
    let [second, third] = more;
    let mut corner = [0.0; CORNER];
    corner[..12]
        .copy_from_slice(&[first[0], first[1], first[2], plain[0], plain[1], plain[2], u, v, r, g, b, alpha]);
    corner[12..15].copy_from_slice(&second);
    corner[15..].copy_from_slice(&third);
    corner
}
