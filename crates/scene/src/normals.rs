//! Vertex normals.

use core::f64::consts::PI;
use std::collections::HashMap;

use glam::{DVec3, Vec3};

use crate::{
    Mesh,
    topology::{Welded, for_each_edge},
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
        sum.try_normalize().unwrap_or(DVec3::ZERO)
    }

    /// The mesh whose vertices are those of this one named by `sources`, without normals and
    /// tangents and with no faces.
    fn vertices_from(&self, sources: &[u32]) -> Self {
        fn pick<T: Copy>(from: &[T], sources: &[u32]) -> Vec<T> {
            if from.is_empty() { Vec::new() } else { sources.iter().map(|&i| from[i as usize]).collect() }
        }
        Self {
            name: self.name.clone(),
            positions: pick(&self.positions, sources),
            uvs: pick(&self.uvs, sources),
            colors: pick(&self.colors, sources),
            ..Self::default()
        }
    }
}

fn with_facet_normals(mesh: Mesh) -> Mesh {
    let mut flat = mesh.vertices_from(&mesh.corners);
    flat.normals.reserve_exact(mesh.corners.len());
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

/// For each corner the first corner (in file order) of the group that it shares its normal with.
fn corner_groups(mesh: &Mesh, points: &[u32], facets: &[DVec3], crease: f64) -> Vec<u32> {
    let mut groups = Groups::new(mesh.corners.len());
    let point_count = points.iter().max().map_or(0, |&p| p as usize + 1);
    if crease >= PI {
        join_all_at_points(mesh, points, point_count, &mut groups);
    } else {
        join_over_edges(mesh, points, point_count, facets, crease, &mut groups);
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
    facets: &[DVec3],
    crease: f64,
    groups: &mut Groups,
) {
    let least_cos = libm::cos((crease.max(0.0) + CREASE_SLACK).min(PI));
    // For each side of each face: its end points, its face, its two corners.
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
    for_each_edge(&sides, point_count, |[a, b], members| {
        if a == b {
            return;
        }
        // Where more than two facets meet, each is compared with its next in file order.
        for pair in members.windows(2) {
            let [one, two] = [pair[0] as usize, pair[1] as usize];
            let [(face, end), (other, other_end)] = [owners[one], owners[two]];
            let cos = facets[face as usize].dot(facets[other as usize]);
            let degenerate = facets[face as usize] == DVec3::ZERO || facets[other as usize] == DVec3::ZERO;
            if degenerate || cos < least_cos {
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
    const NONE: u32 = u32::MAX;
    let mut sources: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    let mut normals = vec![Vec3::ZERO; sources.len()];
    // Which group each vertex serves, and the twins for the others.
    let mut served = vec![NONE; sources.len()];
    let mut twins: HashMap<(u32, u32), u32> = HashMap::new();
    let mut corners = Vec::with_capacity(mesh.corners.len());
    for (face, &facet) in mesh.faces().zip(facets) {
        for &vertex in face {
            let group = groups[corners.len()];
            let sum = sums[group as usize];
            let own = &mut served[vertex as usize];
            let mut user = vertex;
            if sum.length_squared() < LEAST_SUM * LEAST_SUM {
                // No facet with an area, or two back to back: whatever the vertex has will do.
                if *own == NONE && normals[vertex as usize] == Vec3::ZERO {
                    normals[vertex as usize] = facet.as_vec3();
                }
            } else if *own == NONE || *own == group {
                *own = group;
                normals[vertex as usize] = sum.normalize().as_vec3();
            } else {
                user = *twins.entry((vertex, group)).or_insert_with(|| {
                    sources.push(vertex);
                    normals.push(sum.normalize().as_vec3());
                    sources.len() as u32 - 1
                });
            }
            corners.push(user);
        }
    }
    let mut smooth = mesh.vertices_from(&sources);
    smooth.normals = normals.into_iter().map(usable).collect();
    smooth.corners = corners;
    smooth.face_starts = mesh.face_starts;
    smooth
}

/// +Z in the place of no normal.
fn usable(normal: Vec3) -> Vec3 {
    if normal == Vec3::ZERO { Vec3::Z } else { normal }
}

/// Disjoint sets of corners. The root of each is its first member.
struct Groups(Vec<u32>);

impl Groups {
    fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    fn root(&mut self, mut member: u32) -> u32 {
        loop {
            let parent = self.0[member as usize];
            if parent == member {
                return member;
            }
            // Halving the path keeps later searches short.
            self.0[member as usize] = self.0[parent as usize];
            member = parent;
        }
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    fn into_roots(mut self) -> Vec<u32> {
        for member in 0..self.0.len() as u32 {
            // Parents come before their children, so one step is enough here.
            self.0[member as usize] = self.0[self.0[member as usize] as usize];
        }
        self.0
    }
}
