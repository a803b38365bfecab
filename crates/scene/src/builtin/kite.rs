//! The kite: two triangles folded along their common edge.

use glam::{Vec2, Vec3, Vec4};

use crate::{Mesh, Normals};

/// The four points: A above, B below, C on the left, D on the right. The edge AB lies towards the
/// viewer at +Z, the wings go back by half of their width.
const POINTS: [Vec3; 4] = [
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(0.0, -1.0, 0.0),
    Vec3::new(-0.6, 0.3, -0.3),
    Vec3::new(0.6, 0.3, -0.3),
];

/// The colours of A, B, C and D: red, green, blue, yellow.
const COLORS: [Vec4; 4] = [
    Vec4::new(1.0, 0.0, 0.0, 1.0),
    Vec4::new(0.0, 1.0, 0.0, 1.0),
    Vec4::new(0.0, 0.0, 1.0, 1.0),
    Vec4::new(1.0, 1.0, 0.0, 1.0),
];

/// The triangles ACB and ABD, each with its own normal. The mean of both normals along AB, which the
/// course calls smoothing, is what [`Normals::Smooth`] makes of it.
pub(super) fn kite() -> Mesh {
    let shared = Mesh {
        positions: POINTS.to_vec(),
        uvs: POINTS.iter().map(|p| Vec2::new((p.x + 0.6) / 1.2, (1.0 - p.y) / 2.0)).collect(),
        colors: COLORS.to_vec(),
        corners: vec![0, 2, 1, 0, 1, 3],
        ..Mesh::default()
    };
    shared.with_normals(Normals::Facet)
}
