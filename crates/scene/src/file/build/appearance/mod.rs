//! Materials: lobes, layers, textures.

mod brdfs;
pub(super) mod from_library;
pub(super) mod layers;
pub(super) mod lobes;
pub(super) mod materials;
mod parameters;
pub(super) mod textures;
