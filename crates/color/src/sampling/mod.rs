//! Few numbers for a spectrum: RGB, wavelengths sampled, and the errors of both.

pub mod efficiency;
pub mod meyer;
pub mod rgb_spectra;
pub mod upsample;
