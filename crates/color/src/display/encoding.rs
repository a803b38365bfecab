//! The names of encodings: the one list of scene files, command line and pictures.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How linear light becomes the codes of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Encoding {
    /// By the transfer function of sRGB, which screens undo.
    #[default]
    Srgb,
    /// Not at all: the linear value, clipped to 0 … 1, times the greatest code, as a shader's output gets into a
    /// framebuffer of OpenGL that is not sRGB.
    Raw,
}

impl Encoding {
    /// All of them with their names in files and on the command line.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Srgb, "srgb"), (Self::Raw, "raw")];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_has_its_name() {
        for (encoding, name) in Encoding::ALL {
            assert_eq!(encoding.name(), name);
        }
    }
}
