//! Vertex tangents for normal maps.

use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};
use glam::{Vec3, Vec4};

use crate::{Mesh, Normals, topology::Splitter};

impl Mesh {
    /// The mesh with tangents made from its texture coordinates by the algorithm that normal maps
    /// are usually baked for (M. S. Mikkelsen, *Simulation of wrinkled surfaces revisited*, master's
    /// thesis, University of Copenhagen, 2008, known as MikkTSpace). It must be valid.
    ///
    /// As in glTF, the bitangent is `w · normal × tangent` and points upwards in the texture. A mesh
    /// without normals gets them after [`Normals::Given`]; one without texture coordinates comes
    /// back without tangents. Vertices that need several tangents are split. Where the texture
    /// coordinates have no direction, the tangent is any that is perpendicular to the normal.
    pub fn with_tangents(self) -> Self {
        let mut mesh = self.with_normals(Normals::Given);
        mesh.tangents = Vec::new();
        if mesh.uvs.is_empty() {
            return mesh;
        }
        let tangents = corner_tangents(&mesh);
        let mut splitter = Splitter::new(mesh.positions.len());
        let corners = mesh.corners.iter().zip(&tangents);
        let corners = corners.map(|(&v, t)| splitter.user(v, t.to_array().map(f32::to_bits))).collect();
        let mut split = mesh.pick_vertices(&splitter.sources);
        split.tangents = split.normals.iter().map(|&normal| any_tangent(normal)).collect();
        split.corners = corners;
        for (&corner, tangent) in split.corners.iter().zip(tangents) {
            split.tangents[corner as usize] = tangent;
        }
        split.face_starts = mesh.face_starts;
        split
    }
}

/// One tangent for each corner: that of the first triangle of its face's fan which it belongs to.
fn corner_tangents(mesh: &Mesh) -> Vec<Vec4> {
    let mut triangles = Vec::with_capacity(mesh.triangle_count());
    let mut start = 0;
    for face in mesh.faces() {
        for i in 2..face.len() as u32 {
            triangles.push([start, start + i - 1, start + i]);
        }
        start += face.len() as u32;
    }
    let mut task = Task { mesh, triangles, tangents: vec![None; mesh.corners.len()] };
    // The error type has no values.
    generate_tangents::<_, PortableOps>(&mut task).ok();
    let normals = mesh.corners.iter().map(|&vertex| mesh.normals[vertex as usize]);
    task.tangents.iter().zip(normals).map(|(tangent, n)| tangent.unwrap_or_else(|| any_tangent(n))).collect()
}

/// Some unit vector perpendicular to a normal, which need not be of unit length.
fn any_tangent(normal: Vec3) -> Vec4 {
    normal.try_normalize().unwrap_or(Vec3::Z).any_orthonormal_vector().extend(1.0)
}

/// What the generator reads and writes.
struct Task<'a> {
    mesh: &'a Mesh,
    /// Triangles of corners.
    triangles: Vec<[u32; 3]>,
    tangents: Vec<Option<Vec4>>,
}

impl Task<'_> {
    fn vertex(&self, triangle: usize, corner: usize) -> usize {
        self.mesh.corners[self.triangles[triangle][corner] as usize] as usize
    }
}

impl Geometry<PortableOps> for Task<'_> {
    fn num_faces(&self) -> usize {
        self.triangles.len()
    }
    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }
    fn position(&self, face: usize, vert: usize) -> [f32; 3] {
        self.mesh.positions[self.vertex(face, vert)].to_array()
    }
    fn normal(&self, face: usize, vert: usize) -> [f32; 3] {
        self.mesh.normals[self.vertex(face, vert)].to_array()
    }
    fn tex_coord(&self, face: usize, vert: usize) -> [f32; 2] {
        self.mesh.uvs[self.vertex(face, vert)].to_array()
    }
    fn set_tangent(&mut self, space: Option<TangentSpace>, face: usize, vert: usize) {
        let Some(space) = space else { return };
        let normal = self.mesh.normals[self.vertex(face, vert)];
        let [x, y, z, w] = space.tangent_encoded();
        let tangent = Vec3::new(x, y, z);
        let usable = tangent.is_finite() && (tangent.length_squared() - 1.0).abs() < 1e-3;
        let slot = &mut self.tangents[self.triangles[face][vert] as usize];
        if slot.is_none() {
            // The generator's bitangent runs along +v, which here is downwards.
            *slot = Some(if usable { tangent.extend(-w) } else { any_tangent(normal) });
        }
    }
}

/// Functions that give the same bits on every machine.
struct PortableOps;

