//! Vertex normals.

use core::f64::consts::PI;

use glam::{DVec3, Vec3};

use crate::{
    Mesh,
    mesh::topology::{Groups, Splitter, Welded, for_each_edge},
};

/// Where the normals of a mesh come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Normals {
    /// As the mesh has them; smooth with [`Normals::DEFAULT_CREASE`] where it has none.
    Given,
    /// Each facet its own.
    Facet,
    /// The angle-weighted mean over the facets around a point, except across edges where facets
    /// meet at more than `crease` radians.
    Smooth {
        /// The greatest angle between facets that still counts as smooth, in radians; π for all.
        crease: f64,
    },
}

impl Normals {
    /// The crease of meshes that come without normals, in radians (60°): the edges of boxes stay
    /// sharp, a round thing of a dozen sides looks round.
    pub const DEFAULT_CREASE: f64 = PI / 3.0;
}

/// Angles this little beyond the crease still are within: the facets of a cylinder of twelve sides
/// meet at 30° but for the rounding of their `f32` coordinates, and should all be treated alike.
const CREASE_SLACK: f64 = 1e-4;

/// Sums of unit normals times angles that are shorter than this have cancelled out but for rounding.
const LEAST_SUM: f64 = 1e-12;

impl Mesh {
    /// The mesh with normals made after `normals`. It must be valid.
    ///
    /// Vertices that need several normals are split. Vertices at exactly the same place count as one
    /// point, so that seams in the texture coordinates do not show. Facets around a point belong
    /// together if a chain of facets leads from one to the other over edges at that point that are
    /// not sharp (at π: always); a chain may in all turn by more than the crease. Each facet's normal
    /// is weighted by its angle at the point (G. Thürmer, C. A. Wüthrich, *Computing vertex normals
    /// from polygonal facets*, Journal of Graphics Tools 3(1), 1998). Facets without area count for
    /// nothing; where there are no others the normal is +Z. Tangents do not survive new normals.
    pub fn with_normals(self, normals: Normals) -> Self {
        match normals {
            Normals::Given if self.normals.is_empty() => with_smooth_normals(self, Normals::DEFAULT_CREASE),
            Normals::Given => self,
            Normals::Facet => with_facet_normals(self),
            Normals::Smooth { crease } => with_smooth_normals(self, crease),
        }
    }

    /// The unit normal of a face by Newell's method, in `f64`; zero where the face has no area. The
    /// face's indices must be valid.
    pub fn face_normal(&self, face: usize) -> DVec3 {
        self.face_area_normal(face).try_normalize().unwrap_or(DVec3::ZERO)
    }

    /// The same, as long as twice the area.
    fn face_area_normal(&self, face: usize) -> DVec3 {
        let corners = self.face(face);
        let Some(&last) = corners.last() else { return DVec3::ZERO };
        let at = |index: u32| self.positions[index as usize].as_dvec3();
        let origin = at(corners[0]);
        let mut before = at(last) - origin;
        let mut sum = DVec3::ZERO;
        for &corner in corners {
            let here = at(corner) - origin;
            sum += before.cross(here);
            before = here;
        }
        sum
    }

    /// The mesh whose vertices are those of this one named by `sources`, without tangents and faces.
    pub(crate) fn pick_vertices(&self, sources: &[u32]) -> Self {
        fn pick<T: Copy>(from: &[T], sources: &[u32]) -> Vec<T> {
            if from.is_empty() { Vec::new() } else { sources.iter().map(|&i| from[i as usize]).collect() }
        }
        Self {
            name: self.name.clone(),
            positions: pick(&self.positions, sources),
            normals: pick(&self.normals, sources),
            uvs: pick(&self.uvs, sources),
            uvs2: pick(&self.uvs2, sources),
            colors: pick(&self.colors, sources),
            ..Self::default()
        }
    }
}

