//! Files of spectra, of re-radiation and of spectral pictures.

pub mod exr;
pub mod read;
pub mod write;
