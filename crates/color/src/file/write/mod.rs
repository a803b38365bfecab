//! Writers of spectra and of re-radiation matrices: what [`crate::read`] reads back to the bit.
//!
//! Written are text tables of both, and IES TM-27-14 `.spdx`; numbers with as many digits as it takes to
//! tell them apart.
//!
//! ```
//! use glanz_color::light;
//! use glanz_color::read::read_csv;
//! use glanz_color::write::write_csv;
//!
//! let d65 = light("D65")?;
//! let mut file = Vec::new();
//! write_csv(&mut file, &[("D65", &d65)])?;
//! let read = read_csv(&file, "d65.csv")?;
//! assert_eq!(read[0].to_spectrum(None)?.0, d65);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod csv;
mod spdx;

pub use csv::{write_csv, write_matrix_csv};
pub use spdx::write_spdx;
