//! From the tables of a scene file to a scene.

mod builder;
mod camera;
mod files;
mod from_library;
mod layers;
mod lights;
mod lobes;
mod materials;
mod meshes;
mod objects;
mod place;
mod scene;
mod spectra;
mod textures;
mod units;

pub(super) use builder::Builder;
pub(super) use spectra::air;
