//! Why pictures cannot be compared.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::Metric;
use super::read::{MAX_PIXELS, MAX_SIDE};

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

/// Why two pictures could not be compared.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum CompareError {
    /// The sizes differ.
    #[error(
        "expected two pictures of one size, found {}×{} and {}×{} pixels",
        reference.0, reference.1, test.0, test.1
    )]
    Sizes {
        /// Width and height of the reference.
        reference: (usize, usize),
        /// Width and height of the other.
        test: (usize, usize),
    },
    /// There are fewer or more values than the size says, or none.
    #[error("expected {expected} values per channel, at least one, found {found}")]
    Values {
        /// Width times height.
        expected: usize,
        /// Values of the first channel that has another number.
        found: usize,
    },
    /// The metric works on what a screen shows only.
    #[error("{} is defined for sRGB codes, but both pictures hold light without bounds", metric.name())]
    CodesOnly {
        /// The metric.
        metric: Metric,
    },
    /// The number of pixels per degree is out of bounds.
    #[error("expected {} to {} pixels per degree, found {found}", range.0, range.1)]
    PixelsPerDegree {
        /// The bounds.
        range: (f64, f64),
        /// What was given.
        found: f64,
    },
}
