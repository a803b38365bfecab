//! Faces cut into triangles.

use std::collections::HashMap;

use earcut::Earcut;
use glam::{DVec2, DVec3};

use crate::Mesh;

/// A triangle of a fan that is turned the other way by more than this, as a part of the face, makes the face concave.
/// Less is what rounding does to corners on a line, which no pixel shows.
const TURNED: f64 = 1e-9;

/// The most corners of a face that is cut: the time grows with their square, to half a second here.
pub(crate) const MOST_CORNERS: usize = 1 << 14;

/// The triangles of a face, as places among its corners.
#[derive(Clone, Debug)]
enum FaceTriangles {
    /// A fan around the first corner: how many corners there are, and which is next.
    Fan(usize, usize),
    /// Of a face that is no fan.
    Cut(std::vec::IntoIter<[u32; 3]>),
}

impl Iterator for FaceTriangles {
    type Item = [u32; 3];

    fn next(&mut self) -> Option<[u32; 3]> {
        match self {
            Self::Fan(count, next) => {
                let at = *next as u32;
                (*next < *count).then(|| {
                    *next += 1;
                    [0, at - 1, at]
                })
            }
            Self::Cut(triangles) => triangles.next(),
        }
    }
}

impl FaceTriangles {
    /// A fan, whatever the shape.
    fn fan(corners: usize) -> Self {
        Self::Fan(corners, 2)
    }

    fn of(corners: &[DVec3]) -> Self {
        let fan = Self::fan(corners.len());
        if corners.len() <= 3 || corners.len() > MOST_CORNERS {
            return fan;
        }
        let normal = area_normal(corners);
        let direction = normal.normalize_or_zero();
        let least = -TURNED * normal.length();
        let is_turned = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|corner| corners[corner as usize]);
            (b - a).cross(c - a).dot(direction) < least
        };
        if direction == DVec3::ZERO || !fan.clone().any(is_turned) {
            return fan;
        }
        match cut(&flattened(corners, direction)) {
            triangles if triangles.is_empty() => fan,
            triangles => Self::Cut(triangles.into_iter()),
        }
    }
}

impl Mesh {
    /// The triangles of a face, as places among its corners: a fan around its first corner where that covers the face,
    /// else ears that are cut off one by one in the plane of [`Mesh::face_normal`] (by the crate `earcut`). Every side
    /// of the face is a side of one triangle, also where corners lie on a line.
    pub fn triangles_of(&self, face: usize) -> impl Iterator<Item = [u32; 3]> + use<> {
        self.face_triangles(face)
    }

    fn face_triangles(&self, face: usize) -> FaceTriangles {
        let corners = self.face(face);
        if corners.len() <= 3 {
            return FaceTriangles::fan(corners.len());
        }
        let at = |corner: u32| self.positions[corner as usize].as_dvec3();
        match *corners {
            [a, b, c, d] => FaceTriangles::of(&[a, b, c, d].map(at)),
            _ => FaceTriangles::of(&corners.iter().map(|&corner| at(corner)).collect::<Vec<_>>()),
        }
    }

    /// Whether a face is a fan around its first corner.
    #[cfg(test)]
    fn is_fan(&self, face: usize) -> bool {
        matches!(self.face_triangles(face), FaceTriangles::Fan(..))
    }
}

/// Newell's normal, as long as twice the area.
fn area_normal(corners: &[DVec3]) -> DVec3 {
    let origin = corners[0];
    corners.windows(2).map(|pair| (pair[0] - origin).cross(pair[1] - origin)).sum()
}

/// The corners in the plane, counter-clockwise: along the axis that the normal is nearest to, so that they keep their
/// coordinates, and with them what lies on a line.
fn flattened(corners: &[DVec3], normal: DVec3) -> Vec<DVec2> {
    let size = normal.abs();
    let (x, y, up) = match size {
        _ if size.x >= size.y && size.x >= size.z => (1, 2, normal.x),
        _ if size.y >= size.z => (2, 0, normal.y),
        _ => (0, 1, normal.z),
    };
    let (x, y) = if up < 0.0 { (y, x) } else { (x, y) };
    corners.iter().map(|corner| DVec2::new(corner[x], corner[y])).collect()
}

