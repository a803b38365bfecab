//! From meshes to clusters.

use core::ops::Range;

use glam::Vec3;
use glanz_scene::Mesh;

use super::placed::Placed;
use crate::prepare::data::geometry::{CLUSTER_TRIANGLES, CLUSTER_VERTICES, Cluster, Geometry, VERTEX_ALIGN};

/// Adds the triangles of a mesh; returns the range of the new clusters.
pub(crate) fn append(geometry: &mut Geometry, mesh: &Mesh, placed: &Placed, object: u32) -> Range<usize> {
    let first = geometry.clusters.len();
    let mut builder = Builder::new(&mut *geometry, mesh, placed, object);
    for face in 0..mesh.face_count() {
        let corners = mesh.face(face);
        for triangle in mesh.triangles_of(face) {
            // Sides opposite to the corners 0, 1, 2 of the triangle that are sides of the facet, too.
            let is_side = |from: usize, to: usize| {
                u8::from((triangle[from] as usize + 1) % corners.len() == triangle[to] as usize)
            };
            let edges = is_side(1, 2) | is_side(2, 0) << 1 | is_side(0, 1) << 2;
            builder.triangle(triangle.map(|place| corners[place as usize]), face as u32, edges);
        }
    }
    builder.finish_cluster();
    first..geometry.clusters.len()
}

/// How many vertices the clusters of a mesh have, counted without making them.
pub(crate) fn vertex_count(mesh: &Mesh) -> u64 {
    let mut used = vec![u32::MAX; mesh.positions.len()];
    let (mut count, mut cluster, mut vertices, mut triangles) = (0, 0, 0, 0);
    for corners in mesh.triangles() {
        if triangles == CLUSTER_TRIANGLES || vertices + 3 > CLUSTER_VERTICES {
            count += vertices.next_multiple_of(VERTEX_ALIGN) as u64;
            (cluster, vertices, triangles) = (cluster + 1, 0, 0);
        }
        triangles += 1;
        for corner in corners {
            let last = &mut used[corner as usize];
            vertices += usize::from(*last != cluster);
            *last = cluster;
        }
    }
    count + vertices.next_multiple_of(VERTEX_ALIGN) as u64
}

/// Position, normal and tangent of a vertex in the world.
struct InWorld {
    position: [f32; 3],
    normal: [f32; 3],
    tangent: Option<[f32; 4]>,
}

fn in_world(mesh: &Mesh, placed: &Placed, vertex: usize) -> InWorld {
    let normal = mesh.normals.get(vertex).copied().unwrap_or(Vec3::ZERO);
    InWorld {
        position: placed.position(mesh.positions[vertex]).as_vec3().to_array(),
        normal: placed.normal(normal).as_vec3().to_array(),
        tangent: mesh.tangents.get(vertex).map(|t| {
            let turned = placed.direction(t.truncate()).normalize_or_zero().as_vec3();
            let sign = if placed.mirrored { -t.w } else { t.w };
            [turned.x, turned.y, turned.z, sign]
        }),
    }
}

fn push_vertex(geometry: &mut Geometry, mesh: &Mesh, placed: &Placed, vertex: usize) {
    let InWorld { position, normal, tangent } = in_world(mesh, placed, vertex);
    geometry.sources.push(vertex as u32);
    for (array, value) in geometry.position.iter_mut().zip(position) {
        array.push(value);
    }
    geometry.normals.push(normal);
    let number = geometry.normals.len() - 1;
    push_optional(&mut geometry.uvs, number, mesh.uvs.get(vertex).map(|uv| uv.to_array()), [0.0; 2]);
    push_optional(&mut geometry.uvs2, number, mesh.uvs2.get(vertex).map(|uv| uv.to_array()), [0.0; 2]);
    push_optional(&mut geometry.colors, number, mesh.colors.get(vertex).map(|c| c.to_array()), [1.0; 4]);
    push_optional(&mut geometry.tangents, number, tangent, [1.0, 0.0, 0.0, 1.0]);
}

/// Puts a vertex that is there already where a new transform has it.
pub(crate) fn place_vertex(geometry: &mut Geometry, mesh: &Mesh, placed: &Placed, vertex: usize) {
    let InWorld { position, normal, tangent } = in_world(mesh, placed, geometry.sources[vertex] as usize);
    for (array, value) in geometry.position.iter_mut().zip(position) {
        array[vertex] = value;
    }
    geometry.normals[vertex] = normal;
    if let (Some(own), Some(tangent)) = (geometry.tangents.get_mut(vertex), tangent) {
        *own = tangent;
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
            push_vertex(self.geometry, self.mesh, self.placed, vertex);
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
        let mut cluster = Cluster {
            object: self.object,
            first_vertex: vertices.start as u32,
            vertices: vertices.len() as u32,
            first_triangle: triangles.start as u32,
            triangles: triangles.len() as u32,
            ..Cluster::default()
        };
        bound(geometry, &mut cluster);
        geometry.clusters.push(cluster);
        while !geometry.vertex_count().is_multiple_of(VERTEX_ALIGN) {
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
    repeat(&mut geometry.sources);
    repeat(&mut geometry.normals);
    repeat(&mut geometry.uvs);
    repeat(&mut geometry.uvs2);
    repeat(&mut geometry.colors);
    repeat(&mut geometry.tangents);
}

fn position(geometry: &Geometry, vertex: usize) -> Vec3 {
    Vec3::new(geometry.position[0][vertex], geometry.position[1][vertex], geometry.position[2][vertex])
}

/// Finds a cluster's sphere and cone.
pub(crate) fn bound(geometry: &Geometry, cluster: &mut Cluster) {
    let first = cluster.first_vertex as usize;
    let triangles = cluster.first_triangle as usize..(cluster.first_triangle + cluster.triangles) as usize;
    let (center, radius) = sphere(geometry, first..first + cluster.vertices as usize);
    let (axis, sine) = cone(geometry, first, triangles);
    (cluster.center, cluster.radius) = (center.to_array(), radius);
    (cluster.cone_axis, cluster.cone_sin) = (axis.to_array(), sine);
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