fn with_facet_normals(mesh: Mesh) -> Mesh {
    let mut flat = mesh.pick_vertices(&mesh.corners);
    flat.normals = Vec::with_capacity(mesh.corners.len());
    for face in 0..mesh.face_count() {
        let normal = usable(mesh.face_normal(face).as_vec3());
        flat.normals.extend(core::iter::repeat_n(normal, mesh.face(face).len()));
    }
    flat.corners = (0..mesh.corners.len() as u32).collect();
    flat.face_starts = mesh.face_starts;
    flat
}

fn with_smooth_normals(mesh: Mesh, crease: f64) -> Mesh {
    let points = Welded::of(&mesh.positions).point_of;
    let facets: Vec<DVec3> = (0..mesh.face_count()).map(|face| mesh.face_normal(face)).collect();
    let groups = corner_groups(&mesh, &points, &facets, crease);
    let sums = group_sums(&mesh, &groups, &facets);
    assign(mesh, &groups, &facets, &sums)
}

impl Mesh {
    /// The mesh with normals by the smoothing group that each face is in: those of one group are smooth over all edges
    /// that they share, those of group 0 are flat, those of none are smooth up to [`Normals::DEFAULT_CREASE`].
    pub(crate) fn with_smoothing_groups(self, smoothing: &[Option<u32>]) -> Self {
        let points = Welded::of(&self.positions).point_of;
        let facets: Vec<DVec3> = (0..self.face_count()).map(|face| self.face_normal(face)).collect();
        let mut groups = Groups::new(self.corners.len());
        let point_count = points.iter().max().map_or(0, |&p| p as usize + 1);
        let is_smooth = is_within(&facets, Normals::DEFAULT_CREASE);
        join_over_edges(&self, &points, point_count, &mut groups, |face, other| {
            match (smoothing[face], smoothing[other]) {
                (None, None) => is_smooth(face, other),
                (Some(group), Some(other)) => group == other && group > 0,
                _ => false,
            }
        });
        let groups = groups.into_roots();
        let sums = group_sums(&self, &groups, &facets);
        assign(self, &groups, &facets, &sums)
    }
}

/// Facets that meet at less than this, in radians (0.1°), are parts of one flat face.
const FLAT: f64 = PI / 1800.0;

/// So many times as large as any other face at a point is one that keeps its normal there.
const MUCH_LARGER: f64 = 4.0;

impl Mesh {
    /// The mesh with smooth normals for facets that come from flat and curved faces, such as those of construction
    /// programs. Edges at `crease` radians or more are sharp. At a point where one face of several facets in a plane is
    /// much larger than all others that it is smooth with, its normal is taken: a plate is flat up to its rounded rim.
    pub(crate) fn with_normals_of_flat_faces(self, crease: f64) -> Self {
        let points = Welded::of(&self.positions).point_of;
        let facets: Vec<DVec3> = (0..self.face_count()).map(|face| self.face_normal(face)).collect();
        // Less than the crease by as much as `is_within` gives in.
        let crease = crease - 2.0 * CREASE_SLACK;
        let groups = corner_groups(&self, &points, &facets, crease);
        let mut sums = group_sums(&self, &groups, &facets);
        keep_flat_faces(&self, &groups, &flat_faces(&self, &points, &facets), &mut sums);
        assign(self, &groups, &facets, &sums)
    }
}

/// For each face the first one of the flat face that it is a part of.
fn flat_faces(mesh: &Mesh, points: &[u32], facets: &[DVec3]) -> Vec<u32> {
    let mut flat = Groups::new(mesh.face_count());
    let is_flat = is_within(facets, FLAT - CREASE_SLACK);
    let point_count = points.iter().max().map_or(0, |&p| p as usize + 1);
    let (sides, owners) = sides(mesh, points);
    for_each_edge(&sides, point_count, |_, members| {
        for pair in members.windows(2) {
            let [(face, _), (other, _)] = [pair[0], pair[1]].map(|side| owners[side as usize]);
            if is_flat(face as usize, other as usize) {
                flat.join(face, other);
            }
        }
    });
    flat.into_roots()
}

