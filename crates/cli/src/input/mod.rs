//! Words of the command line that name things: spectra, lobes, variations, bounds.

mod column;
pub(crate) mod dyes;
pub(crate) mod lobes;
pub(crate) mod media;
pub(crate) mod models;
pub(crate) mod objects;
pub(crate) mod picture;
pub(crate) mod resolution;
pub(crate) mod shader_text;
pub(crate) mod spectra;
mod tables;
pub(crate) mod thresholds;
pub(crate) mod vary;
pub(crate) mod whole_file;
