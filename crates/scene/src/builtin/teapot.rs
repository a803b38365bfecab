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
    let mut mesh = Mesh { face_starts: vec![0], ..Mesh::default() };
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
        for column in 0..weights.len() {
            // The published patches run leftwards seen from outside.
            let across = &weights[weights.len() - 1 - column];
            mesh.positions.push(sum(points, &across.value, &down.value).as_vec3());
            mesh.normals.push(normal(points, across, down).as_vec3());
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

/// The unit normal of a patch. Where its first row is a point, the derivative across vanishes there
/// and grows with the mixed derivative, which then takes its place.
fn normal(points: &[DVec3; 16], across: &Weights, down: &Weights) -> DVec3 {
    let along_down = sum(points, &across.value, &down.slope);
    let along_across = sum(points, &across.slope, &down.value);
    let cross = along_across.cross(along_down);
    // Lengths are of the order of 1, and a derivative that vanishes does so but for rounding.
    if cross.length_squared() > 1e-20 {
        return cross.normalize();
    }
    sum(points, &across.slope, &down.slope).cross(along_down).normalize()
}

/// Σ across[i] down[j] point[j][i]. Terms are added from the ends inwards, so that the same curve run
/// through backwards gives the same bits: patches meet without gaps.
fn sum(points: &[DVec3; 16], across: &[f64; 4], down: &[f64; 4]) -> DVec3 {
    let row = |j: usize| mirror_sum([0, 1, 2, 3].map(|i| points[4 * j + i] * across[i]));
    mirror_sum([0, 1, 2, 3].map(|j| row(j) * down[j]))
}

fn mirror_sum([a, b, c, d]: [DVec3; 4]) -> DVec3 {
    (a + d) + (b + c)
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
