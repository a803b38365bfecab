//! The first pass: clusters are culled, vertices projected, triangles put into the bins of their tiles.

pub(crate) mod bins;
pub(crate) mod chunk;
pub(crate) mod clip;
pub(crate) mod micro_triangles;
pub(crate) mod process;
pub(crate) mod screen;
pub(crate) mod sort;
