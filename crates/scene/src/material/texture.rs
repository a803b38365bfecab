//! Pictures on surfaces.

use serde::{Deserialize, Serialize};

use crate::names::names;

names! {
    /// What happens outside 0 … 1.
    pub Wrap {
        /// The picture repeats.
        Repeat = "repeat",
        /// Every second repetition is mirrored.
        Mirror = "mirror",
        /// The edge continues.
        Clamp = "clamp",
    } default Repeat
}

names! {
    /// How texels become values.
    pub TextureFilter {
        /// Linear between texels and between mip levels.
        Trilinear = "trilinear",
        /// The nearest texel of the finest level.
        Nearest = "nearest",
    } default Trilinear
}

/// A decoded picture: four 8-bit channels per texel, rows from the top.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Texture {
    /// A name for people; may be empty.
    pub name: String,
    /// Width in texels, at least 1.
    pub width: u32,
    /// Height in texels, at least 1.
    pub height: u32,
    /// RGBA, `4·width·height` bytes.
    pub rgba: Vec<u8>,
    /// Whether the colour channels are sRGB codes (colours) or plain numbers (normals).
    pub srgb: bool,
    /// Along u and v.
    pub wrap: [Wrap; 2],
    /// How texels become values.
    pub filter: TextureFilter,
}
