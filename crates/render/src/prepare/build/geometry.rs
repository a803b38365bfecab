//! Vertices and triangles, cut into clusters.
//!
//! A cluster is a run of up to 128 triangles with at most 256 vertices of its own, so that indices
//! are bytes, a cluster's vertices fit the first-level cache, and whole clusters can be culled by
//! a sphere and a cone. Triangles keep the order of the mesh.

use core::ops::Range;

use glam::{DMat3, DMat4, DVec3, Vec3};
use glanz_scene::{Bounds, Mesh};

/// The most triangles in a cluster.
pub const CLUSTER_TRIANGLES: usize = 128;
const CLUSTER_VERTICES: usize = 256;
/// Vertices of a cluster start at multiples of this, so that rows of lanes never straddle two.
const ALIGN: usize = 16;

/// A run of triangles with its own vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cluster {
    /// Index of its object.
    pub object: u32,
    /// First vertex, a multiple of 16.
    pub first_vertex: u32,
    /// Number of vertices.
    pub vertices: u32,
    /// First triangle.
    pub first_triangle: u32,
    /// Number of triangles.
    pub triangles: u32,
    /// Centre of a sphere around it, relative to the object's anchor.
    pub center: Vec3,
    /// Radius of that sphere.
    pub radius: f32,
    /// Mean direction of its facet normals.
    pub cone_axis: Vec3,
    /// Sine of the half angle of the cone around `cone_axis` that holds all facet normals; above 1
    /// where there is no such cone narrower than a hemisphere.
    pub cone_sin: f32,
}

/// All vertices and triangles. Positions are relative to their object's anchor, along world axes.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// The clusters, object after object.
    pub clusters: Vec<Cluster>,
    /// Position coordinates, one array each.
    pub position: [Vec<f32>; 3],
    /// Normals in the world, not normalised: inverse transpose times the mesh's.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates; empty if no object has them.
    pub uvs: Vec<[f32; 2]>,
    /// Vertex colours; empty if no object has them.
    pub colors: Vec<[f32; 4]>,
    /// Tangents in the world; empty if no object has them.
    pub tangents: Vec<[f32; 4]>,
    /// Triangles as vertex numbers within the cluster, counter-clockwise seen from outside.
    pub triangles: Vec<[u8; 3]>,
    /// The facet within its object of each triangle, and which of its edges are edges of the facet
    /// (bit i: the edge opposite to corner i).
    pub facets: Vec<(u32, u8)>,
}

/// A mesh put into the world: relative to an anchor, so that `f32` keeps its precision far from the
/// origin.
pub struct Placed {
    /// The point that positions are relative to.
    pub anchor: DVec3,
    /// Box of the vertices relative to the anchor.
    pub bounds: [DVec3; 2],
    /// Whether the transform mirrors, so that triangles change their winding.
    pub mirrored: bool,
    linear: DMat3,
    offset: DVec3,
    normal_matrix: DMat3,
}

impl Placed {
    /// Puts `mesh` into the world by an affine transform.
    pub fn new(mesh: &Mesh, transform: DMat4) -> Self {
        let linear = DMat3::from_mat4(transform);
        let translation = transform.w_axis.truncate();
        let determinant = linear.determinant();
        let mut bounds = Bounds::EMPTY;
        for position in &mesh.positions {
            bounds.include(linear * position.as_dvec3());
        }
        let center = if bounds.is_empty() { DVec3::ZERO } else { bounds.center() };
        let bounds =
            if bounds.is_empty() { [DVec3::ZERO; 2] } else { [bounds.min - center, bounds.max - center] };
        // A transform that flattens has no inverse; its cofactors still give the normal of the plane.
        let normal_matrix = cofactors(linear) * if determinant < 0.0 { -1.0 } else { 1.0 };
        Self {
            anchor: translation + center,
            bounds,
            mirrored: determinant < 0.0,
            linear,
            offset: -center,
            normal_matrix: normal_matrix * scale_to_unit(normal_matrix),
        }
    }

