//! Loop subdivision.

use core::f64::consts::{PI, TAU};

use glam::{DVec3, Vec2, Vec4};
use thiserror::Error;

use crate::{
    Mesh, Normals,
    builtin::MAX_TRIANGLES,
    mesh::topology::{Edges, Welded},
};

/// Why a mesh cannot be subdivided.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SubdivideError {
    /// There would be too many triangles.
    #[error(
        "at most {MAX_TRIANGLES} triangles are made, but {levels} subdivisions of {triangles} triangles \
         are asked for (each makes four times as many)"
    )]
    TooLarge {
        /// How many triangles there are.
        triangles: usize,
        /// How many subdivisions are asked for.
        levels: u32,
    },
}

impl Mesh {
    /// The mesh with each triangle cut in four, `levels` times, and its points moved towards a
    /// smooth surface (C. Loop, *Smooth subdivision surfaces based on triangles*, master's thesis,
    /// University of Utah, 1987). It must be valid.
    ///
    /// Faces are cut into triangles first; those without three different points are dropped.
    /// Vertices at exactly the same place move together, so that seams do not open. Borders become
    /// cubic B-splines that depend on nothing but the border, except that corners (border points
    /// of a single face) stay where they are: a square stays a square. Edges of three and more
    /// faces are treated like borders. Texture coordinates and colours are interpolated linearly.
    /// A mesh that had normals gets smooth ones; tangents are lost.
    pub fn subdivided(&self, levels: u32) -> Result<Self, SubdivideError> {
        if levels == 0 {
            return Ok(self.clone());
        }
        let triangles = self.triangle_count();
        let after = 4_u64.checked_pow(levels).and_then(|factor| factor.checked_mul(triangles as u64));
        if triangles > 0 && after.is_none_or(|after| after > MAX_TRIANGLES) {
            return Err(SubdivideError::TooLarge { triangles, levels });
        }
        let mut net = Net::of(self);
        // Without triangles there is nothing to do, however often.
        if !net.triangles.is_empty() {
            (0..levels).for_each(|_| net.subdivide());
        }
        let mesh = net.into_mesh(self.name.clone());
        Ok(if self.normals.is_empty() { mesh } else { mesh.with_normals(Normals::Smooth { crease: PI }) })
    }
}

/// Points that move, and vertices at them with attributes of their own.
struct Net {
    points: Vec<DVec3>,
    /// Whether each point stays where it is.
    fixed: Vec<bool>,
    point_of: Vec<u32>,
    uvs: Vec<Vec2>,
    uvs2: Vec<Vec2>,
    colors: Vec<Vec4>,
    /// Triangles of vertices.
    triangles: Vec<[u32; 3]>,
}

/// What the neighbours of a point contribute to its new place.
#[derive(Clone, Copy, Default)]
struct Around {
    neighbors: u32,
    sum: DVec3,
    border_neighbors: u32,
    border_sum: DVec3,
}

