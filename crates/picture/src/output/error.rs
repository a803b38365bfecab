//! Why a picture file could not be written.

use std::io;
use std::path::PathBuf;

use glanz_color::FeatureOff;
use thiserror::Error;

/// Why a picture file could not be written.
#[derive(Debug, Error)]
pub enum OutputError {
    /// The name ends in nothing that a format is known for.
    #[error("{}: the name must end in .png, .exr, .gif or .apng", path.display())]
    UnknownExtension {
        /// The name.
        path: PathBuf,
    },
    /// The file cannot be made, written or put in its place.
    #[error("{}: cannot {action}: {source}", path.display())]
    File {
        /// The file that was asked for.
        path: PathBuf,
        /// What failed.
        action: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// The file is one of those that were read ([`keep_inputs`](super::keep_inputs)).
    #[error("{}: this file is read: what is written there would replace it; choose another name", path.display())]
    Input {
        /// The file that was asked for.
        path: PathBuf,
    },
    /// A stream did not take the bytes. For files the message names the path.
    #[error("{0}")]
    Stream(#[from] io::Error),
    /// The format cannot hold this picture, or a text of the metadata.
    #[error("this picture cannot be written as {format}: {message}")]
    Encode {
        /// The format's name.
        format: &'static str,
        /// What was expected and what was found.
        message: String,
    },
    /// The format needs a feature that this build does not have.
    #[error(transparent)]
    FeatureOff(#[from] FeatureOff),
    /// The channels are not what the format is for.
    #[error(transparent)]
    Channels(#[from] crate::ChannelError),
    /// There are more or fewer values than the size says.
    #[error("a picture of {width}×{height} pixels needs {expected} values, but there are {found}")]
    Size {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// Values that it needs.
        expected: usize,
        /// Values that there are.
        found: usize,
    },
}

/// Whether there are `channels` values per pixel.
pub(super) fn check_size(
    width: usize,
    height: usize,
    channels: usize,
    found: usize,
) -> Result<(), OutputError> {
    let expected = width * height * channels;
    if found == expected { Ok(()) } else { Err(OutputError::Size { width, height, expected, found }) }
}
