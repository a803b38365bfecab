//! Faces as they come in.

use crate::Mesh;

/// Ends the face whose corners were pushed to `mesh.corners` from index `first` on, and returns
/// whether it is one: fewer than three corners are taken back.
///
/// Of a polygon, a corner that is the one before it again is dropped, and at the end one that is the first.
/// `face_starts` stays empty as long as all faces are triangles.
pub(super) fn close_face(mesh: &mut Mesh, first: usize) -> bool {
    drop_repeated(&mut mesh.corners, first);
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

/// Drops repeated corners of the polygon from index `first` on.
fn drop_repeated(corners: &mut Vec<u32>, first: usize) {
    let is_repeated = |pair: &[u32]| pair[0] == pair[1];
    let face = &corners[first..];
    if face.len() <= 3 || !(face.windows(2).any(is_repeated) || face.first() == face.last()) {
        return;
    }
    let mut face = corners.split_off(first);
    face.dedup();
    while face.len() > 1 && face.first() == face.last() {
        face.pop();
    }
    corners.append(&mut face);
}

/// Whether `more` corners still fit in a mesh, whose faces are counted in 32 bits.
pub(super) fn corners_fit(mesh: &Mesh, more: usize) -> bool {
    mesh.corners.len().saturating_add(more) <= u32::MAX as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_that_come_again_are_dropped_from_polygons() {
        let mut mesh = Mesh { positions: vec![glam::Vec3::ZERO; 8], ..Mesh::default() };
        for face in
            [&[0, 1, 2, 3, 0][..], &[4, 4, 5, 6, 6], &[1, 1, 2], &[7, 7, 7, 6, 6, 7], &[0, 1, 2, 0, 3]]
        {
            let first = mesh.corners.len();
            mesh.corners.extend(face);
            assert_eq!(close_face(&mut mesh, first), face[0] != 7);
        }
        let faces: Vec<&[u32]> = mesh.faces().collect();
        assert_eq!(faces, [&[0, 1, 2, 3][..], &[4, 5, 6], &[1, 1, 2], &[0, 1, 2, 0, 3]]);
    }

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