impl Net {
    fn of(mesh: &Mesh) -> Self {
        let Welded { point_of, first } = Welded::of(&mesh.positions);
        let mut faces_at = vec![0_u32; first.len()];
        for &corner in &mesh.corners {
            let count = &mut faces_at[point_of[corner as usize] as usize];
            *count = count.saturating_add(1);
        }
        let distinct = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|vertex| point_of[vertex as usize]);
            a != b && b != c && c != a
        };
        Self {
            points: first.iter().map(|&v| mesh.positions[v as usize].as_dvec3()).collect(),
            fixed: faces_at.iter().map(|&count| count == 1).collect(),
            triangles: mesh.triangles().filter(distinct).collect(),
            uvs: mesh.uvs.clone(),
            uvs2: mesh.uvs2.clone(),
            colors: mesh.colors.clone(),
            point_of,
        }
    }

    fn subdivide(&mut self) {
        let point_triangles: Vec<[u32; 3]> =
            self.triangles.iter().map(|t| t.map(|vertex| self.point_of[vertex as usize])).collect();
        let edges = Edges::of(&point_triangles, self.points.len());
        let first_point = self.points.len() as u32;
        self.move_points(&point_triangles, &edges);
        let seams = Edges::of(&self.triangles, self.point_of.len());
        let first_vertex = self.point_of.len() as u32;
        self.add_vertices(&edges, &seams, first_point);
        self.triangles = seams.split(&self.triangles, first_vertex);
    }

    /// Moves the old points and adds one for each edge.
    fn move_points(&mut self, triangles: &[[u32; 3]], edges: &Edges) {
        // The number of triangles at each edge, and the sum of the points opposite to it.
        let mut wings = vec![(0_u32, DVec3::ZERO); edges.ends.len()];
        for (triangle, of_corner) in triangles.iter().zip(&edges.of_corner) {
            for (i, &edge) in of_corner.iter().enumerate() {
                let wing = &mut wings[edge as usize];
                wing.0 += 1;
                wing.1 += self.points[triangle[(i + 2) % 3] as usize];
            }
        }
        let mut around = vec![Around::default(); self.points.len()];
        let mut middles = Vec::with_capacity(edges.ends.len());
        for (&[a, b], &(count, opposite)) in edges.ends.iter().zip(&wings) {
            let [p, q] = [a, b].map(|end| self.points[end as usize]);
            for (end, other) in [(a, q), (b, p)] {
                let around = &mut around[end as usize];
                around.neighbors += 1;
                around.sum += other;
                if count != 2 {
                    around.border_neighbors += 1;
                    around.border_sum += other;
                }
            }
            middles.push(if count == 2 { (p + q) * 0.375 + opposite * 0.125 } else { (p + q) * 0.5 });
        }
        for ((point, around), fixed) in self.points.iter_mut().zip(&around).zip(&self.fixed) {
            if !fixed {
                *point = around.moved(*point);
            }
        }
        self.fixed.resize(self.points.len() + middles.len(), false);
        self.points.extend(middles);
    }

    /// Adds a vertex in the middle of each pair of vertices that an edge joins, at the point of the edge.
    fn add_vertices(&mut self, edges: &Edges, seams: &Edges, first_point: u32) {
        let first_vertex = self.point_of.len();
        self.point_of.resize(first_vertex + seams.ends.len(), 0);
        for (of_seams, of_edges) in seams.of_corner.iter().zip(&edges.of_corner) {
            for (&seam, &edge) in of_seams.iter().zip(of_edges) {
                self.point_of[first_vertex + seam as usize] = first_point + edge;
            }
        }
        for &[a, b] in &seams.ends {
            for uvs in [&mut self.uvs, &mut self.uvs2].into_iter().filter(|uvs| !uvs.is_empty()) {
                uvs.push((uvs[a as usize] + uvs[b as usize]) * 0.5);
            }
            if !self.colors.is_empty() {
                self.colors.push((self.colors[a as usize] + self.colors[b as usize]) * 0.5);
            }
        }
    }

    fn into_mesh(self, name: String) -> Mesh {
        Mesh {
            name,
            positions: self.point_of.iter().map(|&p| self.points[p as usize].as_vec3()).collect(),
            uvs: self.uvs,
            uvs2: self.uvs2,
            colors: self.colors,
            corners: self.triangles.into_flattened(),
            ..Mesh::default()
        }
    }
}

impl Around {
    /// Where the point goes.
    fn moved(&self, point: DVec3) -> DVec3 {
        match self.border_neighbors {
            0 if self.neighbors == 0 => point,
            0 => {
                let n = f64::from(self.neighbors);
                let weight = neighbor_weight(n);
                point * (1.0 - n * weight) + self.sum * weight
            }
            2 => point * 0.75 + self.border_sum * 0.125,
            // A border that ends or crosses itself here holds the point.
            _ => point,
        }
    }
}

