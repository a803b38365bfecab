//! The parts and channels of an OpenEXR file, and what can go wrong with them.

use thiserror::Error;

use super::Attribute;
use crate::FeatureOff;
use crate::models::RgbSpace;

/// Why an OpenEXR file could not be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ExrReadError {
    /// The content breaks the rules of the format.
    #[error("expected {expected}, found {found}")]
    Malformed {
        /// What should have been there.
        expected: String,
        /// What is there.
        found: String,
    },
    /// The crate was built without its feature `exr`.
    #[error(transparent)]
    FeatureOff(#[from] FeatureOff),
    /// The content is valid but of a kind that is not read.
    #[error("expected {expected}, found {found}, which is not supported")]
    Unsupported {
        /// What could have been read.
        expected: &'static str,
        /// What is there.
        found: String,
    },
}

#[cfg(feature = "exr")]
impl ExrReadError {
    pub(super) fn malformed(expected: impl Into<String>, found: impl ToString) -> Self {
        Self::Malformed { expected: expected.into(), found: found.to_string() }
    }

    pub(super) fn unsupported(expected: &'static str, found: impl ToString) -> Self {
        Self::Unsupported { expected, found: found.to_string() }
    }
}

/// A part of an OpenEXR file.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrPart {
    /// Its name.
    pub name: Option<String>,
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Its channels in the order of the file.
    pub channels: Vec<ExrChannel>,
    /// Attributes beyond the standard ones that are text or a number, by name.
    pub attributes: Vec<(String, Attribute)>,
    /// Whether the data window is the display window.
    pub is_whole: bool,
    /// Whether it is a picture of surroundings as the six sides of a cube.
    pub is_cube_map: bool,
    /// Primaries and white, if the file has them.
    pub space: Option<RgbSpace>,
}

/// A channel of an OpenEXR file.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrChannel {
    /// Its name with its layer, as `depth.Z`.
    pub name: String,
    /// Whether its samples are whole numbers, not half or float.
    pub is_whole_numbers: bool,
}

impl ExrPart {
    /// The place of the channel of that name.
    pub fn channel(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.name == name)
    }
}
