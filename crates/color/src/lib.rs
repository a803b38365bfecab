//! Colour for Glanz. In this version: linear RGB with the sRGB primaries, and the sRGB transfer.

mod rgb;
mod srgb;

pub use rgb::Rgb;
pub use srgb::{srgb_decode, srgb_decode_u8, srgb_encode};