/// Gives groups the normal of a flat face that is much larger than the others in them.
fn keep_flat_faces(mesh: &Mesh, groups: &[u32], flat: &[u32], sums: &mut [DVec3]) {
    // By the first facet of each flat face: twice its area along its normal, and of how many facets it is.
    let mut faces = vec![(DVec3::ZERO, 0_u32); flat.len()];
    for (face, &first) in flat.iter().enumerate() {
        let (sum, count) = &mut faces[first as usize];
        *sum += mesh.face_area_normal(face);
        *count += 1;
    }
    // By the first corner of each group: the largest flat face in it, and the area of the next one.
    let mut largest = vec![(u32::MAX, 0.0_f64, 0.0_f64); groups.len()];
    let owners =
        mesh.faces().enumerate().flat_map(|(face, corners)| core::iter::repeat_n(face, corners.len()));
    for (&group, face) in groups.iter().zip(owners) {
        let (first, area) = (flat[face], faces[flat[face] as usize].0.length());
        let (known, most, next) = &mut largest[group as usize];
        if first == *known {
            continue;
        }
        if area > *most {
            (*known, *most, *next) = (first, area, *most);
        } else {
            *next = next.max(area);
        }
    }
    for (sum, (first, area, next)) in sums.iter_mut().zip(largest) {
        if first != u32::MAX && faces[first as usize].1 > 1 && area >= MUCH_LARGER * next {
            *sum = faces[first as usize].0.normalize_or(*sum);
        }
    }
}

/// Whether facets meet at no more than the crease; those without area never.
fn is_within(facets: &[DVec3], crease: f64) -> impl Fn(usize, usize) -> bool {
    let least_cos = libm::cos((crease.max(0.0) + CREASE_SLACK).min(PI));
    move |face, other| {
        let (one, two) = (facets[face], facets[other]);
        one != DVec3::ZERO && two != DVec3::ZERO && one.dot(two) >= least_cos
    }
}

/// For each corner the first corner (in file order) of the group that it shares its normal with.
fn corner_groups(mesh: &Mesh, points: &[u32], facets: &[DVec3], crease: f64) -> Vec<u32> {
    let mut groups = Groups::new(mesh.corners.len());
    let point_count = points.iter().max().map_or(0, |&p| p as usize + 1);
    if crease >= PI {
        join_all_at_points(mesh, points, point_count, &mut groups);
    } else {
        join_over_edges(mesh, points, point_count, &mut groups, is_within(facets, crease));
    }
    groups.into_roots()
}

fn join_all_at_points(mesh: &Mesh, points: &[u32], point_count: usize, groups: &mut Groups) {
    let mut first = vec![u32::MAX; point_count];
    for (corner, &vertex) in mesh.corners.iter().enumerate() {
        let first = &mut first[points[vertex as usize] as usize];
        if *first == u32::MAX {
            *first = corner as u32;
        }
        groups.join(*first, corner as u32);
    }
}

fn join_over_edges(
    mesh: &Mesh,
    points: &[u32],
    point_count: usize,
    groups: &mut Groups,
    is_smooth: impl Fn(usize, usize) -> bool,
) {
    let (sides, owners) = sides(mesh, points);
    for_each_edge(&sides, point_count, |[a, b], members| {
        if a == b {
            return;
        }
        // Where more than two facets meet, each is compared with its next in file order.
        for pair in members.windows(2) {
            let [one, two] = [pair[0] as usize, pair[1] as usize];
            let [(face, end), (other, other_end)] = [owners[one], owners[two]];
            if !is_smooth(face as usize, other as usize) {
                continue;
            }
            if sides[one][0] == sides[two][0] {
                groups.join(one as u32, two as u32);
                groups.join(end, other_end);
            } else {
                groups.join(one as u32, other_end);
                groups.join(end, two as u32);
            }
        }
    });
}

