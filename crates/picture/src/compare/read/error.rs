//! Why a picture cannot be read.

use std::io;
use std::path::PathBuf;

use glanz_color::FeatureOff;
use glanz_math::OverBudget;
use thiserror::Error;

use super::limits::{MAX_PIXELS, MAX_SIDE};

/// Why a picture could not be read.
#[derive(Debug, Error)]
pub enum ReadError {
    /// The file cannot be opened or read.
    #[error("{}: cannot read: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The file has more bytes than any picture within the limits needs.
    #[error("{}: expected a file of at most {limit} bytes, found more", path.display())]
    FileTooLarge {
        /// The file.
        path: PathBuf,
        /// The limit in bytes.
        limit: u64,
    },
    /// The file begins as neither format does.
    #[error("{name}: expected a PNG or OpenEXR picture, found a file that begins as neither")]
    Format {
        /// The file's name.
        name: String,
    },
    /// The format needs a feature that this build does not have.
    #[error("{name}: {off}")]
    FeatureOff {
        /// The file's name.
        name: String,
        /// The feature.
        off: FeatureOff,
    },
    /// The file is damaged, or of a kind that is not read.
    #[error("{name}: expected {expected}, found {found}")]
    Content {
        /// The file's name.
        name: String,
        /// What was expected.
        expected: String,
        /// What was found, and where.
        found: String,
    },
    /// The picture is larger than the limits allow.
    #[error(
        "{name}: expected at most {MAX_SIDE} pixels along each side and {MAX_PIXELS} in all, found {width}×{height}"
    )]
    TooLarge {
        /// The file's name.
        name: String,
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
    },
    /// The picture takes more memory than it may.
    #[error("{name}: {over}")]
    Memory {
        /// The file's name.
        name: String,
        /// What it takes.
        over: OverBudget,
    },
    /// A pixel has no value.
    #[error("{name}: expected finite values, found {value} at pixel {x}, {y}")]
    NotFinite {
        /// The file's name.
        name: String,
        /// Column from the left, from 0.
        x: usize,
        /// Row from the top, from 0.
        y: usize,
        /// The value.
        value: f32,
    },
}
