//! Colorimetry and photometry: the numbers that are made of spectra and XYZ.

pub mod adaptation;
pub mod chromaticity;
pub mod colorimetry;
pub mod cri;
pub mod difference;
pub mod dominant;
pub mod photometry;
pub mod ssi;
pub mod temperature;
pub mod tm30;
pub mod whiteness;
pub mod yellowness;
