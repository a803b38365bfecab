//! From meshes and objects to clusters in world coordinates.

pub(crate) mod closed;
pub(crate) mod clusters;
pub(crate) mod facets;
pub(crate) mod objects;
pub(crate) mod placed;
pub(crate) mod polygons;
