//! Files of spectra, of re-radiation and of spectral pictures.

#[cfg(feature = "exr")]
pub mod exr;
pub mod read;
pub mod write;
