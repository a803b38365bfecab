//! The whole of a scene: its parts, how they are put together and found again, and a number for all of it.

pub(crate) mod access;
mod compose;
pub(crate) mod hash;
mod parts;

pub use access::{Key, LookupError};
pub use parts::{Object, Scene};
