//! Whether a mesh is a closed surface seen from outside.

use std::collections::HashMap;

use glanz_scene::Mesh;

use super::placed::Placed;

/// Above this many triangles the answer is not sought: it would cost more than it saves.
const MOST_TRIANGLES: usize = 4_000_000;

/// Whether every edge is shared by two facets that run along it in opposite ways, with outward
/// orientation. Back faces of such a mesh are never seen from outside its box.
pub(crate) fn is_closed(mesh: &Mesh, placed: &Placed) -> bool {
    let triangles = mesh.triangle_count();
    if !(4..=MOST_TRIANGLES).contains(&triangles) || !has_positive_volume(mesh, placed) {
        return false;
    }
    let points = weld(mesh);
    let mut edges = Vec::with_capacity(triangles * 3);
    for t in mesh.triangles() {
        let t = t.map(|v| points[v as usize]);
        if t[0] == t[1] || t[1] == t[2] || t[2] == t[0] {
            continue;
        }
        edges.extend((0..3).map(|i| edge_key(t[i], t[(i + 1) % 3])));
    }
    edges.sort_unstable();
    // Sorted by the undirected edge, then by direction: pairs of both directions, and nothing else.
    edges.chunks(2).all(|pair| pair.len() == 2 && pair[0] >> 1 == pair[1] >> 1 && pair[0] != pair[1])
        && edges.windows(3).all(|w| w[0] >> 1 != w[2] >> 1)
}

/// The edge's two points in order, then one bit for its direction.
fn edge_key(from: u32, to: u32) -> u64 {
    let (low, high) = (u64::from(from.min(to)), u64::from(from.max(to)));
    (low << 32 | high) << 1 | u64::from(from > to)
}

/// For each vertex the number of its position; vertices at the same position share it.
fn weld(mesh: &Mesh) -> Vec<u32> {
    let mut numbers = HashMap::with_capacity(mesh.positions.len());
    let mut points = Vec::with_capacity(mesh.positions.len());
    for (i, p) in mesh.positions.iter().enumerate() {
        // Adding zero turns −0 into 0.
        let key = (*p + glam::Vec3::ZERO).to_array().map(f32::to_bits);
        points.push(*numbers.entry(key).or_insert(i as u32));
    }
    points
}

/// Volumes below this fraction of what their parts sum up to are none: a sheet with two sides encloses what rounding
/// leaves, of a sign that changes as it is turned.
const ROUNDING: f64 = 1e-9;

/// Whether the volume that the facets enclose, counted with their orientation, is positive.
fn has_positive_volume(mesh: &Mesh, placed: &Placed) -> bool {
    let (mut volume, mut all) = (0.0, 0.0);
    for t in mesh.triangles() {
        let [a, b, c] = t.map(|v| placed.position(mesh.positions[v as usize]));
        volume += a.dot(b.cross(c));
        all += a.length() * b.length() * c.length();
    }
    if placed.mirrored { -volume > ROUNDING * all } else { volume > ROUNDING * all }
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, DVec3, Vec3};

    use super::*;

    #[test]
    fn a_sheet_with_two_sides_is_not_closed_however_it_is_turned() {
        let corner = |[x, y]: [f32; 2]| Vec3::new(x, y, 0.0);
        // Split along one diagonal in front and along the other behind, so that each edge has two facets.
        let mesh = Mesh {
            positions: [[-0.7, -0.3], [0.9, -0.4], [0.8, 0.6], [-0.5, 0.7]].map(corner).to_vec(),
            corners: vec![0, 1, 2, 0, 2, 3, 3, 1, 0, 3, 2, 1],
            ..Mesh::default()
        };
        for i in 0..100 {
            let turned = DMat4::from_axis_angle(DVec3::new(0.36, 0.48, 0.8), 0.1 * f64::from(i));
            assert!(!is_closed(&mesh, &Placed::new(&mesh, turned)), "{i}");
        }
    }
}