/// Loop's weight for each of `n` neighbours.
fn neighbor_weight(n: f64) -> f64 {
    let root = 0.375 + 0.25 * libm::cos(TAU / n);
    (0.625 - root * root) / n
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use glam::Vec3;

    use super::*;
    use crate::Builtin;

    fn make(builtin: Builtin) -> Mesh {
        builtin.mesh().expect("the parameters are in range")
    }

    fn subdivided(mesh: &Mesh, levels: u32) -> Mesh {
        let fine = mesh.subdivided(levels).expect("it is small");
        assert_eq!(fine.validate(), Ok(()));
        fine
    }

    fn tetrahedron() -> Mesh {
        let positions = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        Mesh {
            positions: positions.map(Vec3::from_array).to_vec(),
            corners: vec![0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2],
            ..Mesh::default()
        }
    }

    /// Whether each edge, after welding, is run along once in each direction.
    fn is_closed(mesh: &Mesh) -> bool {
        let point_of = Welded::of(&mesh.positions).point_of;
        let sides: Vec<[u32; 2]> = mesh
            .triangles()
            .map(|t| t.map(|v| point_of[v as usize]))
            .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
            .collect();
        let known: HashSet<[u32; 2]> = sides.iter().copied().collect();
        known.len() == sides.len() && sides.iter().all(|&[a, b]| known.contains(&[b, a]))
    }

    #[test]
    fn a_tetrahedron_moves_as_calculated_by_hand() {
        let fine = subdivided(&tetrahedron(), 1);
        assert_eq!((fine.positions.len(), fine.triangle_count()), (10, 16));
        // Three neighbours of weight 3/16 whose sum is -p: 7/16 p - 3/16 p.
        assert!(fine.positions[0].distance(Vec3::splat(0.25)) < 1e-6, "{}", fine.positions[0]);
        // Edge 0-1: 3/8 of (2, 0, 0) and 1/8 of (-2, 0, 0).
        assert!(fine.positions[4].distance(Vec3::X * 0.5) < 1e-6, "{}", fine.positions[4]);
    }

    #[test]
    fn each_level_makes_four_triangles_of_one() {
        let cube = make(Builtin::Cube { size: 2.0 });
        for levels in 0..5 {
            assert_eq!(subdivided(&cube, levels).triangle_count(), 12 << (2 * levels));
        }
        assert_eq!(subdivided(&cube, 0), cube);
    }

    #[test]
    fn a_cube_with_split_edges_becomes_a_smooth_closed_surface() {
        let cube = make(Builtin::Cube { size: 2.0 });
        let steepest = |levels| {
            let fine = subdivided(&cube, levels);
            assert!(is_closed(&fine));
            let cos = |(face, corners): (usize, &[u32])| {
                fine.face_normal(face).dot(fine.normals[corners[0] as usize].as_dvec3())
            };
            fine.faces().enumerate().map(cos).fold(1.0, f64::min)
        };
        // Facets lean less and less against the normals: about half as much each time.
        let angles = [2, 3, 4, 5].map(|levels| libm::acos(steepest(levels)));
        assert!(angles.windows(2).all(|w| w[1] < 0.75 * w[0]), "{angles:?}");
    }

    #[test]
    fn an_icosphere_stays_round_and_closed() {
        let fine = subdivided(&make(Builtin::Icosphere { radius: 1.0, subdivisions: 2 }), 2);
        assert!(is_closed(&fine));
        for (position, normal) in fine.positions.iter().zip(&fine.normals) {
            // 42 points and more: the surface keeps within 3 % of a sphere, its normals within 2°.
            assert!((0.95..1.0).contains(&position.length()), "{position}");
            assert!(position.normalize().dot(*normal) > 0.9994, "{position} {normal}");
        }
    }

    #[test]
    fn a_sphere_does_not_crack_along_its_texture_seam() {
        let sphere = make(Builtin::Sphere { radius: 1.0, slices: 8, stacks: 5 });
        let fine = subdivided(&sphere, 2);
        assert!(is_closed(&fine));
        assert_eq!(fine.uvs.len(), fine.positions.len());
        let widest = fine.triangles().map(|[a, b, c]| {
            let [a, b, c] = [a, b, c].map(|v| fine.uvs[v as usize].x);
            a.max(b).max(c) - a.min(b).min(c)
        });
        // No triangle runs back over the whole texture: a slice is 1/8, cut twice.
        assert!(widest.fold(0.0, f32::max) <= 1.0 / 32.0 + 1e-6);
    }

    #[test]
    fn a_flat_square_stays_flat_and_square() {
        let fine = subdivided(&make(Builtin::Plane), 3);
        assert!(fine.positions.iter().all(|p| p.y == 0.0) && fine.normals.iter().all(|n| *n == Vec3::Y));
        let area: f32 = fine
            .triangles()
            .map(|[a, b, c]| {
                let [a, b, c] = [a, b, c].map(|v| fine.positions[v as usize]);
                (b - a).cross(c - a).length() / 2.0
            })
            .sum();
        assert!((area - 4.0).abs() < 1e-5, "{area}");
    }

    #[test]
    fn a_border_point_moves_by_its_border_neighbours_alone_and_a_corner_stays() {
        let kite = make(Builtin::Kite);
        let [a, c, _, _, _, d] = [0, 1, 2, 3, 4, 5].map(|i| kite.positions[kite.corners[i] as usize]);
        let fine = subdivided(&kite, 1);
        let has = |point: Vec3| fine.positions.iter().any(|p| p.distance(point) < 1e-6);
        assert!(has(a * 0.75 + (c + d) * 0.125) && !has(a));
        assert!(has(c) && has(d));
    }

    #[test]
    fn colors_are_interpolated() {
        let kite = make(Builtin::Kite);
        let fine = subdivided(&kite, 1);
        let mean = (kite.colors[0] + kite.colors[1]) / 2.0;
        assert!(fine.colors.contains(&mean) && fine.colors.len() == fine.positions.len());
    }

    #[test]
    fn too_many_triangles_are_refused() {
        let cube = make(Builtin::Cube { size: 2.0 });
        for levels in [13, 31, 32, u32::MAX] {
            assert_eq!(cube.subdivided(levels), Err(SubdivideError::TooLarge { triangles: 12, levels }));
        }
    }

    #[test]
    fn a_mesh_without_faces_comes_back_at_once() {
        assert_eq!(Mesh::default().subdivided(u32::MAX), Ok(Mesh::default()));
    }

    #[test]
    fn edges_of_three_faces_and_faces_without_area_do_no_harm() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::Y, Vec3::X, Vec3::NEG_X, Vec3::Z, Vec3::X],
            corners: vec![0, 1, 2, 0, 1, 3, 0, 1, 4, 2, 5, 0, 1, 1, 1],
            ..Mesh::default()
        };
        let fine = subdivided(&mesh, 2);
        assert_eq!(fine.triangle_count(), 3 * 16);
        assert!(fine.positions.iter().any(|p| *p == Vec3::Y * 0.5), "the shared edge stays straight");
    }
}
