//! Surfaces of revolution around Y.

use glam::{DVec3, Vec2};

use super::turn::sin_cos_turn;
use crate::Mesh;

/// A sphere; its first and last row of faces are triangles, all others quads.
pub(super) fn sphere(radius: f64, slices: u32, stacks: u32) -> Mesh {
    let columns = directions(slices);
    let mut maker = Maker::with_vertices(columns.len() * (stacks as usize + 1));
    for row in 0..=stacks {
        let (ring, height) = sin_cos_turn(row, 2 * stacks);
        let pole = row == 0 || row == stacks;
        let v = f64::from(row) / f64::from(stacks);
        // One vertex per triangle at a pole: its u lies in the middle of the triangle's.
        for (i, direction) in columns.iter().take(columns.len() - usize::from(pole)).enumerate() {
            let normal = direction * ring + DVec3::Y * height;
            let u = (i as f64 + if pole { 0.5 } else { 0.0 }) / f64::from(slices);
            maker.vertex(normal * radius, normal, [u, v]);
        }
    }
    let row_start = |row: u32| if row == 0 { 0 } else { slices + (row - 1) * (slices + 1) };
    for i in 0..slices {
        let below = row_start(1) + i;
        maker.face(&[i, below, below + 1]);
    }
    for row in 1..stacks - 1 {
        maker.strip(row_start(row), row_start(row + 1), slices);
    }
    for i in 0..slices {
        let above = row_start(stacks - 1) + i;
        maker.face(&[above, row_start(stacks) + i, above + 1]);
    }
    maker.mesh
}

/// A ring of quads. The rows go from the top over the outside to the bottom and back over the inside.
pub(super) fn torus(major: f64, minor: f64, segments: u32, sides: u32) -> Mesh {
    let columns = directions(segments);
    let mut maker = Maker::with_vertices(columns.len() * (sides as usize + 1));
    for row in 0..=sides {
        let (outwards, upwards) = sin_cos_turn(row, sides);
        let v = f64::from(row) / f64::from(sides);
        for (i, &direction) in columns.iter().enumerate() {
            let normal = direction * outwards + DVec3::Y * upwards;
            maker.vertex(direction * major + normal * minor, normal, [i as f64 / f64::from(segments), v]);
        }
    }
    for row in 0..sides {
        maker.strip(row * (segments + 1), (row + 1) * (segments + 1), segments);
    }
    maker.mesh
}

/// A cylinder of quads, with caps of triangles.
pub(super) fn cylinder(radius: f64, height: f64, slices: u32, capped: bool) -> Mesh {
    let columns = directions(slices);
    let mut maker = Maker::with_vertices(columns.len() * 4 + 2);
    for (v, y) in [(0.0, 0.5 * height), (1.0, -0.5 * height)] {
        for (i, &direction) in columns.iter().enumerate() {
            maker.vertex(direction * radius + DVec3::Y * y, direction, [i as f64 / f64::from(slices), v]);
        }
    }
    maker.strip(0, slices + 1, slices);
    if capped {
        maker.cap(&columns, radius, 0.5 * height, 1.0);
        maker.cap(&columns, radius, -0.5 * height, -1.0);
    }
    maker.mesh
}

/// A cone of triangles, with a cap of triangles. Each triangle has its own vertex at the apex, where
/// the surface has no normal: it takes the one along the middle of the triangle.
pub(super) fn cone(radius: f64, height: f64, slices: u32, capped: bool) -> Mesh {
    let columns = directions(slices);
    let mut maker = Maker::with_vertices(columns.len() * 3 + 1);
    let slant = DVec3::new(height, radius, 0.0).normalize();
    let normal = |direction: DVec3| direction * slant.x + DVec3::Y * slant.y;
    for i in 0..slices {
        let middle = direction(2 * i + 1, 2 * slices);
        let u = (f64::from(i) + 0.5) / f64::from(slices);
        maker.vertex(DVec3::Y * (0.5 * height), normal(middle), [u, 0.0]);
    }
    for (i, &direction) in columns.iter().enumerate() {
        let position = direction * radius - DVec3::Y * (0.5 * height);
        maker.vertex(position, normal(direction), [i as f64 / f64::from(slices), 1.0]);
    }
    for i in 0..slices {
        maker.face(&[i, slices + i, slices + i + 1]);
    }
    if capped {
        maker.cap(&columns, radius, -0.5 * height, -1.0);
    }
    maker.mesh
}

/// The horizontal unit vector after `part / whole` of a turn: from −Z over −X and +Z to +X, which
/// is rightwards for who stands outside and looks at the axis.
fn direction(part: u32, whole: u32) -> DVec3 {
    let (sin, cos) = sin_cos_turn(part, whole);
    DVec3::new(-sin, 0.0, -cos)
}

/// `slices + 1` directions around the axis; the last is the first again.
fn directions(slices: u32) -> Vec<DVec3> {
    (0..=slices).map(|i| direction(i, slices)).collect()
}

/// A mesh in the making.
struct Maker {
    mesh: Mesh,
}

impl Maker {
    fn with_vertices(vertices: usize) -> Self {
        let mesh = Mesh {
            positions: Vec::with_capacity(vertices),
            normals: Vec::with_capacity(vertices),
            uvs: Vec::with_capacity(vertices),
            corners: Vec::with_capacity(4 * vertices),
            face_starts: Vec::with_capacity(vertices + 1),
            ..Mesh::default()
        };
        let mut maker = Self { mesh };
        maker.mesh.face_starts.push(0);
        maker
    }

    fn vertex(&mut self, position: DVec3, normal: DVec3, uv: [f64; 2]) -> u32 {
        let index = self.mesh.positions.len() as u32;
        self.mesh.positions.push(position.as_vec3());
        self.mesh.normals.push(normal.as_vec3());
        self.mesh.uvs.push(Vec2::new(uv[0] as f32, uv[1] as f32));
        index
    }

    fn face(&mut self, corners: &[u32]) {
        self.mesh.corners.extend_from_slice(corners);
        self.mesh.face_starts.push(self.mesh.corners.len() as u32);
    }

    /// Quads between two rows of vertices that begin at `above` and `below`.
    fn strip(&mut self, above: u32, below: u32, quads: u32) {
        for i in 0..quads {
            self.face(&[above + i, below + i, below + i + 1, above + i + 1]);
        }
    }

    /// A disc of triangles around the axis at height `y` that faces up (1) or down (−1).
    fn cap(&mut self, columns: &[DVec3], radius: f64, y: f64, facing: f64) {
        let normal = DVec3::Y * facing;
        let middle = self.vertex(DVec3::Y * y, normal, [0.5, 0.5]);
        let ring = &columns[..columns.len() - 1];
        for direction in ring {
            let uv = [0.5 + 0.5 * direction.x, 0.5 + 0.5 * facing * direction.z];
            self.vertex(direction * radius + DVec3::Y * y, normal, uv);
        }
        let count = ring.len() as u32;
        for i in 0..count {
            let (here, next) = (middle + 1 + i, middle + 1 + (i + 1) % count);
            self.face(&if facing > 0.0 { [middle, here, next] } else { [middle, next, here] });
        }
    }
}
