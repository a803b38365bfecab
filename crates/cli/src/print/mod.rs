//! What is printed: data on stdout, everything else on stderr.

mod colors;
pub(crate) mod document;
pub(crate) mod failure;
pub(crate) mod files;
mod matrices;
pub(crate) mod preview;
pub(crate) mod remarked;
pub(crate) mod scene_document;
mod sixel;
mod stdout;
mod summary;
mod text;
pub(crate) mod timings;
mod vertices;

pub(crate) use glanz_plot::number;

pub(crate) use self::stdout::{Format, FormatArgs, bytes, json, note, notes, text};
pub(crate) use self::summary::Summary;
pub(crate) use self::text::{decimals, finite, fixed, line, wavelength};
