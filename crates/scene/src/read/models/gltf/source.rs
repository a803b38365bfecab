//! What the parts of the reader share.

use glanz_color::read::{Place, ReadError};

use super::container::Buffers;
use super::json::{Buffer, Primitive, Root};

/// What is said of geometry that is compressed.
pub(super) fn compressed_error(file: &str, place: Place, extension: &str) -> ReadError {
    let found = format!("geometry compressed by {extension}");
    ReadError::unsupported(file, place, "geometry that is not compressed", found)
}

impl Buffer {
    /// Whether it has no bytes: it stands for what is compressed elsewhere.
    pub(super) fn is_placeholder(&self) -> bool {
        self.uri.is_none() && self.extensions.meshopt.is_some()
    }
}

/// What does not change while a file is read.
pub(super) struct Source<'a> {
    pub(super) file: &'a str,
    pub(super) root: &'a Root,
    pub(super) buffers: &'a Buffers<'a>,
}

impl Source<'_> {
    /// That the positions of a primitive are not compressed: an accessor without a view would be zeros.
    pub(super) fn check_compression(
        &self,
        primitive: &Primitive,
        position: usize,
        path: &str,
    ) -> Result<(), ReadError> {
        let view = self.root.accessors.get(position).and_then(|accessor| accessor.buffer_view);
        let compressed = match view {
            None if primitive.extensions.draco.is_some() => "KHR_draco_mesh_compression",
            Some(view) if self.is_placeholder(view) => "EXT_meshopt_compression",
            _ => return Ok(()),
        };
        Err(compressed_error(self.file, Place::Path(path.to_owned()), compressed))
    }

    /// Whether a view holds nothing but the place of what another one holds compressed.
    fn is_placeholder(&self, view: usize) -> bool {
        self.root.buffer_views.get(view).is_some_and(|view| {
            let buffer = self.root.buffers.get(view.buffer);
            view.extensions.meshopt.is_some() && buffer.is_some_and(|buffer| buffer.is_placeholder())
        })
    }

    pub(super) fn malformed(
        &self,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> ReadError {
        ReadError::malformed(self.file, place, expected, found)
    }
}
