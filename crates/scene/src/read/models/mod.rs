//! Readers of models: a file or folder for each format, and what they share.

mod anchor;
mod context;
mod faces;
mod finish;
mod format;
pub(super) mod gltf;
mod lines;
mod model;
pub(super) mod obj;
pub(super) mod ply;
mod read_model;
pub(super) mod stl;

pub use format::Format;
pub use model::Model;
pub use read_model::{read_model, read_model_bytes};
