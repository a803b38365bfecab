//! Geometry that a file holds compressed.

pub(super) mod draco;
pub(super) mod meshopt;

#[cfg(test)]
pub(super) mod tests;
