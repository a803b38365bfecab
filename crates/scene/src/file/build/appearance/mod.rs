//! Materials: lobes, layers, textures.

mod brdfs;
pub(super) mod from_library;
mod layer_weights;
pub(super) mod layers;
pub(super) mod lobes;
pub(super) mod materials;
mod measured;
mod parameters;
pub(super) mod textures;
