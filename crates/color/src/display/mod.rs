//! Colours as displays show them: linear RGB, the transfer of sRGB, tone mapping, mixing.

pub(crate) mod encoding;
pub mod mixing;
pub(crate) mod rgb;
pub(crate) mod srgb;
pub(crate) mod tone_map;
