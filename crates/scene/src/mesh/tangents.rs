//! Vertex tangents for normal maps.

use std::collections::HashMap;

use glam::{DVec3, Vec3, Vec4};

use crate::{
    Mesh, Normals,
    mesh::topology::{Groups, Splitter, for_each_edge},
};

impl Mesh {
    /// The mesh with tangents made from its texture coordinates in the way that normal maps are
    /// usually baked for (M. S. Mikkelsen, *Simulation of wrinkled surfaces revisited*, master's
    /// thesis, University of Copenhagen, 2008, known as MikkTSpace). It must be valid.
    ///
    /// At each vertex the directions of +u of the triangles around it, laid into the plane of the
    /// normal, are weighted by the triangles' angles there. Triangles count together as far as
    /// shared edges lead from one to the next and the texture is not mirrored in between; vertices
    /// alike in position, normal and texture coordinates are one. Unlike Mikkelsen's program, faces
    /// of four corners are two triangles, as they are drawn, and triangles without texture area do
    /// not join their neighbours.
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
        let fans = fans(&mesh);
        let tangents = corner_tangents(&mesh, &fans);
        let mut splitter = Splitter::new(mesh.positions.len());
        let mut corners = mesh.corners.clone();
        let mut made: Vec<Option<Vec4>> = vec![None; mesh.positions.len()];
        for (corner, tangent) in corners.iter_mut().zip(tangents) {
            // A corner without a tangent of its own takes what its vertex has.
            if let Some(tangent) = tangent {
                *corner = splitter.user(*corner, tangent.to_array().map(f32::to_bits));
                made.resize(splitter.sources.len(), None);
                made[*corner as usize] = Some(tangent);
            }
        }
        let mut split = mesh.pick_vertices(&splitter.sources);
        let of_vertex = made.iter().zip(&split.normals);
        split.tangents =
            of_vertex.map(|(made, &normal)| made.unwrap_or_else(|| any_tangent(normal))).collect();
        split.corners = corners;
        split.face_starts = mesh.face_starts;
        split
    }
}

/// The triangles of all faces, as triangles of corners.
fn fans(mesh: &Mesh) -> Vec<[u32; 3]> {
    let mut triangles = Vec::with_capacity(mesh.triangle_count());
    let mut start = 0;
    for face in 0..mesh.face_count() {
        triangles.extend(mesh.triangles_of(face).map(|triangle| triangle.map(|place| start + place)));
        start += mesh.face(face).len() as u32;
    }
    triangles
}

/// One tangent for each corner: that of the first triangle of its face's fan that has one there.
fn corner_tangents(mesh: &Mesh, fans: &[[u32; 3]]) -> Vec<Option<Vec4>> {
    let slopes: Vec<Slope> = fans.iter().map(|fan| Slope::of(mesh, *fan)).collect();
    let groups = groups(mesh, fans, &slopes);
    let mut sums = vec![DVec3::ZERO; groups.len()];
    for (number, (fan, slope)) in fans.iter().zip(&slopes).enumerate() {
        for i in 0..3 {
            sums[groups[3 * number + i] as usize] += weighted(mesh, *fan, i, slope.direction);
        }
    }
    let mut tangents = vec![None; mesh.corners.len()];
    for (number, (fan, slope)) in fans.iter().zip(&slopes).enumerate() {
        for (i, &corner) in fan.iter().enumerate() {
            let sum = sums[groups[3 * number + i] as usize];
            let slot: &mut Option<Vec4> = &mut tangents[corner as usize];
            // Weights are angles: a sum this short has cancelled out but for rounding.
            if slot.is_none() && slope.direction != DVec3::ZERO && sum.length_squared() > 1e-24 {
                *slot = Some(sum.normalize().as_vec3().extend(slope.bitangent_sign));
            }
        }
    }
    tangents
}

/// The direction of +u on a triangle, of length 1; zero where there is none.
struct Slope {
    direction: DVec3,
    bitangent_sign: f32,
}

impl Slope {
    fn of(mesh: &Mesh, fan: [u32; 3]) -> Self {
        let vertices = fan.map(|corner| mesh.corners[corner as usize] as usize);
        let [a, b, c] = vertices.map(|v| mesh.positions[v].as_dvec3());
        let [s, t, u] = vertices.map(|v| mesh.uvs[v].as_dvec2());
        let (ab, ac) = (t - s, u - s);
        let area = ab.perp_dot(ac);
        let flat = (b - a).cross(c - a) == DVec3::ZERO || area == 0.0;
        let along = ((b - a) * ac.y - (c - a) * ab.y) * area.signum();
        let direction = if flat { DVec3::ZERO } else { along.try_normalize().unwrap_or(DVec3::ZERO) };
        // v runs downwards: a triangle that is not mirrored has a negative area in the texture.
        Self { direction, bitangent_sign: if area > 0.0 { -1.0 } else { 1.0 } }
    }
}

