//! How much memory a model may take.

use std::cell::Cell;

use glanz_color::read::{Place, ReadError};

/// The memory that a model may still take. Nodes may use meshes, and primitives accessors, many
/// times over: without a limit a small file could fill any memory.
pub(super) struct Budget {
    left: Cell<u64>,
    limit: u64,
}

impl Budget {
    /// Memory that is always allowed.
    const FREE: u64 = 64 << 20;
    /// Memory per byte of the file and its buffers. Honest files need up to 12: bytes that become
    /// floats; the rest is for meshes that are used many times.
    const PER_BYTE: u64 = 256;

    pub(super) fn new(bytes: u64) -> Self {
        let limit = bytes.saturating_mul(Self::PER_BYTE).saturating_add(Self::FREE);
        Self { left: Cell::new(limit), limit }
    }

    /// The memory that is left.
    pub(super) fn left(&self) -> u64 {
        self.left.get()
    }

    pub(super) fn spend(&self, bytes: u64, file: &str, place: impl Fn() -> String) -> Result<(), ReadError> {
        let left = self.left.get();
        match left.checked_sub(bytes) {
            Some(left) => {
                self.left.set(left);
                Ok(())
            }
            None => Err(ReadError::TooLarge {
                file: file.to_owned(),
                place: Place::Path(place()),
                limit: self.limit,
                unit: "bytes of memory for a file of this size",
                found: (self.limit - left).saturating_add(bytes),
            }),
        }
    }
}
