//! From the table of a dye to the re-radiation of a layer of it.

use std::ops::Range;

use glanz_color::dyes::{Dye, dye};
use glanz_color::read::{Quantity, ReadOptions, read_spectra_with};
use glanz_color::{Outside, Reradiation, Spectrum};

use super::builder::Builder;
use super::spectra::unknown;
use crate::file::error::Problem;
use crate::file::tables::dyes::DyeTable;
use crate::file::tables::values::{Amount, At};

/// The reflectance of a base of which nothing is said: white card.
const BASE: f64 = 0.9;

impl Builder {
    /// The re-radiation of a layer.
    pub(super) fn dye(&mut self, table: &At<DyeTable>) -> Result<Reradiation, Problem> {
        let DyeTable { name, excitation, emission, quantum_yield, absorbance, base } = &table.value;
        let spectra = [excitation.as_ref().map(|v| &v.span), emission.as_ref().map(|v| &v.span)];
        let dye = match (name, excitation, emission) {
            (Some(name), None, None) if quantum_yield.is_none() => dye(name).map_err(|error| {
                unknown(&error, &name.span).help("`glanz color list dyes` tells the names")
            })?,
            (None, Some(excitation), Some(emission)) => {
                let quantum_yield = quantum_yield.as_ref().ok_or_else(|| {
                    Problem::at(
                        &table.span,
                        "a dye of spectra needs 'quantum_yield', the photons emitted for each absorbed",
                    )
                })?;
                self.dye_of_spectra(excitation, emission, quantum_yield.value.0, &table.span)?
            }
            _ => {
                let span = spectra.into_iter().flatten().next().unwrap_or(&table.span);
                let message =
                    "a dye is given by its name, or by 'excitation', 'emission' and 'quantum_yield'";
                return Err(Problem::at(span, message));
            }
        };
        let number = |value: &Option<At<Amount>>, default: f64| value.as_ref().map_or(default, |v| v.value.0);
        dye.over(&Spectrum::constant(number(base, BASE)), number(absorbance, 1.0))
            .map_err(|error| Problem::at(&table.span, error.to_string()))
    }

    fn dye_of_spectra(
        &mut self,
        excitation: &At<String>,
        emission: &At<String>,
        quantum_yield: f64,
        span: &Range<usize>,
    ) -> Result<Dye, Problem> {
        let excitation = self.relative(excitation)?;
        let emission = self.relative(emission)?;
        Dye::from_spectra(&excitation, &emission, quantum_yield)
            .map_err(|error| Problem::at(span, error.to_string()))
    }

    /// The only spectrum of a file, on its own scale.
    fn relative(&mut self, file: &At<String>) -> Result<Spectrum, Problem> {
        let wrong = |message: String| Problem::at(&file.span, message);
        let bytes = self.read_beside(file)?;
        let options = ReadOptions { quantity: Some(Quantity::Relative), ..ReadOptions::default() };
        let spectra = read_spectra_with(&bytes, file, &options).map_err(|error| wrong(error.to_string()))?;
        let [only] = spectra.as_slice() else {
            return Err(wrong(format!("expected one spectrum in the file, found {}", spectra.len())));
        };
        let (spectrum, notes) =
            only.to_spectrum(Some(Outside::Zero)).map_err(|error| wrong(error.to_string()))?;
        let told = only.notes.iter().chain(&notes).map(|note| format!("'{}': {note}", file.value));
        self.input.notes.extend(told);
        Ok(spectrum)
    }
}
