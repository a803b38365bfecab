//! The last steps of every reader: attributes as [`Mesh`] promises them.

use glam::{Vec3, Vec4};

use super::faces::close_face;
use crate::mesh::topology::Splitter;
use crate::mesh::triangulate::MOST_CORNERS;
use crate::read::notes::Notes;
use crate::{Mesh, Normals};

/// Leaves faces out that use a position which is no finite number. Such positions become 0: nothing uses them then.
pub(super) fn drop_faces_without_positions(mesh: &mut Mesh, notes: &mut Notes) {
    if mesh.positions.iter().all(|position| position.is_finite()) {
        return;
    }
    let mut kept = Mesh::default();
    for face in mesh.faces() {
        if face.iter().all(|&corner| mesh.positions[corner as usize].is_finite()) {
            let first = kept.corners.len();
            kept.corners.extend(face);
            close_face(&mut kept, first);
        }
    }
    let dropped = mesh.face_count() - kept.face_count();
    notes.add_times("faces with positions that are no finite numbers are left out", dropped as u64);
    (mesh.corners, mesh.face_starts) = (kept.corners, kept.face_starts);
    mesh.positions
        .iter_mut()
        .filter(|position| !position.is_finite())
        .for_each(|position| *position = Vec3::ZERO);
}

/// Makes normals and tangents unit vectors.
///
/// A normal of length zero says nothing: it is replaced by the one that a mesh without normals gets there. If all are zero the mesh has no normals. Tangents of length zero drop all tangents.
pub(super) fn finish_mesh(mesh: &mut Mesh, notes: &mut Notes) {
    let mut missing = 0;
    for normal in &mut mesh.normals {
        match unit(*normal) {
            Some(normalized) => *normal = normalized,
            None => {
                *normal = Vec3::ZERO;
                missing += 1;
            }
        }
    }
    if missing > 0 && missing == mesh.normals.len() {
        mesh.normals = Vec::new();
    } else if missing > 0 {
        notes.add_times(
            "normals that are missing or of length zero are computed from the faces",
            missing as u64,
        );
        fill_normals(mesh);
    }
    finish_tangents(mesh, notes);
    let long = mesh.face_starts.windows(2).filter(|pair| (pair[1] - pair[0]) as usize > MOST_CORNERS).count();
    let note = format!("faces of more than {MOST_CORNERS} corners are drawn as fans, as if they were convex");
    notes.add_times(&note, long as u64);
    mesh.positions.shrink_to_fit();
    mesh.corners.shrink_to_fit();
}

/// The unit vector of this direction. In double precision, where no float overflows or vanishes.
fn unit(vector: Vec3) -> Option<Vec3> {
    vector.as_dvec3().try_normalize().map(|unit| unit.as_vec3())
}

/// Fills in the normals that are zero: with those that the mesh would get if it had none, so that edges stay sharp.
/// Vertices that need several are split.
fn fill_normals(mesh: &mut Mesh) {
    let bare = Mesh {
        positions: mesh.positions.clone(),
        corners: mesh.corners.clone(),
        face_starts: mesh.face_starts.clone(),
        ..Mesh::default()
    };
    let made = bare.with_normals(Normals::Given);
    let mut splitter = Splitter::new(mesh.positions.len());
    let mut normals: Vec<Vec3> =
        mesh.normals.iter().map(|&normal| normal.try_normalize().unwrap_or(Vec3::Z)).collect();
    for (corner, &other) in mesh.corners.iter_mut().zip(&made.corners) {
        let given = mesh.normals[*corner as usize];
        if given == Vec3::ZERO {
            let normal = made.normals[other as usize];
            *corner = splitter.user(*corner, normal.to_array().map(f32::to_bits));
            normals.resize(splitter.sources.len(), normal);
            normals[*corner as usize] = normal;
        }
    }
    let sources = splitter.sources;
    let tangents = std::mem::take(&mut mesh.tangents);
    let split = mesh.pick_vertices(&sources);
    (mesh.positions, mesh.colors) = (split.positions, split.colors);
    (mesh.uvs, mesh.uvs2) = (split.uvs, split.uvs2);
    mesh.normals = normals;
    if !tangents.is_empty() {
        mesh.tangents = sources.iter().map(|&source| tangents[source as usize]).collect();
    }
}

fn finish_tangents(mesh: &mut Mesh, notes: &mut Notes) {
    let complete = mesh.tangents.iter_mut().all(|tangent| match unit(tangent.truncate()) {
        Some(direction) => {
            *tangent = direction.extend(if tangent.w < 0.0 { -1.0 } else { 1.0 });
            true
        }
        None => false,
    });
    if !complete {
        notes.add("tangents are computed anew since some have length zero");
        mesh.tangents = Vec::<Vec4>::new();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(normals: Vec<Vec3>) -> Mesh {
        Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            normals,
            corners: vec![0, 1, 2],
            ..Mesh::default()
        }
    }

    #[test]
    fn normals_become_unit_and_zero_ones_are_filled_from_faces() {
        let mut mesh = triangle(vec![Vec3::X * 1e-30, Vec3::ZERO, Vec3::Y * 1e30]);
        finish_mesh(&mut mesh, &mut Notes::default());
        assert_eq!(mesh.normals, [Vec3::X, Vec3::Z, Vec3::Y]);
    }

    #[test]
    fn normals_that_are_filled_keep_edges_sharp() {
        // Two triangles with a fold of 90° at the points 0 and 1, whose normals are missing.
        let mut mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
            normals: vec![Vec3::ZERO, Vec3::ZERO, Vec3::X, Vec3::X],
            tangents: vec![Vec4::X; 4],
            uvs: vec![glam::Vec2::X; 4],
            corners: vec![0, 1, 2, 1, 0, 3],
            ..Mesh::default()
        };
        finish_mesh(&mut mesh, &mut Notes::default());
        assert_eq!(mesh.validate(), Ok(()));
        let normals: Vec<Vec3> = mesh.corners.iter().map(|&corner| mesh.normals[corner as usize]).collect();
        assert_eq!(normals, [Vec3::Z, Vec3::Z, Vec3::X, Vec3::Y, Vec3::Y, Vec3::X]);
        assert_eq!((mesh.positions.len(), mesh.tangents.len(), mesh.uvs.len()), (6, 6, 6));
    }

    #[test]
    fn normals_that_are_all_zero_are_none() {
        let mut mesh = triangle(vec![Vec3::ZERO; 3]);
        finish_mesh(&mut mesh, &mut Notes::default());
        assert!(mesh.normals.is_empty());
    }

    #[test]
    fn faces_that_are_too_long_to_be_cut_are_told() {
        let corners = MOST_CORNERS as u32 + 1;
        let mut mesh = triangle(Vec::new());
        mesh.corners = (0..corners).map(|corner| corner % 3).collect();
        mesh.face_starts = vec![0, corners];
        let mut notes = Notes::default();
        finish_mesh(&mut mesh, &mut notes);
        assert_eq!(
            notes.into_strings(),
            ["faces of more than 16384 corners are drawn as fans, as if they were convex"]
        );
    }

    #[test]
    fn one_zero_tangent_drops_all() {
        let mut mesh = triangle(Vec::new());
        mesh.tangents = vec![Vec4::new(2.0, 0.0, 0.0, -0.5); 3];
        finish_mesh(&mut mesh, &mut Notes::default());
        assert_eq!(mesh.tangents, [Vec4::new(1.0, 0.0, 0.0, -1.0); 3]);
        mesh.tangents[1] = Vec4::W;
        finish_mesh(&mut mesh, &mut Notes::default());
        assert!(mesh.tangents.is_empty());
    }
}
