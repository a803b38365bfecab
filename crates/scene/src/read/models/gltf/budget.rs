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

    /// How many times a byte counts where geometry is compressed: smooth surfaces take an eighth of a byte per triangle
    /// (2 million triangles of a wave by Draco's default: 258 kB), and a hundred bytes as meshes.
    const COMPRESSED: u64 = 16;
    /// The most memory that is allowed for that.
    const MOST_FOR_COMPRESSED: u64 = 1 << 30;

    /// The memory of a file of so many bytes, with its buffers.
    pub(super) fn new(bytes: u64, is_compressed: bool) -> Self {
        let plain = bytes.saturating_mul(Self::PER_BYTE);
        let more = match is_compressed {
            true => plain.saturating_mul(Self::COMPRESSED - 1).min(Self::MOST_FOR_COMPRESSED),
            false => 0,
        };
        let limit = plain.saturating_add(more).saturating_add(Self::FREE);
        Self { left: Cell::new(limit), limit }
    }

    /// The memory that is left.
    pub(super) fn left(&self) -> u64 {
        self.left.get()
    }

    /// Takes memory, if there is as much.
    pub(super) fn spend(&self, bytes: u64, file: &str, place: impl Fn() -> String) -> Result<(), ReadError> {
        self.check(bytes, file, place)?;
        self.left.set(self.left.get() - bytes);
        Ok(())
    }

    /// That there is as much memory.
    pub(super) fn check(&self, bytes: u64, file: &str, place: impl Fn() -> String) -> Result<(), ReadError> {
        let left = self.left.get();
        match bytes <= left {
            true => Ok(()),
            false => Err(ReadError::TooLarge {
                file: file.to_owned(),
                place: Place::Path(place()),
                limit: self.limit,
                unit: "bytes of memory for a file of this size",
                found: (self.limit - left).saturating_add(bytes),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_spent_is_counted_and_compressed_files_may_grow_more() {
        let place = || "meshes[0]".to_owned();
        let limit = |bytes: u64, is_compressed: bool| Budget::new(bytes, is_compressed).left();
        assert_eq!(limit(1000, false), (64 << 20) + 256_000);
        assert_eq!(limit(1000, true), (64 << 20) + 4_096_000);
        assert_eq!(limit(10 << 20, true), limit(10 << 20, false) + (1 << 30));
        assert_eq!(limit(u64::MAX, true), u64::MAX);
        let budget = Budget::new(0, false);
        let most = budget.left();
        assert!(budget.check(most, "f", place).is_ok() && budget.spend(most - 1, "f", place).is_ok());
        let error = budget.spend(2, "f", place).expect_err("there is 1 left").to_string();
        assert!(error.contains(&format!("at most {most} bytes of memory")), "{error}");
        assert!(error.contains(&format!("found {}", most + 1)) && budget.left() == 1, "{error}");
    }
}