impl Ops for PortableOps {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }
    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;
    use proptest::prelude::*;

    use super::*;
    use crate::Builtin;

    fn with_tangents(name: &str) -> Mesh {
        let mesh = Builtin::named(name).expect("it is in the list").mesh().expect("defaults are in range");
        mesh.with_tangents()
    }

    /// That each tangent is a unit vector perpendicular to its normal with a sign.
    fn check(mesh: &Mesh) {
        assert_eq!(mesh.validate(), Ok(()));
        assert_eq!(mesh.tangents.len(), mesh.positions.len());
        for (normal, tangent) in mesh.normals.iter().zip(&mesh.tangents) {
            // f32 rounding of a few operations.
            assert!((tangent.truncate().length() - 1.0).abs() < 1e-5, "{tangent}");
            assert!(tangent.truncate().dot(*normal).abs() < 1e-5, "{tangent} {normal}");
            assert_eq!(tangent.w.abs(), 1.0);
        }
    }

    #[test]
    fn the_quad_has_its_tangent_to_the_right_and_its_bitangent_up() {
        let quad = with_tangents("quad");
        assert_eq!(quad.positions.len(), 4);
        for (normal, tangent) in quad.normals.iter().zip(&quad.tangents) {
            assert!(tangent.truncate().distance(Vec3::X) < 1e-6, "{tangent}");
            assert!((normal.cross(tangent.truncate()) * tangent.w).distance(Vec3::Y) < 1e-6, "{tangent}");
        }
    }

    #[test]
    fn sphere_tangents_run_along_the_parallels_to_the_east() {
        let sphere = with_tangents("sphere");
        check(&sphere);
        for (position, tangent) in sphere.positions.iter().zip(&sphere.tangents) {
            let east = Vec3::Y.cross(*position);
            // Near the poles the triangles turn by a part of a slice against their vertices.
            if east.length() > 0.1 {
                assert!(tangent.truncate().dot(east.normalize()) > 0.99, "{position} {tangent}");
            }
        }
    }

    #[test]
    fn all_built_in_meshes_get_perpendicular_unit_tangents_if_they_have_texture_coordinates() {
        for name in Builtin::NAMES {
            let mesh = with_tangents(name);
            if name == "icosphere" {
                assert!(mesh.tangents.is_empty());
            } else {
                check(&mesh);
            }
        }
    }

    #[test]
    fn mirrored_texture_halves_do_not_share_tangents() {
        let mesh = Mesh {
            positions: vec![Vec3::NEG_X, Vec3::NEG_Y, Vec3::X, Vec3::Y],
            normals: vec![Vec3::Z; 4],
            // The right half shows the left one mirrored.
            uvs: vec![Vec2::new(0.0, 0.5), Vec2::new(1.0, 1.0), Vec2::new(0.0, 0.5), Vec2::new(1.0, 0.0)],
            corners: vec![0, 1, 3, 3, 1, 2],
            ..Mesh::default()
        };
        let split = mesh.with_tangents();
        check(&split);
        assert_eq!(split.positions.len(), 6);
        for (face, expected) in [Vec3::X, Vec3::NEG_X].into_iter().enumerate() {
            for &corner in split.face(face) {
                let tangent = split.tangents[corner as usize];
                assert!(tangent.truncate().distance(expected) < 1e-6, "{face}: {tangent}");
                // Up in the texture is up here on both sides.
                let up = Vec3::Z.cross(tangent.truncate()) * tangent.w;
                assert!(up.distance(Vec3::Y) < 1e-6, "{face}: {tangent}");
            }
        }
    }

    fn place(x: u8, y: u8, z: u8) -> Vec3 {
        Vec3::new(x.into(), y.into(), z.into())
    }

    proptest! {
        #[test]
        fn degenerate_meshes_and_texture_coordinates_do_no_harm(
            places in prop::collection::vec((0..3_u8, 0..3_u8, 0..2_u8, 0..3_u8, 0..3_u8), 1..8),
            corners in prop::collection::vec((0..8_u32, 0..8_u32, 0..8_u32, 0..8_u32), 0..12),
            scale in prop_oneof![Just(1.0_f32), Just(1e-30), Just(1e30)],
        ) {
            let count = places.len() as u32;
            let mesh = Mesh {
                positions: places.iter().map(|p| place(p.0, p.1, p.2) * scale).collect(),
                uvs: places.iter().map(|p| Vec2::new(p.3.into(), p.4.into())).collect(),
                face_starts: (0..=corners.len() as u32).map(|i| 4 * i).collect(),
                corners: corners.iter().flat_map(|&(a, b, c, d)| [a, b, c, d].map(|i| i % count)).collect(),
                ..Mesh::default()
            };
            check(&mesh.with_tangents());
        }
    }
}
