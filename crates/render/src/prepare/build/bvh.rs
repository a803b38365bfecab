//! The hierarchy over all opaque triangles.

use glam::{DVec3, Vec3, Vec3A};
use glanz_scene::AlphaMode;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use crate::prepare::data::{Bvh, BvhNode, PreparedMaterial, PreparedObject};
use crate::prepare::{PrepareError, Prepared};

/// How much larger than its triangle a box is, in parts of the coordinates: more than rounding loses.
const MARGIN: f32 = 1e-6;

/// How many times larger than its smallest object a scene is at least whose middle is that of most triangles.
const WIDE: f64 = 1000.0;

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
    let center = center(&objects, 0.5 * (low + high), (high - low).length());
    let size = (high - low).length().max(1e-30) as f32;
    let triangles = || objects.iter().flat_map(|object| triangles_of(prepared, object, center));
    let tree = tree(triangles().map(|triangle| bounds(&triangle)).collect());
    // What is made anew costs less than what is kept: the triangles come once for their boxes and once into their places.
    let nodes = nodes(&tree);
    let order = { tree }.primitive_indices;
    let mut place = vec![0_u32; order.len()];
    order.iter().enumerate().for_each(|(to, from)| place[*from as usize] = to as u32);
    drop(order);
    let mut in_order = vec![[[0.0; 3]; 3]; place.len()];
    for (triangle, place) in triangles().zip(place) {
        in_order[place as usize] = triangle.map(|v| v.to_array());
    }
    Ok(Bvh { center: center.to_array(), triangles: in_order, nodes, size })
}

/// What triangles are relative to: the middle of all, but where something is far away, or far larger than the rest, the
/// middle of most triangles, so that small things among them keep their digits.
fn center(objects: &[&PreparedObject], middle: DVec3, size: f64) -> DVec3 {
    let bounds = |object: &PreparedObject| object.bounds.map(DVec3::from_array);
    let extent = |object: &&PreparedObject| {
        let [low, high] = bounds(object);
        (high - low).length()
    };
    let smallest = objects.iter().map(extent).filter(|extent| *extent > 0.0).fold(f64::INFINITY, f64::min);
    if size <= WIDE * smallest {
        return middle;
    }
    let weight = |object: &PreparedObject| object.clusters.len() as u64;
    let all: u64 = objects.iter().map(|object| weight(object)).sum();
    let along = |axis: usize| {
        let place = |object: &&PreparedObject| {
            let [low, high] = bounds(object);
            (object.anchor[axis] + 0.5 * (low + high)[axis], weight(object))
        };
        let mut places: Vec<(f64, u64)> = objects.iter().map(place).collect();
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut sum = 0;
        let half = places.iter().find(|(_, weight)| {
            sum += weight;
            2 * sum >= all
        });
        half.map_or(middle[axis], |(place, _)| *place)
    };
    DVec3::from_array([0, 1, 2].map(along))
}

/// The tree over boxes, which are gone once it stands.
fn tree(boxes: Vec<Aabb>) -> Bvh2 {
    let indices = (0..boxes.len() as u32).collect();
    PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Medium,
        &boxes,
        indices,
        SortPrecision::U64,
        SEARCH_DEPTH,
    )
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

/// A corner of each triangle of an object, and the two edges from it.
fn triangles_of<'a>(
    prepared: &'a Prepared,
    object: &PreparedObject,
    center: DVec3,
) -> impl Iterator<Item = [Vec3A; 3]> + use<'a> {
    let geometry = &prepared.geometry;
    let shift = (DVec3::from_array(object.anchor) - center).as_vec3();
    geometry.clusters[object.clusters.clone()].iter().flat_map(move |cluster| {
        let position = move |vertex: u8| {
            let at = cluster.first_vertex as usize + vertex as usize;
            Vec3A::from(Vec3::from_array(core::array::from_fn(|axis| geometry.position[axis][at])) + shift)
        };
        let first = cluster.first_triangle as usize;
        geometry.triangles[first..first + cluster.triangles as usize].iter().map(move |triangle| {
            let [a, b, c] = triangle.map(position);
            [a, b - a, c - a]
        })
    })
}

fn bounds([corner, first, second]: &[Vec3A; 3]) -> Aabb {
    let (a, b) = (*corner + *first, *corner + *second);
    let (low, high) = (corner.min(a).min(b), corner.max(a).max(b));
    let margin = Vec3A::splat(MARGIN * low.abs().max(high.abs()).max_element());
    Aabb::new(low - margin, high + margin)
}
