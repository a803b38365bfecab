//! Picture files: PNG, OpenEXR, GIF and APNG, to any stream.
//!
//! A file on disk goes through [`write_atomically`], so that a full disk or an interrupted program
//! leaves what was there before.

mod animation;
mod atomic;
mod error;
mod exr;
mod format;
mod metadata;
mod png;

pub use self::animation::{Animation, write_apng, write_gif};
pub use self::atomic::{TargetFile, write_atomically};
pub use self::error::OutputError;
pub use self::exr::write_exr;
pub use self::format::Format;
pub use self::metadata::Metadata;
pub use self::png::{Effort, write_png8, write_png16};