/// For each side of each face, by its first corner: its end points; its face and its second corner.
fn sides(mesh: &Mesh, points: &[u32]) -> (Vec<[u32; 2]>, Vec<(u32, u32)>) {
    let mut sides = Vec::with_capacity(mesh.corners.len());
    let mut owners = Vec::with_capacity(mesh.corners.len());
    let mut start = 0;
    for (number, face) in mesh.faces().enumerate() {
        for i in 0..face.len() {
            let next = (i + 1) % face.len();
            sides.push([points[face[i] as usize], points[face[next] as usize]]);
            owners.push((number as u32, (start + next) as u32));
        }
        start += face.len();
    }
    (sides, owners)
}

/// The sum over each group of facet normals times angles, at the index of the group's first corner.
fn group_sums(mesh: &Mesh, groups: &[u32], facets: &[DVec3]) -> Vec<DVec3> {
    let at = |index: u32| mesh.positions[index as usize].as_dvec3();
    let mut sums = vec![DVec3::ZERO; groups.len()];
    let mut corner = 0;
    for (face, normal) in mesh.faces().zip(facets) {
        for (i, &vertex) in face.iter().enumerate() {
            let here = at(vertex);
            let to_next = at(face[(i + 1) % face.len()]) - here;
            let to_last = at(face[(i + face.len() - 1) % face.len()]) - here;
            let angle = libm::atan2(to_next.cross(to_last).length(), to_next.dot(to_last));
            if angle.is_finite() {
                sums[groups[corner] as usize] += *normal * angle;
            }
            corner += 1;
        }
    }
    sums
}

/// Gives each vertex the normal of its group, and a twin for each further group that uses it.
fn assign(mesh: Mesh, groups: &[u32], facets: &[DVec3], sums: &[DVec3]) -> Mesh {
    let mut splitter = Splitter::new(mesh.positions.len());
    let mut normals = vec![Vec3::ZERO; mesh.positions.len()];
    let mut corners = Vec::with_capacity(mesh.corners.len());
    for (face, &facet) in mesh.faces().zip(facets) {
        for &vertex in face {
            let group = groups[corners.len()];
            let sum = sums[group as usize];
            if sum.length_squared() >= LEAST_SUM * LEAST_SUM {
                let user = splitter.user(vertex, group);
                normals.resize(splitter.sources.len(), Vec3::ZERO);
                normals[user as usize] = sum.normalize().as_vec3();
                corners.push(user);
                continue;
            }
            // No facet with an area, or two back to back: whatever the vertex has will do.
            if !splitter.serves(vertex) && normals[vertex as usize] == Vec3::ZERO {
                normals[vertex as usize] = facet.as_vec3();
            }
            corners.push(vertex);
        }
    }
    let mut smooth = mesh.pick_vertices(&splitter.sources);
    smooth.normals = normals.into_iter().map(usable).collect();
    smooth.corners = corners;
    smooth.face_starts = mesh.face_starts;
    smooth
}

