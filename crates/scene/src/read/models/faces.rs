//! Faces as they come in.

use crate::Mesh;

/// Ends the face whose corners were pushed to `mesh.corners` from index `first` on, and returns
/// whether it is one: fewer than three corners are taken back.
///
/// `face_starts` stays empty as long as all faces are triangles.
pub(super) fn close_face(mesh: &mut Mesh, first: usize) -> bool {
    let end = mesh.corners.len();
    if end - first < 3 {
        mesh.corners.truncate(first);
        return false;
    }
    if mesh.face_starts.is_empty() {
        if end - first == 3 {
            return true;
        }
        mesh.face_starts = (0..=first as u32).step_by(3).collect();
    }
    mesh.face_starts.push(end as u32);
    true
}

/// Whether `more` corners still fit in a mesh, whose faces are counted in 32 bits.
pub(super) fn corners_fit(mesh: &Mesh, more: usize) -> bool {
    mesh.corners.len().saturating_add(more) <= u32::MAX as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn starts_are_kept_only_from_the_first_polygon_on() {
        let mut mesh = Mesh { positions: vec![glam::Vec3::ZERO; 8], ..Mesh::default() };
        let mut add = |count: u32| {
            let first = mesh.corners.len();
            mesh.corners.extend(0..count);
            (close_face(&mut mesh, first), mesh.face_starts.len())
        };
        assert_eq!([add(3), add(2), add(3)], [(true, 0), (false, 0), (true, 0)]);
        assert_eq!([add(4), add(1), add(3)], [(true, 4), (false, 4), (true, 5)]);
        assert_eq!(mesh.face_starts, [0, 3, 6, 10, 13]);
        assert_eq!(mesh.validate(), Ok(()));
    }
}