/// Triangles of an outline, counter-clockwise as it is.
fn cut(outline: &[DVec2]) -> Vec<[u32; 3]> {
    let mut places: Vec<u32> = Vec::new();
    Earcut::new().earcut(outline.iter().map(|corner| corner.to_array()), &[], &mut places);
    let mut triangles: Vec<[u32; 3]> = places
        .chunks_exact(3)
        .map(|places| {
            let [a, b, c] = [places[0], places[1], places[2]];
            if area(outline, [a, b, c]) < 0.0 { [a, c, b] } else { [a, b, c] }
        })
        .collect();
    keep_corners_on_lines(outline, &mut triangles);
    triangles
}

/// Twice the area, negative where it is clockwise.
fn area(outline: &[DVec2], triangle: [u32; 3]) -> f64 {
    let [a, b, c] = triangle.map(|corner| outline[corner as usize]);
    (b - a).perp_dot(c - a)
}

/// Cuts triangles along whose sides corners lie that they do not have: without them there would be gaps to the triangles
/// that have them, of this face and of the next one.
fn keep_corners_on_lines(outline: &[DVec2], triangles: &mut Vec<[u32; 3]>) {
    let mut sides = Sides::of(outline.len() as u32, triangles);
    let most = outline.len() - 2;
    for side in sides.open_of_triangles(triangles) {
        if let Some(run) = sides.run_along(outline, side) {
            insert(outline, triangles, &mut sides, &run, most);
        }
    }
}

/// The directed sides of triangles, with those of the outline backwards, as they belong to what lies around it. Where
/// nothing is missing, each side is there both ways.
struct Sides {
    /// The triangle of each side; `None` around the outline.
    owners: HashMap<[u32; 2], Option<usize>>,
    /// Where sides that are there in one direction alone lead to.
    open: HashMap<u32, Vec<u32>>,
}

impl Sides {
    fn of(corners: u32, triangles: &[[u32; 3]]) -> Self {
        let around = (0..corners).map(|corner| ([(corner + 1) % corners, corner], None));
        let of_triangles = triangles.iter().enumerate();
        let of_triangles = of_triangles.flat_map(|(number, t)| sides_of(*t).map(|side| (side, Some(number))));
        let owners: HashMap<_, _> = around.chain(of_triangles).collect();
        let mut open: HashMap<u32, Vec<u32>> = HashMap::new();
        for &[from, to] in owners.keys().filter(|[from, to]| !owners.contains_key(&[*to, *from])) {
            open.entry(from).or_default().push(to);
        }
        open.values_mut().for_each(|ends| ends.sort_unstable());
        Self { owners, open }
    }

    /// The sides of triangles that are there in one direction alone.
    fn open_of_triangles(&self, triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
        let is_open = |[from, to]: &[u32; 2]| self.open.get(from).is_some_and(|ends| ends.contains(to));
        triangles.iter().flat_map(|triangle| sides_of(*triangle)).filter(is_open).collect()
    }

    /// The corners on a side, from its beginning to its end, that open sides lead along the other way.
    fn run_along(&self, outline: &[DVec2], [begin, end]: [u32; 2]) -> Option<Vec<u32>> {
        let [a, b] = [begin, end].map(|corner| outline[corner as usize]);
        let along = |corner: u32| (outline[corner as usize] - a).dot(b - a);
        let mut run = vec![end];
        while let Some(&last) = run.last().filter(|last| **last != begin) {
            let is_next = |&&corner: &&u32| {
                let on_line = corner == begin || area(outline, [begin, end, corner]) == 0.0;
                on_line && along(corner) >= 0.0 && along(corner) < along(last)
            };
            run.push(
                *self
                    .open
                    .get(&last)?
                    .iter()
                    .filter(is_next)
                    .max_by(|x, y| along(**x).total_cmp(&along(**y)))?,
            );
        }
        run.reverse();
        (run.len() > 2).then_some(run)
    }
}