    /// A mesh position in the world, relative to the anchor.
    pub fn position(&self, p: Vec3) -> DVec3 {
        self.linear * p.as_dvec3() + self.offset
    }
    /// A mesh normal in the world, not normalised.
    pub fn normal(&self, n: Vec3) -> DVec3 {
        self.normal_matrix * n.as_dvec3()
    }
    /// A mesh direction in the world, not normalised.
    pub fn direction(&self, t: Vec3) -> DVec3 {
        self.linear * t.as_dvec3()
    }
}

/// The matrix of cofactors: the determinant times the inverse transpose.
fn cofactors(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis))
}

/// A factor that brings the matrix to ordinary size, so that `f32` normals neither vanish nor overflow.
fn scale_to_unit(m: DMat3) -> f64 {
    let size = m.x_axis.length().max(m.y_axis.length()).max(m.z_axis.length());
    if size > 0.0 && size.is_finite() { 1.0 / size } else { 1.0 }
}

impl Geometry {
    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Adds the triangles of a mesh; returns the range of the new clusters.
    pub(crate) fn append(&mut self, mesh: &Mesh, placed: &Placed, object: u32) -> Range<usize> {
        let first = self.clusters.len();
        let mut builder = Builder::new(self, mesh, placed, object);
        for face in 0..mesh.face_count() {
            let corners = mesh.face(face);
            for i in 2..corners.len() {
                // Edges opposite to corners 0, 1, 2 of the fan triangle: the outer one always is an
                // edge of the facet, the others only at the ends of the fan.
                let edges = 1 | u8::from(i == corners.len() - 1) << 1 | u8::from(i == 2) << 2;
                builder.triangle([corners[0], corners[i - 1], corners[i]], face as u32, edges);
            }
        }
        builder.finish_cluster();
        first..self.clusters.len()
    }

    fn vertex_count(&self) -> usize {
        self.position[0].len()
    }

    fn push_vertex(&mut self, mesh: &Mesh, placed: &Placed, vertex: usize) {
        let p = placed.position(mesh.positions[vertex]).as_vec3().to_array();
        for (array, value) in self.position.iter_mut().zip(p) {
            array.push(value);
        }
        let normal = mesh.normals.get(vertex).copied().unwrap_or(Vec3::ZERO);
        self.normals.push(placed.normal(normal).as_vec3().to_array());
        let number = self.normals.len() - 1;
        push_optional(&mut self.uvs, number, mesh.uvs.get(vertex).map(|uv| uv.to_array()), [0.0; 2]);
        push_optional(&mut self.colors, number, mesh.colors.get(vertex).map(|c| c.to_array()), [1.0; 4]);
        let tangent = mesh.tangents.get(vertex).map(|t| {
            let turned = placed.direction(t.truncate()).normalize_or_zero().as_vec3();
            let sign = if placed.mirrored { -t.w } else { t.w };
            [turned.x, turned.y, turned.z, sign]
        });
        push_optional(&mut self.tangents, number, tangent, [1.0, 0.0, 0.0, 1.0]);
    }
}

/// Appends to an attribute array that exists only once some vertex has the attribute.
fn push_optional<T: Copy>(array: &mut Vec<T>, number: usize, value: Option<T>, filler: T) {
    if value.is_some() || !array.is_empty() {
        array.resize(number, filler);
        array.push(value.unwrap_or(filler));
    }
}

/// Cuts a mesh into clusters while its triangles come in.
struct Builder<'a> {
    geometry: &'a mut Geometry,
    mesh: &'a Mesh,
    placed: &'a Placed,
    object: u32,
    /// For each mesh vertex: the cluster that last used it, and its number there.
    used: Vec<(u32, u8)>,
    first_vertex: usize,
    first_triangle: usize,
}

impl<'a> Builder<'a> {
    fn new(geometry: &'a mut Geometry, mesh: &'a Mesh, placed: &'a Placed, object: u32) -> Self {
        let used = vec![(u32::MAX, 0); mesh.positions.len()];
        let (first_vertex, first_triangle) = (geometry.vertex_count(), geometry.triangles.len());
        Self { geometry, mesh, placed, object, used, first_vertex, first_triangle }
    }

