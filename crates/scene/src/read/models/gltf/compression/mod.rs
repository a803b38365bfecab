//! Geometry that a file holds compressed.

pub(super) mod draco;
pub(super) mod meshopt;

use super::json::Root;

/// Whether a file has such geometry.
pub(super) fn is_in(root: &Root) -> bool {
    let mut primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    primitives.any(|primitive| primitive.extensions.draco.is_some())
        || !root.buffers_of_compressed_views().is_empty()
}

#[cfg(test)]
pub(super) mod tests;
