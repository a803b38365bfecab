//! Vertex normals.

/// Where the normals of a mesh come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Normals {
    /// As the mesh has them; smooth where it has none.
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
