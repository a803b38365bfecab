//! Functions of wavelength: the one grid, tables brought onto it, and units of wavelength.

mod arithmetic;
mod resample;
mod spectrum;
pub(crate) mod table;
pub mod units;

pub use resample::{Outside, TableError};
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, STEP_NM, Spectrum, lambda_nm};
