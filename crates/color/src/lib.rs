//! Colour for Glanz: spectra, linear RGB with the sRGB primaries, the sRGB transfer.

mod fluorophore;
mod reradiation;
mod rgb;
mod spectrum;
mod srgb;

pub use fluorophore::{Fluorophore, FluorophoreError, FluorophoreParameter};
pub use reradiation::{EnergyReport, MeasuredError, Reradiation};
pub use rgb::Rgb;
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};
pub use srgb::{srgb_decode, srgb_decode_u8, srgb_encode};