fn sides_of([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Replaces the triangle on the side from the first to the last of these corners by one for each part of it.
fn insert(outline: &[DVec2], triangles: &mut Vec<[u32; 3]>, sides: &mut Sides, run: &[u32], most: usize) {
    let (Some(&begin), Some(&end)) = (run.first(), run.last()) else { return };
    let Some(&Some(owner)) = sides.owners.get(&[begin, end]) else { return };
    let apex = triangles[owner].into_iter().find(|corner| *corner != begin && *corner != end);
    let Some(apex) = apex.filter(|_| triangles.len() + run.len() - 2 <= most) else { return };
    let parts: Vec<[u32; 3]> = run.windows(2).map(|pair| [pair[0], pair[1], apex]).collect();
    // Of outlines that cross themselves, parts may lead away from the side.
    if parts.iter().any(|part| area(outline, *part) < 0.0) {
        return;
    }
    for (number, &part) in parts.iter().enumerate() {
        let place = if number == 0 { owner } else { triangles.len() };
        match number {
            0 => triangles[owner] = part,
            _ => triangles.push(part),
        }
        sides.owners.extend(sides_of(part).map(|side| (side, Some(place))));
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;

    fn face(corners: &[[f32; 3]]) -> Mesh {
        Mesh {
            positions: corners.iter().map(|&corner| Vec3::from(corner)).collect(),
            corners: (0..corners.len() as u32).collect(),
            face_starts: vec![0, corners.len() as u32],
            ..Mesh::default()
        }
    }

    /// The triangles, and their areas along the normal of the face.
    fn pieces(mesh: &Mesh) -> (Vec<[u32; 3]>, Vec<f64>) {
        let normal = mesh.face_normal(0);
        let triangles: Vec<[u32; 3]> = mesh.triangles().collect();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize].as_dvec3());
            (b - a).cross(c - a).dot(normal) / 2.0
        };
        let areas = triangles.iter().map(area).collect();
        (triangles, areas)
    }

    /// A star of this many points in the plane through the axes `u` and `v`.
    fn star(points: usize, inner: f64, u: DVec3, v: DVec3) -> Mesh {
        let corner = |i: usize| {
            let angle = core::f64::consts::PI * i as f64 / points as f64;
            let radius = if i.is_multiple_of(2) { 1.0 } else { inner };
            (radius * (libm::cos(angle) * u + libm::sin(angle) * v)).as_vec3().to_array()
        };
        face(&(0..2 * points).map(corner).collect::<Vec<_>>())
    }

    #[test]
    fn convex_faces_are_fans_around_their_first_corner() {
        let hexagon = star(3, 0.9, DVec3::X, DVec3::Y);
        assert!(hexagon.is_fan(0));
        assert_eq!(pieces(&hexagon).0, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]);
        // The notch of a dart is no harm to the fan from its own corner or the one opposite.
        let dart = [[0.0, 2.0, 0.0], [-2.0, -2.0, 0.0], [0.0, -1.0, 0.0], [2.0, -2.0, 0.0]];
        assert_eq!(pieces(&face(&dart)).0, [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_concave_quad_is_cut_at_its_notch_wherever_it_begins() {
        let dart = [[0.0, 2.0, 0.0], [-2.0, -2.0, 0.0], [0.0, -1.0, 0.0], [2.0, -2.0, 0.0]];
        for begin in 0..4 {
            let mut turned = dart;
            turned.rotate_left(begin);
            let (triangles, areas) = pieces(&face(&turned));
            assert_eq!(triangles.len(), 2, "{begin}");
            assert!(areas.iter().all(|area| *area == 3.0), "{begin}: {areas:?}");
        }
    }

    #[test]
    fn stars_are_covered_once_in_any_plane() {
        let planes = [
            (DVec3::X, DVec3::Y),
            (DVec3::Y, DVec3::X),
            (DVec3::Z, DVec3::X),
            (DVec3::Y, DVec3::Z),
            (DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.0, -1.0, 0.0)),
        ];
        for (u, v) in planes {
            let mesh = star(7, 0.3, u, v);
            let (triangles, areas) = pieces(&mesh);
            let whole = 7.0 * 0.3 * libm::sin(core::f64::consts::PI / 7.0);
            assert_eq!(triangles.len(), mesh.triangle_count());
            assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
            assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-6, "{areas:?}");
        }
    }

    #[test]
    fn a_hole_that_a_bridge_leads_to_stays_open() {
        // A square ring: out, over the bridge, the hole the other way round, and back.
        let (outer, inner) = ([[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]);
        let list: Vec<[i32; 2]> =
            outer.iter().chain([&outer[0]]).chain(&inner).chain([&inner[0]]).copied().collect();
        let corners: Vec<[f32; 3]> = list.iter().map(|&[x, y]| [x as f32, y as f32, 1.0]).collect();
        let (triangles, areas) = pieces(&face(&corners));
        assert!(areas.iter().all(|area| *area >= 0.0) && areas.iter().sum::<f64>() == 12.0, "{areas:?}");
        let in_hole = |t: &[u32; 3]| {
            let middle = t.iter().map(|&i| Vec3::from(corners[i as usize])).sum::<Vec3>() / 3.0;
            (middle.x - 2.0).abs() < 1.0 && (middle.y - 2.0).abs() < 1.0
        };
        assert!(!triangles.iter().any(in_hole), "{triangles:?}");
    }

    #[test]
    fn corners_on_a_side_stay_corners_of_triangles() {
        // A U whose outer sides have more corners on them.
        let outline = [
            [0, 0],
            [1, 0],
            [2, 0],
            [3, 0],
            [3, 1],
            [3, 2],
            [3, 3],
            [2, 3],
            [2, 2],
            [2, 1],
            [1, 1],
            [1, 2],
            [1, 3],
            [0, 3],
            [0, 2],
            [0, 1],
        ];
        for begin in 0..outline.len() {
            let mut turned = outline;
            turned.rotate_left(begin);
            let corners: Vec<[f32; 3]> = turned.iter().map(|&[x, y]| [x as f32, y as f32, 0.0]).collect();
            let (triangles, areas) = pieces(&face(&corners));
            assert!(areas.iter().all(|area| *area >= 0.0) && areas.iter().sum::<f64>() == 7.0, "{areas:?}");
            let count = corners.len() as u32;
            for side in 0..count {
                let next = (side + 1) % count;
                let has = |t: &[u32; 3]| (0..3).any(|i| t[i] == side && t[(i + 1) % 3] == next);
                assert_eq!(triangles.iter().filter(|t| has(t)).count(), 1, "begin {begin}, side {side}");
            }
        }
    }

    #[test]
    fn faces_without_area_and_long_lists_are_fans() {
        assert!(face(&[[0.0; 3]; 5]).is_fan(0));
        assert!(face(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]).is_fan(0));
        let corner = |i: usize| [i as f32, if i.is_multiple_of(2) { 1.0 } else { 0.0 }, 0.0];
        let zigzag: Vec<[f32; 3]> = (0..=MOST_CORNERS).map(corner).collect();
        assert!(face(&zigzag).is_fan(0) && !face(&zigzag[..99]).is_fan(0));
    }

    #[test]
    fn a_comb_of_as_many_corners_as_are_cut_takes_a_second() {
        let teeth = 8000;
        let tooth = |i: usize| [[i as f32, 0.0, 0.0], [i as f32 + 0.5, -10.0, 0.0]];
        let mut corners: Vec<[f32; 3]> = (0..teeth).flat_map(tooth).collect();
        corners.extend([[teeth as f32, 1.0, 0.0], [0.0, 1.0, 0.0]]);
        let start = std::time::Instant::now();
        let (triangles, areas) = pieces(&face(&corners));
        assert_eq!(triangles.len(), corners.len() - 2);
        assert!(areas.iter().all(|area| *area >= 0.0));
        assert!(start.elapsed().as_secs() < 20);
    }

    proptest! {
        #[test]
        fn whatever_the_corners_are_the_triangles_are_of_them(
            places in prop::collection::vec((-3i8..4, -3i8..4, -1i8..2), 3..40),
        ) {
            let corners: Vec<[f32; 3]> =
                places.iter().map(|p| [f32::from(p.0), f32::from(p.1), f32::from(p.2)]).collect();
            let mesh = face(&corners);
            let triangles: Vec<[u32; 3]> = mesh.triangles().collect();
            prop_assert!(triangles.len() <= mesh.triangle_count());
            prop_assert!(triangles.iter().flatten().all(|&corner| (corner as usize) < corners.len()));
        }

        #[test]
        fn outlines_around_a_point_are_covered_once(
            radii in prop::collection::vec(1u8..30, 3..60),
            begin in any::<prop::sample::Index>(),
        ) {
            let count = radii.len();
            let begin = begin.index(count);
            let corner = |i: usize| {
                let angle = 2.0 * core::f64::consts::PI * i as f64 / count as f64;
                let radius = f64::from(radii[i]);
                [(radius * libm::cos(angle)) as f32, (radius * libm::sin(angle)) as f32, 0.0]
            };
            let corners: Vec<[f32; 3]> = (0..count).map(|i| corner((i + begin) % count)).collect();
            let mesh = face(&corners);
            let (triangles, areas) = pieces(&mesh);
            let at = |i: usize| Vec3::from(corners[i % count]).as_dvec3();
            let whole: f64 = (0..count).map(|i| at(i).cross(at(i + 1)).z / 2.0).sum();
            // What an outline of three corners may turn the wrong way is a sliver.
            prop_assert!(whole <= 0.0 || areas.iter().map(|area| area.abs()).sum::<f64>() <= whole * (1.0 + 1e-5));
            prop_assert_eq!(triangles.len(), count - 2);
        }
    }
}
