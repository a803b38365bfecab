//! Which triangle is nearest at each sample of a tile.

pub(crate) mod coverage_layers;
pub(crate) mod raster;
pub(crate) mod visible;
