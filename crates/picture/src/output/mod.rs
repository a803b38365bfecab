//! Picture files to any stream: PNG and APNG; OpenEXR with the feature `exr`; GIF with the feature `gif`.
//!
//! A file on disk goes through [`write_atomically`], so that a full disk or an interrupted program
//! leaves what was there before.
//!
//! ```
//! use glanz_picture::output::{Effort, Format, Metadata, write_png8};
//!
//! assert_eq!(Format::from_path("picture.EXR")?, Format::Exr);
//! let mut file = std::io::Cursor::new(Vec::new());
//! write_png8(&mut file, (1, 1), &[255, 0, 0, 255], Effort::Fast, &Metadata::default())?;
//! assert!(file.into_inner().starts_with(b"\x89PNG"));
//! # Ok::<(), glanz_picture::output::OutputError>(())
//! ```

mod animation;
mod atomic;
mod error;
mod exr;
mod format;
mod gif;
mod inputs;
mod metadata;
mod own;
#[cfg(feature = "gif")]
mod palette;
mod picture_data;
mod png;
mod temporary;

pub use self::animation::{Animation, write_apng};
pub use self::atomic::{TargetFile, write_atomically, written_file};
pub use self::error::OutputError;
pub use self::exr::write_exr;
pub use self::format::Format;
pub use self::gif::write_gif;
pub use self::inputs::{keep_inputs, note_input};
pub use self::metadata::Metadata;
pub use self::own::is_own;
pub use self::picture_data::{PictureData, PictureKind};
pub use self::png::{Effort, write_png8, write_png16};
pub use self::temporary::remove_temporaries;
