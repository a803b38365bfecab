//! Colour for Glanz: spectra, linear RGB with the sRGB primaries, the sRGB transfer.

pub mod adaptation;
pub mod difference;
mod matrix;
pub mod mixing;
pub mod models;
mod reradiation;
mod rgb;
mod spectrum;
mod srgb;

pub use matrix::Matrix3;
pub use reradiation::Reradiation;
pub use rgb::Rgb;
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};
pub use srgb::{srgb_decode, srgb_decode_u8, srgb_encode};
