//! Text tables with commas.

use std::io::{self, Write};

use crate::spectra::{SAMPLES, Spectrum, lambda_nm};
use crate::surfaces::reradiation::Reradiation;

/// Writes spectra as columns behind one of wavelengths in nm. Names may hold a unit, as `patch 1 (%)`;
/// the values are written as they are.
///
/// # Errors
///
/// Those of the writer.
pub fn write_csv(mut out: impl Write, spectra: &[(&str, &Spectrum)]) -> io::Result<()> {
    write!(out, "wavelength (nm)")?;
    for (name, _) in spectra {
        write!(out, ",{}", field(name))?;
    }
    writeln!(out)?;
    for index in 0..SAMPLES {
        write!(out, "{}", lambda_nm(index))?;
        for (_, spectrum) in spectra {
            write!(out, ",{}", spectrum[index])?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Writes a re-radiation matrix: wavelengths of excitation in the first line, of emission in the first
/// column, both in nm, values per emission band of 5 nm.
///
/// # Errors
///
/// Those of the writer.
pub fn write_matrix_csv(mut out: impl Write, matrix: &Reradiation) -> io::Result<()> {
    write!(out, "emission by excitation (nm)")?;
    for input in 0..SAMPLES {
        write!(out, ",{}", lambda_nm(input))?;
    }
    writeln!(out)?;
    for row in 0..SAMPLES {
        write!(out, "{}", lambda_nm(row))?;
        for input in 0..SAMPLES {
            write!(out, ",{}", matrix.get(row, input))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// A name as a field: on one line, in quotes where it holds a separator.
fn field(name: &str) -> String {
    let plain: String = name.chars().map(|c| if c.is_control() || c == '"' { '\'' } else { c }).collect();
    if plain.contains([',', ';', '#']) { format!("\"{plain}\"") } else { plain }
}
