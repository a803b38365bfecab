//! Data

pub(crate) mod bvh;
pub(crate) mod environment_map;
pub(crate) mod intensity_grid;
pub(crate) mod irradiance;
pub(crate) mod mipmap;
