//! The whole of a scene: its parts, how they are put together and found again.

pub(crate) mod access;
mod compose;
mod parts;

pub use access::{Key, LookupError};
pub use parts::{Object, Scene};
