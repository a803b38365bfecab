//! Colour for Glanz: spectra, lights, observers, surfaces, colour models, and the numbers that are made of
//! them.
//!
//! One grid for all spectra, 300 to 780 nm by 5 nm ([`Spectrum`]); f64 throughout; only pure-Rust functions,
//! so that numbers are the same on every machine.

pub mod adaptation;
mod catalog;
pub mod chromaticity;
pub mod colorimetry;
pub mod cri;
pub mod difference;
pub mod dominant;
pub mod efficiency;
#[cfg(feature = "exr")]
pub mod exr;
mod fluorescent;
mod fluorophore;
mod ior;
mod lights;
mod linear;
mod matrix;
pub mod meyer;
pub mod mixing;
pub mod models;
mod names;
mod observers;
mod paper_notes;
pub mod photometry;
pub mod read;
mod reflectances;
mod reradiation;
mod resample;
mod rgb;
pub mod rgb_spectra;
mod spectrum;
mod srgb;
mod table;
pub mod temperature;
mod tone_map;
pub mod units;
pub mod upsample;
pub mod write;

pub use adaptation::{Adaptation, AdaptationError};
pub use catalog::{CatalogSpectrum, SpectrumKind, catalog_spectrum};
pub use fluorescent::{FluorescentInfo, fluorescent, fluorescents};
pub use fluorophore::{Fluorophore, FluorophoreError, FluorophoreParameter};
pub use ior::{Dispersion, Ior, IorInfo, IorKind, ior, iors};
pub use lights::{LightInfo, light, lights};
pub use matrix::Matrix3;
pub use models::Xyz;
pub use names::UnknownName;
pub use observers::{
    Channel, Observer, ObserverInfo, ObserverKind, cie1931_by_1_nm, observer, observers, xyz_of_light,
    xyz_of_reflectance,
};
pub use paper_notes::{PaperNote, paper_notes};
pub use reflectances::{ReflectanceInfo, colorchecker, reflectance, reflectances};
pub use reradiation::{EnergyReport, MeasuredError, Reradiation};
pub use resample::{Outside, TableError};
pub use rgb::Rgb;
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};
pub use srgb::{srgb_decode, srgb_decode_u8, srgb_encode};
pub use tone_map::ToneMap;
