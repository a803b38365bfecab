//! Spectra into text tables.

use std::path::Path;

use glanz_color::Spectrum;
use glanz_color::write::write_csv;
use glanz_picture::output::{OutputError, write_atomically};

use super::failure::Failure;
use super::print;

/// Writes spectra as columns, by their names. The file is old or new, but never half.
pub fn save_csv(path: &Path, spectra: &[(&str, &Spectrum)]) -> Result<(), Failure> {
    write_atomically(path, |out| write_csv(out, spectra).map_err(OutputError::Stream))?;
    print::note(format_args!("wrote {}", path.display()));
    Ok(())
}
