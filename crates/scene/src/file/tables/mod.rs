//! The tables of a scene file, as serde and the JSON Schema see them: data alone.

pub(crate) mod camera;
pub(crate) mod colors;
pub(crate) mod layer_weights;
pub(crate) mod layers;
pub(crate) mod lights;
pub(crate) mod lobes;
pub(crate) mod materials;
pub(crate) mod meshes;
pub(crate) mod objects;
pub(crate) mod place;
pub(crate) mod profile;
pub(crate) mod sampled;
pub(crate) mod scene;
pub(crate) mod settings;
pub(crate) mod table;
pub(crate) mod textures;
pub(crate) mod turn;
pub(crate) mod values;
