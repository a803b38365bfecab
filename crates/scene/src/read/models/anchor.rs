//! Where a mesh lies that is far from the origin.

use glam::{DMat4, DVec3, Vec3};

use crate::Mesh;
use crate::read::notes::Notes;

/// Coordinates from here on are far: 32-bit numbers are 6e-5 apart there.
const FAR: f64 = 1024.0;

/// Coordinates up to here may be what others are relative to: beyond, the way to them might be more than 32 bits hold.
const FARTHEST: f64 = 1e30;

/// The greatest distance of neighbouring 32-bit numbers, in parts of a mesh's diagonal.
const COARSE: f64 = 1e-4;

/// The place that the positions of a mesh are relative to: the origin, unless one of them is far from it.
///
/// Files in coordinates of a country or of a plant have a few metres of surface 5e6 m away, where 32-bit numbers are half a metre apart.
/// What is stored is the way from a place nearby; the object's transform, in double precision, has that place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Anchor(DVec3);

impl Anchor {
    /// Adds a position. The first one that is far moves the anchor, and those before it with it.
    pub(super) fn push(&mut self, position: DVec3, positions: &mut Vec<Vec3>) {
        let is_far = (FAR..=FARTHEST).contains(&position.abs().max_element());
        if self.0 == DVec3::ZERO && position.is_finite() && is_far {
            let here = (position / FAR).round() * FAR;
            self.0 = here;
            positions.iter_mut().for_each(|other| *other = (other.as_dvec3() - here).as_vec3());
        }
        positions.push((position - self.0).as_vec3());
    }

    /// Tells of positions whose 32-bit numbers are farther apart than the surface needs: what a file of such numbers has lost.
    pub(super) fn tell_of_steps(&self, mesh: &Mesh, notes: &mut Notes) {
        let bounds = mesh.bounds();
        if bounds.is_empty() || bounds.diagonal() == 0.0 {
            return;
        }
        let [low, high] = [bounds.min, bounds.max].map(|corner| (corner + self.0).abs());
        let farthest = low.max(high).max_element() as f32;
        let step = f64::from(farthest.next_up() - farthest);
        if f64::from(farthest) >= FAR && step > COARSE * bounds.diagonal() {
            notes.add(&format!(
                "positions lie so far from the origin ({farthest:.3e}) that 32-bit numbers are {step} apart there: surfaces are drawn \
                 in such steps, unless the file has positions near the origin, or 64-bit ones"
            ));
        }
    }

    /// From the mesh to the file's coordinates.
    pub(super) fn transform(&self) -> DMat4 {
        DMat4::from_translation(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Format;
    use super::*;
    use crate::read::tests::{check, read_bytes};

    /// A triangle in metres of a national grid; its corners in the file's coordinates.
    const CORNERS: [[f64; 3]; 3] = [
        [500_000.125, 5_400_000.25, 310.5],
        [500_000.375, 5_400_000.25, 310.5],
        [500_000.125, 5_400_000.5, 310.75],
    ];

    #[test]
    fn files_in_coordinates_of_a_country_keep_their_digits() {
        let line = |[x, y, z]: [f64; 3]| format!("{x} {y} {z}");
        let [a, b, c] = CORNERS.map(line);
        let obj = format!("v 0 0 0\nv {a}\nv {b}\nv {c}\nf 2 3 4\n");
        let ply = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n{a}\n{b}\n{c}\n3 0 1 2\n"
        );
        let stl = format!(
            "solid s\nfacet normal 0 0 1\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\nendsolid s\n"
        );
        for (text, format) in [(obj, Format::Obj), (ply, Format::Ply), (stl, Format::Stl)] {
            let model = read_bytes(text.as_bytes(), format).unwrap();
            check(&model);
            let (mesh, object) = (&model.meshes[0], &model.objects[0]);
            for (position, corner) in mesh.positions.iter().zip(CORNERS) {
                let found = object.transform.transform_point3(position.as_dvec3());
                assert_eq!(found, DVec3::from(corner), "{format:?}");
            }
            assert!(!model.notes.iter().any(|note| note.contains("32-bit")), "{format:?}: {:?}", model.notes);
        }
    }

    #[test]
    fn digits_that_a_file_has_lost_are_told() {
        let mut bytes = vec![b' '; 80];
        bytes.extend(1u32.to_le_bytes());
        bytes.extend([0; 12]);
        CORNERS.as_flattened().iter().for_each(|value| bytes.extend((*value as f32).to_le_bytes()));
        bytes.extend([0; 2]);
        let model = read_bytes(&bytes, Format::Stl).unwrap();
        assert!(model.notes.iter().any(|note| note.contains("0.5 apart there")), "{:?}", model.notes);
    }

    #[test]
    fn small_parts_of_a_large_model_are_no_cause_to_tell() {
        let told = |at: f32| {
            let corners = [[at, 0.0, 0.0], [at + 0.01, 0.0, 0.0], [at, 0.01, 0.0]];
            let positions = corners.map(Vec3::from).to_vec();
            let mesh = Mesh { positions, corners: vec![0, 1, 2], ..Mesh::default() };
            let mut notes = Notes::default();
            Anchor::default().tell_of_steps(&mesh, &mut notes);
            !notes.into_strings().is_empty()
        };
        assert!(!told(9.5) && told(12_000.0));
    }

    #[test]
    fn far_positions_keep_their_digits_wherever_the_first_far_one_comes() {
        let points = [[0.0, 0.0, 0.0], [5e6 + 0.25, -3e6 + 0.125, 12.5], [5e6 + 0.375, -3e6, 13.0]];
        let (mut anchor, mut positions) = (Anchor::default(), Vec::new());
        points.iter().for_each(|point| anchor.push(DVec3::from(*point), &mut positions));
        for (position, point) in positions.iter().zip(points) {
            let found = anchor.transform().transform_point3(position.as_dvec3());
            assert!((found - DVec3::from(point)).length() <= 1e-9 * DVec3::from(point).length(), "{found}");
        }
    }

    #[test]
    fn near_positions_are_as_they_were() {
        let (mut anchor, mut positions) = (Anchor::default(), Vec::new());
        anchor.push(DVec3::new(0.1, -1000.0, f64::NAN), &mut positions);
        assert_eq!(positions[0].x.to_bits(), 0.1_f32.to_bits());
        assert_eq!(anchor.transform(), DMat4::IDENTITY);
        // However far, what 32 bits hold stays a position.
        let mut far = (Anchor::default(), Vec::new());
        for x in [f32::MIN, 1e30, f32::MAX, -1e30, f32::MIN] {
            far.0.push(DVec3::splat(f64::from(x)), &mut far.1);
        }
        assert!(far.1.iter().all(|position| position.is_finite()), "{far:?}");
        // Beyond what 32 bits hold there is nothing.
        anchor.push(DVec3::splat(1e39), &mut positions);
        assert!(!positions[1].is_finite() && anchor.transform() == DMat4::IDENTITY);
    }
}
