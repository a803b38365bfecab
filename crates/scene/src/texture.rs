//! Pictures on surfaces.

/// What happens outside 0 … 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The picture repeats.
    #[default]
    Repeat,
    /// Every second repetition is mirrored.
    Mirror,
    /// The edge continues.
    Clamp,
}

/// How texels become values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TextureFilter {
    /// The nearest texel of the finest level.
    Nearest,
    /// Linear between texels and between mip levels.
    #[default]
    Trilinear,
}

/// A decoded picture: four 8-bit channels per texel, rows from the top.
#[derive(Clone, Debug, Default, PartialEq)]
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
