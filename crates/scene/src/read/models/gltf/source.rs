//! What the parts of the reader share.

use glanz_color::read::{Place, ReadError};

use super::budget::Budget;
use super::compression::{draco, meshopt};
use super::container::Buffers;
use super::json::Root;

/// What does not change while a file is read.
pub(super) struct Source<'a> {
    pub(super) file: &'a str,
    pub(super) root: &'a Root,
    pub(super) buffers: &'a Buffers<'a>,
    /// The views that are compressed.
    pub(super) views: &'a meshopt::Views,
    pub(super) budget: &'a Budget,
    /// What the primitive that is being read holds compressed.
    pub(super) draco: draco::Decoded,
}

impl Source<'_> {
    pub(super) fn malformed(
        &self,
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> ReadError {
        ReadError::malformed(self.file, place, expected, found)
    }
}
