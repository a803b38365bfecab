//! The Utah teapot from its Bézier patches.

use glam::{DVec3, Vec2};

use super::teapot_data::{PATCHES, POINTS};
use crate::Mesh;

/// The scale that gives the body the radius 1.
const SCALE: f64 = 0.5;
/// Half of the height of the control points, which the pot has too.
const MIDDLE: f64 = 1.575;

/// `tessellation` × `tessellation` quads per patch, triangles where a side of the patch is a point.
pub(super) fn teapot(tessellation: u32) -> Mesh {
    let vertices = 32 * (tessellation as usize + 1) * (tessellation as usize + 1);
    let mut mesh = Mesh {
        positions: Vec::with_capacity(vertices),
        normals: Vec::with_capacity(vertices),
        uvs: Vec::with_capacity(vertices),
        corners: Vec::with_capacity(4 * vertices),
        face_starts: Vec::with_capacity(vertices),
        ..Mesh::default()
    };
    mesh.face_starts.push(0);
    let weights: Vec<Weights> = (0..=tessellation).map(|i| Weights::at(i, tessellation)).collect();
    for patch in &PATCHES {
        let points = patch.map(|index| place(POINTS[usize::from(index)]));
        add_patch(&mut mesh, &points, &weights);
    }
    mesh
}

/// From the published coordinates (z up) to ours.
fn place([x, y, z]: [f64; 3]) -> DVec3 {
    DVec3::new(x, z - MIDDLE, -y) * SCALE
}

fn add_patch(mesh: &mut Mesh, points: &[DVec3; 16], weights: &[Weights]) {
    let cuts = weights.len() as u32 - 1;
    let first = mesh.positions.len() as u32;
    for (row, down) in weights.iter().enumerate() {
        let curve = Curve::of(points, down);
        // The published patches run leftwards seen from outside.
        for (column, across) in weights.iter().rev().enumerate() {
            mesh.positions.push(sum(&curve.points, &across.value).as_vec3());
            mesh.normals.push(curve.normal(across).as_vec3());
            mesh.uvs.push(Vec2::new(column as f32 / cuts as f32, row as f32 / cuts as f32));
        }
    }
    let pointed = points[..4].iter().all(|&p| p == points[0]);
    for row in 0..cuts {
        for column in 0..cuts {
            let above = first + row * (cuts + 1) + column;
            let below = above + cuts + 1;
            if row == 0 && pointed {
                mesh.corners.extend([above, below, below + 1]);
            } else {
                mesh.corners.extend([above, below, below + 1, above + 1]);
            }
            mesh.face_starts.push(mesh.corners.len() as u32);
        }
    }
}

/// The curve across a patch at some height: its control points, and how they change downwards.
struct Curve {
    points: [DVec3; 4],
    slopes: [DVec3; 4],
}

impl Curve {
    fn of(points: &[DVec3; 16], down: &Weights) -> Self {
        let column = |i: usize| [points[i], points[4 + i], points[8 + i], points[12 + i]];
        Self {
            points: [0, 1, 2, 3].map(|i| sum(&column(i), &down.value)),
            slopes: [0, 1, 2, 3].map(|i| sum(&column(i), &down.slope)),
        }
    }

    /// The unit normal of the patch. Where the curve is a point, its derivative vanishes and grows
    /// with the mixed derivative, which then takes its place.
    fn normal(&self, across: &Weights) -> DVec3 {
        let along_down = sum(&self.slopes, &across.value);
        let cross = sum(&self.points, &across.slope).cross(along_down);
        // Lengths are of the order of 1, and a derivative that vanishes does so but for rounding.
        if cross.length_squared() > 1e-20 {
            return cross.normalize();
        }
        sum(&self.slopes, &across.slope).cross(along_down).normalize()
    }
}

/// Σ weights[i] points[i], from the ends inwards, so that a curve run through backwards gives the
/// same bits: patches meet without gaps.
fn sum(points: &[DVec3; 4], weights: &[f64; 4]) -> DVec3 {
    (points[0] * weights[0] + points[3] * weights[3]) + (points[1] * weights[1] + points[2] * weights[2])
}

/// The cubic Bernstein polynomials and their derivatives at one parameter.
struct Weights {
    value: [f64; 4],
    slope: [f64; 4],
}

impl Weights {
    fn at(part: u32, whole: u32) -> Self {
        let t = f64::from(part) / f64::from(whole);
        let s = f64::from(whole - part) / f64::from(whole);
        Self {
            value: [s * s * s, 3.0 * (s * s * t), 3.0 * (t * t * s), t * t * t],
            slope: [-3.0 * (s * s), 3.0 * (s * (s - 2.0 * t)), 3.0 * (t * (2.0 * s - t)), 3.0 * (t * t)],
        }
    }
}
