//! What is printed: data on stdout, everything else on stderr.

mod colors;
pub mod document;
pub mod failure;
pub mod files;
pub mod preview;
pub mod scene_document;
mod stdout;
mod summary;
mod text;
pub mod timings;

pub use glanz_plot::number;

pub use self::stdout::{Format, FormatArgs, bytes, json, note, notes, text};
pub use self::summary::Summary;
pub use self::text::{decimals, finite, fixed, line, wavelength};
