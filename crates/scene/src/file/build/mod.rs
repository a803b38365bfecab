//! From the tables of a scene file to a scene.

mod appearance;
mod builder;
mod camera;
mod dyes;
mod eye;
mod files;
mod geometry;
mod lights;
mod media;
mod program;
mod remarks;
mod scene;
mod spectra;
mod units;

pub(super) use builder::Builder;
pub(super) use media::air;