/// +Z in the place of no normal.
fn usable(normal: Vec3) -> Vec3 {
    if normal == Vec3::ZERO { Vec3::Z } else { normal }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use glam::Vec2;
    use proptest::prelude::*;

    use super::*;
    use crate::Builtin;

    const ALL: Normals = Normals::Smooth { crease: PI };

    fn make(builtin: Builtin) -> Mesh {
        builtin.mesh().expect("the parameters are in range")
    }

    fn bare(builtin: Builtin) -> Mesh {
        Mesh { normals: Vec::new(), ..make(builtin) }
    }

    /// The cube with only its eight points as vertices.
    fn shared_cube() -> Mesh {
        let cube = make(Builtin::Cube { size: 2.0 });
        let mut positions: Vec<Vec3> = Vec::new();
        let mut corners = Vec::new();
        for &corner in &cube.corners {
            let position = cube.positions[corner as usize];
            let known = positions.iter().position(|&p| p == position);
            corners.push(known.unwrap_or(positions.len()) as u32);
            if known.is_none() {
                positions.push(position);
            }
        }
        Mesh { positions, corners, face_starts: cube.face_starts, ..Mesh::default() }
    }

    /// The normal at each corner.
    fn corner_normals(mesh: &Mesh) -> Vec<Vec3> {
        mesh.corners.iter().map(|&vertex| mesh.normals[vertex as usize]).collect()
    }

    #[test]
    fn a_cube_below_its_crease_gets_flat_sides_and_above_it_diagonal_corners() {
        let flat = shared_cube().with_normals(Normals::Smooth { crease: 30_f64.to_radians() });
        assert_eq!(flat.validate(), Ok(()));
        assert_eq!(flat.positions.len(), 24);
        for face in 0..6 {
            let facet = flat.face_normal(face).as_vec3();
            assert!(flat.face(face).iter().all(|&corner| flat.normals[corner as usize] == facet));
        }
        for crease in [PI, 91_f64.to_radians()] {
            let round = shared_cube().with_normals(Normals::Smooth { crease });
            assert_eq!(round.positions.len(), 8);
            for (position, normal) in round.positions.iter().zip(&round.normals) {
                // Exact but for the rounding to f32: three right angles at each corner.
                assert!(normal.distance(position.normalize()) < 1e-7, "{position} {normal}");
            }
        }
    }

    #[test]
    fn triangulation_of_a_cube_does_not_show_in_its_normals() {
        let cube = shared_cube();
        let corners: Vec<u32> = cube.triangles().flatten().collect();
        let triangles = Mesh { corners, face_starts: Vec::new(), ..cube }.with_normals(ALL);
        for (position, normal) in triangles.positions.iter().zip(&triangles.normals) {
            assert!(normal.distance(position.normalize()) < 1e-7, "{position} {normal}");
        }
    }

    #[test]
    fn an_edge_at_exactly_the_crease_is_smooth_all_around() {
        let cylinder = Builtin::Cylinder { radius: 1.0, height: 2.0, slices: 12, capped: false };
        let smooth = bare(cylinder).with_normals(Normals::Smooth { crease: 30_f64.to_radians() });
        assert_eq!(smooth.positions.len(), 26);
        let sharp = bare(cylinder).with_normals(Normals::Smooth { crease: 29_f64.to_radians() });
        assert_eq!(sharp.positions.len(), 48);
    }

    #[test]
    fn a_smoothed_sphere_comes_close_to_the_true_normals_even_along_its_seam() {
        let sphere = Builtin::Sphere { radius: 2.0, slices: 64, stacks: 32 };
        let smooth = bare(sphere).with_normals(Normals::Given);
        assert_eq!(smooth.positions.len(), make(sphere).positions.len());
        for (normal, exact) in smooth.normals.iter().zip(&make(sphere).normals) {
            // Facets turn by 5.6°; the weighted mean is off by the square of that, half a degree at most.
            assert!(normal.dot(*exact) > 0.99996, "{normal} {exact}");
        }
        let row = 64 + 10 * 65;
        assert_eq!(smooth.normals[row], smooth.normals[row + 64], "both sides of the seam");
    }

    #[test]
    fn the_smoothed_kite_has_the_mean_of_both_normals_along_its_fold() {
        let kite = make(Builtin::Kite);
        let [left, right] = [0, 1].map(|face| kite.face_normal(face));
        let mean = (left + right).normalize().as_vec3();
        let smooth = corner_normals(&kite.with_normals(ALL));
        // ACB, ABD: A and B lie on the fold.
        for corner in [0, 2, 3, 4] {
            assert!(smooth[corner].distance(mean) < 1e-7, "{corner}: {}", smooth[corner]);
        }
        assert_eq!((smooth[1], smooth[5]), (left.as_vec3(), right.as_vec3()));
    }

    #[test]
    fn facet_normals_split_all_vertices_and_keep_their_attributes() {
        let sphere = make(Builtin::Sphere { radius: 1.0, slices: 8, stacks: 4 });
        let flat = sphere.clone().with_normals(Normals::Facet);
        assert_eq!(flat.validate(), Ok(()));
        assert_eq!(flat.positions.len(), sphere.corners.len());
        let uvs: Vec<Vec2> = sphere.corners.iter().map(|&corner| sphere.uvs[corner as usize]).collect();
        assert_eq!(flat.uvs, uvs);
        for face in 0..flat.face_count() {
            let normal = flat.face_normal(face).as_vec3();
            assert!(flat.face(face).iter().all(|&corner| flat.normals[corner as usize] == normal));
        }
    }

    #[test]
    fn given_normals_are_left_alone() {
        let mesh = Mesh { normals: vec![Vec3::X; 6], ..make(Builtin::Kite) };
        assert_eq!(mesh.clone().with_normals(Normals::Given), mesh);
    }

    #[test]
    fn newell_s_normal_is_that_of_a_concave_polygon_too() {
        let arrow = [[0.0, 0.0], [2.0, -1.0], [0.0, 3.0], [-2.0, -1.0]];
        let mesh = Mesh {
            positions: arrow.map(|[x, y]| Vec3::new(x, y, 5.0)).to_vec(),
            corners: vec![1, 2, 3, 0],
            face_starts: vec![0, 4],
            ..Mesh::default()
        };
        assert_eq!(mesh.face_normal(0), DVec3::Z);
    }

    #[test]
    fn facets_without_area_count_for_nothing() {
        let mut cube = shared_cube();
        cube.corners.extend([0, 1, 1, 2, 2, 2]);
        cube.face_starts.extend([27, 30]);
        let clean = shared_cube().with_normals(ALL);
        assert_eq!(cube.with_normals(ALL).normals, clean.normals);
    }

    #[test]
    fn points_without_a_facet_and_sheets_of_two_sides_have_defined_normals() {
        let mesh = Mesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Z, Vec3::ONE],
            corners: vec![0, 2, 1, 0, 1, 2, 1, 1, 1],
            ..Mesh::default()
        };
        let all = mesh.clone().with_normals(ALL);
        assert_eq!(all.normals, [Vec3::Y, Vec3::Y, Vec3::Y, Vec3::Z]);
        let sides = corner_normals(&mesh.with_normals(Normals::Given));
        assert_eq!(sides[..6], [Vec3::Y, Vec3::Y, Vec3::Y, Vec3::NEG_Y, Vec3::NEG_Y, Vec3::NEG_Y]);
    }

    #[test]
    fn a_fan_of_many_facets_around_one_point_takes_no_time() {
        let cone = bare(Builtin::Cone { radius: 1.0, height: 1.0, slices: 100_000, capped: true });
        let start = Instant::now();
        let smooth = cone.with_normals(Normals::Given);
        assert_eq!(smooth.validate(), Ok(()));
        // Linear: a tenth of a second. Quadratic: minutes.
        assert!(start.elapsed().as_secs() < 10);
    }

    fn place(x: u8, y: u8, z: u8) -> Vec3 {
        Vec3::new(x.into(), y.into(), z.into())
    }

    proptest! {
        #[test]
        fn any_valid_mesh_gets_unit_normals_and_keeps_its_corners(
            places in prop::collection::vec((0..3_u8, 0..3_u8, 0..2_u8), 1..8),
            faces in prop::collection::vec(prop::collection::vec(0..8_u32, 0..6), 0..10),
            scale in prop_oneof![Just(1.0_f32), Just(1e-40), Just(1e38)],
            crease in 0.0..3.2,
        ) {
            let count = places.len() as u32;
            let mut mesh = Mesh {
                positions: places.iter().map(|p| place(p.0, p.1, p.2) * scale).collect(),
                face_starts: vec![0],
                ..Mesh::default()
            };
            for face in &faces {
                mesh.corners.extend(face.iter().map(|corner| corner % count));
                mesh.face_starts.push(mesh.corners.len() as u32);
            }
            for normals in [Normals::Facet, Normals::Smooth { crease }] {
                let made = mesh.clone().with_normals(normals);
                prop_assert_eq!(made.validate(), Ok(()));
                prop_assert!(made.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-6));
                let places = |mesh: &Mesh| -> Vec<Vec3> {
                    mesh.corners.iter().map(|&corner| mesh.positions[corner as usize]).collect()
                };
                prop_assert_eq!(places(&made), places(&mesh));
            }
        }
    }
}
