//! Meshes and objects, and where they are.

pub(super) mod meshes;
pub(super) mod objects;
pub(super) mod place;
