//! The points at which the illumination of a pixel is evaluated.

use glam::DVec3;
use glanz_math::Vec3;

use super::share::{Lit, array};
use super::{PointPlace, ProbedPoint};
use crate::cpu::frame::FrameView;
use crate::cpu::lighting::point::{ShadingPoint, unit};

/// A triangle of a facet.
pub(super) struct Corners {
    /// Numbers of its vertices in the arrays of the geometry.
    pub vertices: [usize; 3],
    /// The normal of its plane, as its vertices run.
    pub normal: DVec3,
}

/// The triangle of a facet that a pixel shows: that in which the interpolation's coordinates are nearest to its place.
pub(super) fn triangle(
    frame: &FrameView,
    object: usize,
    facet: u32,
    (position, [u, v]): (DVec3, [f32; 2]),
) -> Option<Corners> {
    let geometry = &frame.prepared.geometry;
    let prepared = &frame.prepared.objects[object];
    let at = position - DVec3::from_array(prepared.anchor);
    let place = |v: usize| {
        let [x, y, z] = &geometry.position;
        DVec3::new(f64::from(x[v]), f64::from(y[v]), f64::from(z[v]))
    };
    let mut best: Option<(f64, Corners)> = None;
    for cluster in &geometry.clusters[prepared.clusters.clone()] {
        let first = cluster.first_triangle as usize;
        for number in first..first + cluster.triangles as usize {
            if geometry.facets[number].0 != facet {
                continue;
            }
            let vertices = geometry.triangles[number].map(|v| cluster.first_vertex as usize + usize::from(v));
            let [a, b, c] = vertices.map(place);
            let normal = (b - a).cross(c - a);
            if normal == DVec3::ZERO {
                continue;
            }
            let away = (a + (b - a) * f64::from(u) + (c - a) * f64::from(v) - at).length_squared();
            if best.as_ref().is_none_or(|(least, _)| away < *least) {
                best = Some((away, Corners { vertices, normal: normal.normalize() }));
            }
        }
    }
    best.map(|(_, corners)| corners)
}

/// A point that is lit, taken apart.
pub(super) fn probed(lit: &Lit, place: PointPlace, weight: f32, world: DVec3) -> ProbedPoint {
    let point = lit.point;
    ProbedPoint {
        place,
        weight,
        position: world.to_array(),
        normal: array(point.normal),
        to_viewer: array(point.wo),
        cos_view: point.normal.dot(point.wo),
        color: lit.color,
        alpha_scale: point.alpha_scale,
        ambient: lit.ambient(),
        lights: lit.lights(),
        light: lit.whole(),
    }
}

/// A vertex as it is lit, on one side; and its colour.
pub(super) fn vertex(
    frame: &FrameView,
    object: usize,
    v: usize,
    back: bool,
) -> (ShadingPoint<'static, f32>, [f32; 3]) {
    let geometry = &frame.prepared.geometry;
    let prepared = &frame.prepared.objects[object];
    let material = &frame.materials[prepared.material];
    let [x, y, z] = &geometry.position;
    let position = frame.camera.offset(prepared) + Vec3::new(x[v], y[v], z[v]);
    let [nx, ny, nz] = geometry.normals[v];
    let mut point = ShadingPoint::plain(
        position,
        unit(Vec3::new(nx, ny, nz)) * side(back, material.two_sided),
        to_viewer(frame, position),
    )
    .at_means(material);
    if material.anisotropic && prepared.attributes.tangent {
        let [x, y, z, _] = geometry.tangents[v];
        point.tangent = Some(Vec3::new(x, y, z));
    }
    let color = match prepared.attributes.color {
        true => geometry.colors[v],
        false => [1.0; 4],
    };
    (point, [color[0], color[1], color[2]])
}

/// A facet as it is lit, at its centroid; its colour, and where that is relative to the object's anchor.
pub(super) fn centroid(
    frame: &FrameView,
    object: usize,
    facet: u32,
    back: bool,
) -> Option<(ShadingPoint<'static, f32>, [f32; 3], [f32; 3])> {
    let prepared = &frame.prepared.objects[object];
    let material = &frame.materials[prepared.material];
    let facets = prepared.facets.as_ref()?;
    let facet = facet as usize;
    let [x, y, z] = *facets.centroids.get(facet)?;
    let position = frame.camera.offset(prepared) + Vec3::new(x, y, z);
    let [nx, ny, nz] = facets.normals[facet];
    let normal = Vec3::new(nx, ny, nz) * side(back, material.two_sided);
    let color = facets.colors.get(facet).map_or([1.0; 3], |c| [c[0], c[1], c[2]]);
    let point = ShadingPoint::plain(position, normal, to_viewer(frame, position)).at_means(material);
    Some((point, color, [x, y, z]))
}

/// What a normal is multiplied with: 0 on a back face that is not lit.
fn side(back: bool, two_sided: bool) -> f32 {
    match (back, two_sided) {
        (false, _) => 1.0,
        (true, true) => -1.0,
        (true, false) => 0.0,
    }
}

fn to_viewer(frame: &FrameView, position: Vec3<f32>) -> Vec3<f32> {
    let [x, y, z] = frame.camera.back;
    if frame.camera.perspective { unit(-position) } else { Vec3::new(x, y, z) }
}
