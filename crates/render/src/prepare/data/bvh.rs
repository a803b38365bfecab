//! What stands between a surface and a light: all opaque triangles of the scene, found fast.

use glam::{DVec3, Vec3, Vec3A};
use glanz_scene::AlphaMode;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use obvhs::ray::Ray;

use crate::prepare::Prepared;
use crate::prepare::PreparedObject;

/// How far from a surface a ray starts, so that it does not meet that surface: some tens of times the rounding of
/// positions in `f32` among the occluders, in sizes of the scene.
const OFFSET: f32 = 3e-6;

/// How much larger than its triangle a box is, in sizes of the scene: more than rounding loses.
const MARGIN: f32 = 1e-6;

/// Depth of the tree from which on the builder looks for better pairs: its own medium setting.
const SEARCH_DEPTH: usize = 2;

/// The triangles that cast shadows, relative to a point of the world.
#[derive(Clone)]
pub struct Bvh {
    center: DVec3,
    /// A corner and the two edges from it, in the order of the tree.
    triangles: Vec<[Vec3A; 3]>,
    tree: Option<Bvh2>,
    size: f32,
}

impl core::fmt::Debug for Bvh {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Occluders({} triangles)", self.triangles.len())
    }
}

impl Bvh {
    /// All triangles that let no light through. Those with holes by a texture count whole.
    pub(crate) fn new(prepared: &Prepared) -> Self {
        let blocks = |object: &&PreparedObject| {
            let material = &prepared.materials[object.material];
            material.alpha_mode != AlphaMode::Blend && material.transmittance.is_none()
        };
        let objects: Vec<&PreparedObject> = prepared.objects.iter().filter(blocks).collect();
        let (low, high) =
            objects.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), object| {
                (low.min(object.anchor + object.bounds[0]), high.max(object.anchor + object.bounds[1]))
            });
        if objects.is_empty() {
            return Self { center: DVec3::ZERO, triangles: Vec::new(), tree: None, size: 1.0 };
        }
        let center = 0.5 * (low + high);
        let size = (high - low).length().max(1e-30) as f32;
        let mut triangles = Vec::new();
        for object in objects {
            add(&mut triangles, prepared, object, center);
        }
        let boxes: Vec<Aabb> = triangles.iter().map(|triangle| bounds(triangle, size * MARGIN)).collect();
        let indices = (0..triangles.len() as u32).collect();
        let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
            PlocSearchDistance::Medium,
            &boxes,
            indices,
            SortPrecision::U64,
            SEARCH_DEPTH,
        );
        let order = core::mem::take(&mut tree.primitive_indices);
        let triangles = order.iter().map(|i| triangles[*i as usize]).collect();
        Self { center, triangles, tree: Some(tree), size }
    }

    /// The point that rays are relative to.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// Whether nothing is between a point of a surface, off it by so much at most and with this normal (towards the
    /// light's side), and a light in this unit direction, at this distance.
    pub fn is_unoccluded(
        &self,
        (point, off): ([f32; 3], f32),
        normal: [f32; 3],
        towards: [f32; 3],
        distance: f32,
    ) -> bool {
        let Some(tree) = &self.tree else { return true };
        let offset = self.size * OFFSET + off;
        let origin = Vec3A::from_array(point) + Vec3A::from_array(normal) * offset;
        let direction = Vec3A::from_array(towards);
        let is_number = origin.is_finite() && direction.is_finite() && direction.length_squared() > 0.5;
        if !is_number {
            return true;
        }
        // Infinite distances stop beyond the scene; what is farther cannot be there.
        let end = (distance - offset).min(4.0 * (self.size + origin.length()));
        if end <= 0.0 {
            return true;
        }
        let ray = Ray::new(origin, direction, 0.0, end);
        tree.ray_traverse_miss(ray, |ray, number| hit(ray, &self.triangles[number]))
    }
}

/// Where a ray meets a triangle, or infinity. Source: T. Möller and B. Trumbore, "Fast, Minimum Storage
/// Ray-Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
fn hit(ray: &Ray, [corner, first, second]: &[Vec3A; 3]) -> f32 {
    let p = ray.direction.cross(*second);
    let determinant = first.dot(p);
    if determinant == 0.0 {
        return f32::INFINITY;
    }
    let inverse = 1.0 / determinant;
    let from = ray.origin - *corner;
    let u = from.dot(p) * inverse;
    let q = from.cross(*first);
    let v = ray.direction.dot(q) * inverse;
    let t = second.dot(q) * inverse;
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > ray.tmin;
    if inside { t } else { f32::INFINITY }
}

fn add(triangles: &mut Vec<[Vec3A; 3]>, prepared: &Prepared, object: &PreparedObject, center: DVec3) {
    let geometry = &prepared.geometry;
    let shift = (object.anchor - center).as_vec3();
    for cluster in &geometry.clusters[object.clusters.clone()] {
        let position = |vertex: u8| {
            let at = cluster.first_vertex as usize + vertex as usize;
            Vec3A::from(Vec3::from_array(core::array::from_fn(|axis| geometry.position[axis][at])) + shift)
        };
        let first = cluster.first_triangle as usize;
        for triangle in &geometry.triangles[first..first + cluster.triangles as usize] {
            let [a, b, c] = triangle.map(position);
            triangles.push([a, b - a, c - a]);
        }
    }
}

fn bounds([corner, first, second]: &[Vec3A; 3], margin: f32) -> Aabb {
    let (a, b) = (*corner + *first, *corner + *second);
    let margin = Vec3A::splat(margin);
    Aabb::new(corner.min(a).min(b) - margin, corner.max(a).max(b) + margin)
}
