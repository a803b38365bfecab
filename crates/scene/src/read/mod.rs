//! Readers of the formats of others: glTF 2.0 (`.gltf`, `.glb`), Wavefront OBJ with MTL, PLY, STL.
//!
//! Every reader is total: whatever the bytes are, it returns a [`Model`] or one [`ReadError`] that
//! names the file, the place and what was expected there. It never allocates by what a file claims,
//! only by what it holds, and it follows references only inside the folder of [`ReadOptions::root`].
//!
//! Beside models there are textures, sensors, the profiles of luminaires (LM-63, EULUMDAT) and pictures of
//! environments (Radiance HDR, OpenEXR), each with a function of its own.
//!
//! What a reader left out or could only approximate is told in [`Model::notes`].
//!
//! ```
//! use glanz_scene::read::{Format, NoFiles, ReadOptions, read_model_bytes};
//!
//! let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
//! let model = read_model_bytes(text, Format::Obj, "triangle.obj", &NoFiles, &ReadOptions::default())?;
//! assert_eq!((model.meshes.len(), model.triangle_count()), (1, 1));
//! # Ok::<(), glanz_scene::read::ReadError>(())
//! ```

mod environment;
mod jpeg;
mod models;
mod notes;
mod options;
mod profile;
mod resolve;
mod sensor;
mod texture;

pub use environment::read_environment;
pub use glanz_color::read::{Place, ReadError};
pub use models::{Format, Model, read_model, read_model_bytes};
pub use options::ReadOptions;
pub use profile::{MAX_PROFILE_BYTES, read_profile};
pub use resolve::{FolderFiles, NoFiles, ResolveError, Resolver, resolve};
pub use sensor::read_sensor;
pub use texture::{read_texture, remark_of_texture};

#[cfg(test)]
mod tests;
