//! Meshes of squares.

use glam::{DVec3, Vec2};

use crate::Mesh;

/// Side 2, z = 0, facing +Z.
pub(super) fn quad() -> Mesh {
    let mut mesh = Mesh { face_starts: vec![0], ..Mesh::default() };
    square(&mut mesh, DVec3::ZERO, DVec3::X, DVec3::NEG_Y);
    mesh
}

/// Side 2, y = 0, facing +Y.
pub(super) fn plane() -> Mesh {
    let mut mesh = Mesh { face_starts: vec![0], ..Mesh::default() };
    square(&mut mesh, DVec3::ZERO, DVec3::X, DVec3::Z);
    mesh
}

/// Six squares of side `size` with their own vertices.
pub(super) fn cube(size: f64) -> Mesh {
    let sides = [
        (DVec3::X, DVec3::NEG_Y),
        (DVec3::NEG_Z, DVec3::NEG_Y),
        (DVec3::NEG_X, DVec3::NEG_Y),
        (DVec3::Z, DVec3::NEG_Y),
        (DVec3::X, DVec3::Z),
        (DVec3::X, DVec3::NEG_Z),
    ];
    let mut mesh = Mesh { face_starts: vec![0], ..Mesh::default() };
    for (right, down) in sides {
        let half = size * 0.5;
        square(&mut mesh, down.cross(right) * half, right * half, down * half);
    }
    mesh
}

/// Adds a square face around `center`; `right` and `down` are half of its sides.
fn square(mesh: &mut Mesh, center: DVec3, right: DVec3, down: DVec3) {
    let normal = down.cross(right).normalize().as_vec3();
    for [x, y] in [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]] {
        mesh.corners.push(mesh.positions.len() as u32);
        mesh.positions.push((center + x * right + y * down).as_vec3());
        mesh.normals.push(normal);
        mesh.uvs.push(Vec2::new(0.5 + 0.5 * x as f32, 0.5 + 0.5 * y as f32));
    }
    mesh.face_starts.push(mesh.corners.len() as u32);
}
