//! Vertices and triangles, cut into clusters.
//!
//! A cluster is a run of up to 128 triangles with at most 256 vertices of its own, so that indices are bytes, a
//! cluster's vertices fit the first-level cache, and whole clusters can be culled by a sphere and a cone. Triangles
//! keep the order of the mesh.

/// The most triangles in a cluster.
pub const CLUSTER_TRIANGLES: usize = 128;
/// The most vertices in a cluster.
pub const CLUSTER_VERTICES: usize = 256;
/// Vertices of a cluster start at multiples of this, so that rows of lanes never straddle two.
pub const VERTEX_ALIGN: usize = 16;

/// A run of triangles with its own vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    pub center: [f32; 3],
    /// Radius of that sphere.
    pub radius: f32,
    /// Mean direction of its facet normals.
    pub cone_axis: [f32; 3],
    /// Sine of the half angle of the cone around `cone_axis` that holds all facet normals; above 1
    /// where there is no such cone narrower than a hemisphere.
    pub cone_sin: f32,
}

/// All vertices and triangles. Positions are relative to their object's anchor, along world axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The clusters, object after object.
    pub clusters: Vec<Cluster>,
    /// Position coordinates, one array each.
    pub position: [Vec<f32>; 3],
    /// Normals in the world, not normalised: inverse transpose times the mesh's.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates; empty if no object has them.
    pub uvs: Vec<[f32; 2]>,
    /// A second set of them; empty if no object has one.
    pub uvs2: Vec<[f32; 2]>,
    /// Vertex colours; empty if no object has them.
    pub colors: Vec<[f32; 4]>,
    /// Tangents in the world; empty if no object has them.
    pub tangents: Vec<[f32; 4]>,
    /// Triangles as vertex numbers within the cluster, counter-clockwise seen from outside.
    pub triangles: Vec<[u8; 3]>,
    /// The facet within its object of each triangle, and which of its edges are edges of the facet
    /// (bit i: the edge opposite to corner i).
    pub facets: Vec<(u32, u8)>,
    /// The vertex of its object's mesh that each vertex comes from.
    pub sources: Vec<u32>,
}

impl Geometry {
    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The number of vertices, those that fill clusters up to multiples of 16 included.
    pub fn vertex_count(&self) -> usize {
        self.sources.len()
    }
}
