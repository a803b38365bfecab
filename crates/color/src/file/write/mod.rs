//! Writers of spectra and of re-radiation matrices: what [`crate::read`] reads back to the bit.
//!
//! Written are text tables of both, and IES TM-27-14 `.spdx`; numbers with as many digits as it takes to
//! tell them apart.

mod csv;
mod spdx;

pub use csv::{write_csv, write_matrix_csv};
pub use spdx::write_spdx;
