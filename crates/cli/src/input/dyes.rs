//! Fluorescent dyes over a base: by name, or from files of their spectra.

use std::path::{Path, PathBuf};

use clap::Args;
use glanz_color::dyes::{Dye, dye, dyes};
use glanz_color::{Spectrum, SpectrumKind};

use super::spectra::{FluorescentSource, TableArgs, relative_spectrum, source};
use crate::print::failure::Failure;

/// The reflectance of a base of which nothing is said: white card.
const BASE: f64 = 0.9;

/// A dye and the layer of it.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Dyes")]
pub(crate) struct DyeArgs {
    /// A file with the spectrum of excitation or absorbance of a dye of your own, on any scale
    #[arg(long, value_name = "FILE", requires = "emission")]
    excitation: Option<PathBuf>,

    /// A file with its spectrum of emission, as power per nm on any scale
    #[arg(long, value_name = "FILE", requires = "excitation")]
    emission: Option<PathBuf>,

    /// Photons that it emits for each absorbed, 0 to 1
    #[arg(long, value_name = "NUMBER", requires = "excitation")]
    quantum_yield: Option<f64>,

    /// The greatest decadic absorbance of the layer of a dye: 1 absorbs nine tenths
    #[arg(long, value_name = "NUMBER")]
    absorbance: Option<f64>,

    /// The surface below a dye: a reflectance by name or file, or a number; 0.9 unless said
    #[arg(long, value_name = "NAME|FILE|NUMBER")]
    base: Option<String>,
}

impl DyeArgs {
    /// Whether nothing is said of a dye.
    pub(crate) fn is_default(&self) -> bool {
        self.excitation.is_none() && self.absorbance.is_none() && self.base.is_none()
    }

    /// The layer of the dye that is meant; none where the word is no dye.
    pub(crate) fn layer(&self, word: Option<&str>) -> Result<Option<FluorescentSource>, Failure> {
        let (name, title, dye) = match (word, &self.excitation, &self.emission) {
            (None, Some(excitation), Some(emission)) => {
                let title = format!("from {} and {}", excitation.display(), emission.display());
                ("dye".to_owned(), title, self.of_spectra(excitation, emission)?)
            }
            (Some(word), Some(_), _) => {
                return Err(Failure::Usage(format!(
                    "'{word}' beside --excitation: one of both is the material"
                )));
            }
            (Some(word), ..) => match dye(word) {
                Ok(found) => {
                    let info = dyes().iter().find(|info| info.name == word.to_lowercase());
                    (word.to_owned(), info.map_or("", |info| info.title).to_owned(), found)
                }
                Err(_) if self.absorbance.is_none() && self.base.is_none() => return Ok(None),
                Err(error) => {
                    return Err(Failure::Usage(format!("--absorbance and --base are for dyes: {error}")));
                }
            },
            _ => {
                return Err(Failure::Usage(
                    "say which material: a name, a file, or --excitation with --emission".to_owned(),
                ));
            }
        };
        let matrix = dye
            .over(&self.base()?, self.absorbance.unwrap_or(1.0))
            .map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(Some(FluorescentSource { name, title, matrix }))
    }

    fn of_spectra(&self, excitation: &Path, emission: &Path) -> Result<Dye, Failure> {
        let Some(quantum_yield) = self.quantum_yield else {
            let message = "a dye of spectra needs --quantum-yield, the photons emitted for each absorbed";
            return Err(Failure::Usage(message.to_owned()));
        };
        let (excitation, emission) = (relative_spectrum(excitation)?, relative_spectrum(emission)?);
        Dye::from_spectra(&excitation, &emission, quantum_yield)
            .map_err(|error| Failure::new(error.to_string()))
    }

    fn base(&self) -> Result<Spectrum, Failure> {
        let Some(word) = &self.base else { return Ok(Spectrum::constant(BASE)) };
        if let Ok(value) = word.parse::<f64>() {
            return Ok(Spectrum::constant(value));
        }
        Ok(source(word, Some(SpectrumKind::Surface), &TableArgs::default())?.spectrum)
    }
}
