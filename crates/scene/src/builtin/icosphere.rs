//! A sphere from an icosahedron.

use glam::DVec3;

use crate::{Mesh, mesh::topology::Edges};

/// The corners of an icosahedron: all even permutations of (0, ±1, ±φ), φ the golden ratio.
const CORNERS: [[f64; 3]; 12] = {
    const PHI: f64 = 1.618_033_988_749_895;
    [
        [-1.0, PHI, 0.0],
        [1.0, PHI, 0.0],
        [-1.0, -PHI, 0.0],
        [1.0, -PHI, 0.0],
        [0.0, -1.0, PHI],
        [0.0, 1.0, PHI],
        [0.0, -1.0, -PHI],
        [0.0, 1.0, -PHI],
        [PHI, 0.0, -1.0],
        [PHI, 0.0, 1.0],
        [-PHI, 0.0, -1.0],
        [-PHI, 0.0, 1.0],
    ]
};

/// Its faces, counter-clockwise seen from outside.
#[rustfmt::skip]
const FACES: [[u32; 3]; 20] = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
    [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
    [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
];

/// Each subdivision puts a vertex on the middle of each edge and pushes it out to the sphere.
pub(super) fn icosphere(radius: f64, subdivisions: u32) -> Mesh {
    let mut points: Vec<DVec3> = CORNERS.iter().map(|&c| DVec3::from_array(c).normalize()).collect();
    let mut triangles = FACES.to_vec();
    for _ in 0..subdivisions {
        let edges = Edges::of(&triangles, points.len());
        let first = points.len() as u32;
        points.extend(
            edges
                .ends
                .iter()
                .map(|&[a, b]| (points[a as usize] + points[b as usize]).normalize())
                .collect::<Vec<_>>(),
        );
        triangles = edges.split(&triangles, first);
    }
    Mesh {
        positions: points.iter().map(|&p| (p * radius).as_vec3()).collect(),
        normals: points.iter().map(|p| p.as_vec3()).collect(),
        corners: triangles.into_flattened(),
        ..Mesh::default()
    }
}
