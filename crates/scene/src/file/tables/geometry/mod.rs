//! The keys of meshes and objects, and of where they are.

pub(crate) mod meshes;
pub(crate) mod objects;
pub(crate) mod place;
pub(crate) mod turn;
