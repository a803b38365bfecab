//! The tables of a scene file, as serde and the JSON Schema see them: data alone.

pub(crate) mod appearance;
pub(crate) mod camera;
pub(crate) mod colors;
pub(crate) mod dyes;
pub(crate) mod eye;
pub(crate) mod geometry;
pub(crate) mod lights;
pub(crate) mod media;
pub(crate) mod profile;
pub(crate) mod program;
pub(crate) mod sampled;
pub(crate) mod scene;
pub(crate) mod settings;
pub(crate) mod spectra_files;
pub(crate) mod table;
pub(crate) mod values;
