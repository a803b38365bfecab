//! Polygon meshes, and what is computed from them: normals, tangents, subdivision.

mod normals;
mod polygon_mesh;
mod subdivide;
mod tangents;
pub(crate) mod topology;
pub(crate) mod triangulate;

pub use normals::Normals;
pub use polygon_mesh::{Bounds, Mesh, MeshError};
pub use subdivide::SubdivideError;
