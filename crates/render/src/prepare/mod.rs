//! From a scene to plain arrays that a back end can loop over or upload.
//!
//! [`prepare`] does all work with wavelengths; what leaves is [`data`]: geometry, lobe shapes, the geometry of lights
//! and the tint table. [`Prepared::update`] redoes only what changed of the scene.
//!
//! ```
//! use glanz_render::prepare::{Change, PrepareOptions, prepare};
//! use glanz_scene::{LightKind, Scene};
//!
//! let mut scene = glanz_scene::file::parse_str("[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]", "".as_ref(), &Default::default())?.scene;
//! let mut prepared = prepare(&scene, &PrepareOptions::default())?;
//! if let LightKind::Point { position, .. } = &mut scene.lights[0].kind {
//!     position.x = -1.0;
//! }
//! prepared.update(&scene, &[Change::Light(0)])?;
//! assert_eq!(prepared.lights.len(), 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod build;
mod change;
pub(crate) mod color;
pub mod data;
mod options;
pub(crate) mod program_values;
mod source;
mod update;

pub(crate) use build::check::check_background;
pub use build::memory::check_memory;
pub(crate) use build::memory::memory_beside;
pub use build::prepare;
pub use build::programs::ProgramError;
pub(crate) use build::programs::{compiled as compiled_program, traced_pair};
pub use change::Change;
pub use color::observation::{Observation, ObservationError, SCREEN_WHITE_CD_M2};
pub use color::white::OwnWhite;
pub use data::*;
pub use options::{PrepareError, PrepareOptions};
