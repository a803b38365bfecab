//! The keys of materials: lobes, layers, textures.

pub(crate) mod layer_weights;
pub(crate) mod layers;
pub(crate) mod lobes;
pub(crate) mod materials;
pub(crate) mod measured;
mod set_aside;
pub(crate) mod shapes;
pub(crate) mod textures;
