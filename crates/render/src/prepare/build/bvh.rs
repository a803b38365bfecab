//! The hierarchy over all opaque triangles.

use glam::{DVec3, Vec3, Vec3A};
use glanz_scene::AlphaMode;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use crate::prepare::data::{Bvh, BvhNode, PreparedMaterial, PreparedObject};
use crate::prepare::{PrepareError, Prepared};

/// How much larger than its triangle a box is, in sizes of the scene: more than rounding loses.
const MARGIN: f32 = 1e-6;

/// Depth of the tree from which on the builder looks for better pairs: its own medium setting.
const SEARCH_DEPTH: usize = 2;

/// Whether a material casts shadows.
pub(crate) fn is_opaque(material: &PreparedMaterial) -> bool {
    material.alpha_mode != AlphaMode::Blend && material.transmittance.is_none()
}

/// The greatest coordinate of an object that casts shadows, as of the numbers of scene files: beyond, boxes have no size in single
/// precision.
const FARTHEST: f64 = 1e12;

/// All triangles that let no light through. Those with holes by a texture count whole.
///
/// # Errors
/// If an object reaches farther than a tree can hold.
pub(crate) fn bvh(prepared: &Prepared) -> Result<Bvh, PrepareError> {
    let blocks = |object: &&PreparedObject| is_opaque(&prepared.materials[object.material]);
    let objects: Vec<&PreparedObject> = prepared.objects.iter().filter(blocks).collect();
    if objects.is_empty() {
        return Ok(Bvh { size: 1.0, ..Bvh::default() });
    }
    let (low, high) = objects.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), object| {
        let corner = |i: usize| DVec3::from_array(object.anchor) + DVec3::from_array(object.bounds[i]);
        (low.min(corner(0)), high.max(corner(1)))
    });
    if !(low.abs().max(high.abs()).cmple(DVec3::splat(FARTHEST)).all()) {
        let point = |p: DVec3| format!("({:.3e}, {:.3e}, {:.3e})", p.x, p.y, p.z);
        let what = format!(
            "with shadows, objects lie within coordinates of {FARTHEST:e}; those that cast them reach from {} to {}",
            point(low),
            point(high)
        );
        return Err(PrepareError::Scene { what });
    }
    let center = 0.5 * (low + high);
    let size = (high - low).length().max(1e-30) as f32;
    let mut triangles = Vec::new();
    for object in objects {
        add(&mut triangles, prepared, object, center);
    }
    let boxes: Vec<Aabb> = triangles.iter().map(|triangle| bounds(triangle, size * MARGIN)).collect();
    let indices = (0..triangles.len() as u32).collect();
    let tree = PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Medium,
        &boxes,
        indices,
        SortPrecision::U64,
        SEARCH_DEPTH,
    );
    let in_order = |i: &u32| triangles[*i as usize].map(|v| v.to_array());
    Ok(Bvh {
        center: center.to_array(),
        triangles: tree.primitive_indices.iter().map(in_order).collect(),
        nodes: nodes(&tree),
        size,
    })
}

fn nodes(tree: &Bvh2) -> Vec<BvhNode> {
    let plain = |node: &obvhs::bvh2::node::Bvh2Node| BvhNode {
        min: node.aabb().min.to_array(),
        max: node.aabb().max.to_array(),
        first: node.first_index,
        count: node.prim_count,
    };
    tree.nodes.iter().map(plain).collect()
}

fn add(triangles: &mut Vec<[Vec3A; 3]>, prepared: &Prepared, object: &PreparedObject, center: DVec3) {
    let geometry = &prepared.geometry;
    let shift = (DVec3::from_array(object.anchor) - center).as_vec3();
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