    fn triangle(&mut self, mut corners: [u32; 3], facet: u32, mut edges: u8) {
        if self.placed.mirrored {
            corners.swap(1, 2);
            edges = edges & 1 | (edges & 2) << 1 | (edges & 4) >> 1;
        }
        let vertices = self.geometry.vertex_count() - self.first_vertex;
        let triangles = self.geometry.triangles.len() - self.first_triangle;
        if triangles == CLUSTER_TRIANGLES || vertices + 3 > CLUSTER_VERTICES {
            self.finish_cluster();
        }
        let local = corners.map(|corner| self.local(corner as usize));
        self.geometry.triangles.push(local);
        self.geometry.facets.push((facet, edges));
    }

    fn local(&mut self, vertex: usize) -> u8 {
        let cluster = self.geometry.clusters.len() as u32;
        if self.used[vertex].0 != cluster {
            let number = (self.geometry.vertex_count() - self.first_vertex) as u8;
            self.used[vertex] = (cluster, number);
            self.geometry.push_vertex(self.mesh, self.placed, vertex);
        }
        self.used[vertex].1
    }

    fn finish_cluster(&mut self) {
        let geometry = &mut *self.geometry;
        let triangles = self.first_triangle..geometry.triangles.len();
        if triangles.is_empty() {
            return;
        }
        let vertices = self.first_vertex..geometry.vertex_count();
        let (center, radius) = sphere(geometry, vertices.clone());
        let (cone_axis, cone_sin) = cone(geometry, vertices.start, triangles.clone());
        geometry.clusters.push(Cluster {
            object: self.object,
            first_vertex: vertices.start as u32,
            vertices: vertices.len() as u32,
            first_triangle: triangles.start as u32,
            triangles: triangles.len() as u32,
            center,
            radius,
            cone_axis,
            cone_sin,
        });
        while !geometry.vertex_count().is_multiple_of(ALIGN) {
            repeat_last_vertex(geometry);
        }
        self.first_vertex = geometry.vertex_count();
        self.first_triangle = geometry.triangles.len();
    }
}

fn repeat_last_vertex(geometry: &mut Geometry) {
    fn repeat<T: Copy>(array: &mut Vec<T>) {
        if let Some(&last) = array.last() {
            array.push(last);
        }
    }
    geometry.position.iter_mut().for_each(repeat);
    repeat(&mut geometry.normals);
    repeat(&mut geometry.uvs);
    repeat(&mut geometry.colors);
    repeat(&mut geometry.tangents);
}

fn position(geometry: &Geometry, vertex: usize) -> Vec3 {
    Vec3::new(geometry.position[0][vertex], geometry.position[1][vertex], geometry.position[2][vertex])
}

/// A sphere around the vertices: the centre of their box, and the greatest distance from it.
fn sphere(geometry: &Geometry, vertices: Range<usize>) -> (Vec3, f32) {
    let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for vertex in vertices.clone() {
        min = min.min(position(geometry, vertex));
        max = max.max(position(geometry, vertex));
    }
    let center = (min + max) * 0.5;
    let farthest =
        vertices.map(|v| (position(geometry, v) - center).length_squared()).fold(0.0f32, f32::max).sqrt();
    (center, farthest * 1.000_01)
}

/// A cone around the facet normals: axis and sine of the half angle, 2 where it is not narrow.
fn cone(geometry: &Geometry, first_vertex: usize, triangles: Range<usize>) -> (Vec3, f32) {
    let normal = |triangle: usize| {
        let [a, b, c] = geometry.triangles[triangle].map(|v| position(geometry, first_vertex + v as usize));
        (b - a).cross(c - a).normalize_or_zero()
    };
    let axis = triangles.clone().map(normal).sum::<Vec3>().normalize_or_zero();
    let least =
        triangles.map(normal).filter(|n| *n != Vec3::ZERO).map(|n| n.dot(axis)).fold(1.0f32, f32::min);
    // Below a cosine of 0.1 the cone is nearly a hemisphere and culls nothing.
    let sine = if axis == Vec3::ZERO || least < 0.1 { 2.0 } else { (1.0 - least * least).max(0.0).sqrt() };
    (axis, sine)
}