/// For each corner of each triangle (three per triangle) the first of those that it shares its
/// tangent with.
fn groups(mesh: &Mesh, fans: &[[u32; 3]], slopes: &[Slope]) -> Vec<u32> {
    let alike = alike_vertices(mesh);
    let vertex = |corner: u32| alike[mesh.corners[corner as usize] as usize];
    let sides: Vec<[u32; 2]> =
        fans.iter().map(|fan| fan.map(vertex)).flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    let mut groups = Groups::new(sides.len());
    let end = |side: usize| (side / 3 * 3 + (side + 1) % 3) as u32;
    for_each_edge(&sides, mesh.positions.len(), |[a, b], members| {
        if a == b {
            return;
        }
        // Where more than two triangles meet, each is compared with its next in file order.
        for pair in members.windows(2) {
            let [one, two] = [pair[0] as usize, pair[1] as usize];
            let [slope, other] = [&slopes[one / 3], &slopes[two / 3]];
            let opposite = sides[one][0] == sides[two][1];
            let sloped = slope.direction != DVec3::ZERO && other.direction != DVec3::ZERO;
            if opposite && sloped && slope.bitangent_sign == other.bitangent_sign {
                groups.join(one as u32, end(two));
                groups.join(end(one), two as u32);
            }
        }
    });
    groups.into_roots()
}

/// For each vertex the first that has the same position, normal and texture coordinates.
fn alike_vertices(mesh: &Mesh) -> Vec<u32> {
    let mut known: HashMap<[u32; 8], u32> = HashMap::with_capacity(mesh.positions.len());
    let vertices = mesh.positions.iter().zip(&mesh.normals).zip(&mesh.uvs).enumerate();
    vertices
        .map(|(number, ((p, n), t))| {
            // Adding zero turns -0 into 0.
            let key = [p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y].map(|value| (value + 0.0).to_bits());
            *known.entry(key).or_insert(number as u32)
        })
        .collect()
}

/// What a triangle adds to the tangent at its corner `i`: its direction in the plane of the normal
/// times its angle in that plane.
fn weighted(mesh: &Mesh, fan: [u32; 3], i: usize, direction: DVec3) -> DVec3 {
    let vertex = |i: usize| mesh.corners[fan[i % 3] as usize] as usize;
    let at = |i: usize| mesh.positions[vertex(i)].as_dvec3();
    let normal = mesh.normals[vertex(i)].as_dvec3();
    let Some(normal) = normal.try_normalize() else { return DVec3::ZERO };
    let flattened = |v: DVec3| v - normal * normal.dot(v);
    let (next, last) = (flattened(at(i + 1) - at(i)), flattened(at(i + 2) - at(i)));
    let angle = libm::atan2(next.cross(last).length(), next.dot(last));
    let along = flattened(direction);
    // What is left of a unit vector along an f32 normal is rounding.
    if along.length_squared() < 1e-12 || !angle.is_finite() {
        return DVec3::ZERO;
    }
    along.normalize() * angle
}

/// Some unit vector perpendicular to a normal, which need not be of unit length.
fn any_tangent(normal: Vec3) -> Vec4 {
    normal.try_normalize().unwrap_or(Vec3::Z).any_orthonormal_vector().extend(1.0)
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

    /// Runs another implementation of the same algorithm: triangles in, one tangent per corner out.
    struct Peer<'a> {
        mesh: &'a Mesh,
        triangles: Vec<[u32; 3]>,
        tangents: Vec<[Vec4; 3]>,
    }

    impl bevy_mikktspace::Geometry for Peer<'_> {
        fn num_faces(&self) -> usize {
            self.triangles.len()
        }
        fn num_vertices_of_face(&self, _: usize) -> usize {
            3
        }
        fn position(&self, face: usize, vert: usize) -> [f32; 3] {
            self.mesh.positions[self.triangles[face][vert] as usize].to_array()
        }
        fn normal(&self, face: usize, vert: usize) -> [f32; 3] {
            self.mesh.normals[self.triangles[face][vert] as usize].to_array()
        }
        fn tex_coord(&self, face: usize, vert: usize) -> [f32; 2] {
            self.mesh.uvs[self.triangles[face][vert] as usize].to_array()
        }
        fn set_tangent(&mut self, space: Option<bevy_mikktspace::TangentSpace>, face: usize, vert: usize) {
            let [x, y, z, w] = space.expect("no triangle is degenerate").tangent_encoded();
            // Its texture coordinates run upwards.
            self.tangents[face][vert] = Vec4::new(x, y, z, -w);
        }
    }

    #[test]
    fn tangents_agree_with_those_of_another_implementation() {
        for name in ["kite", "cube", "sphere", "torus", "cylinder", "cone", "teapot"] {
            let made = with_tangents(name);
            let triangles: Vec<[u32; 3]> = made.triangles().collect();
            let tangents = vec![[Vec4::ZERO; 3]; triangles.len()];
            let mut peer = Peer { mesh: &made, triangles, tangents };
            bevy_mikktspace::generate_tangents(&mut peer).expect("it has no errors");
            for (triangle, expected) in peer.triangles.iter().zip(&peer.tangents) {
                for (&vertex, expected) in triangle.iter().zip(expected) {
                    let error = (made.tangents[vertex as usize] - *expected).length();
                    // It calculates in f32, where a small angle's cosine leaves three digits of it.
                    assert!(error < 2e-3, "{name}: {} {expected}", made.tangents[vertex as usize]);
                }
            }
        }
    }

    #[test]
    fn a_fan_of_many_triangles_around_one_point_takes_no_time_and_no_stack() {
        let cone = Builtin::Cone { radius: 1.0, height: 1.0, slices: 100_000, capped: true };
        let start = std::time::Instant::now();
        check(&cone.mesh().expect("the parameters are in range").with_tangents());
        // Linear: a fraction of a second. Quadratic: minutes.
        assert!(start.elapsed().as_secs() < 10);
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
