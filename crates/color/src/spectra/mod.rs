//! Functions of wavelength: the one grid, tables brought onto it, and units of wavelength.

mod arithmetic;
mod fine;
mod interpolate;
mod resample;
pub(crate) mod sampled;
mod spectrum;
pub(crate) mod table;
pub mod units;

pub use fine::{FINE_LAST_NM, FINE_SAMPLES, FineSpectrum, Interpolation};
pub use resample::{Outside, TableError};
pub use sampled::Sampled;
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};
