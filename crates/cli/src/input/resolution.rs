//! The resolution at which numbers of a spectrum are told.

use clap::ValueEnum;
use glanz_color::read::NamedSpectrum;
use glanz_color::{FineSpectrum, Interpolation, Outside, TableError};

use super::spectra::Source;

/// A table whose values lie further apart than this, in nm, is coarse: what lies between them is a guess that shows.
const COARSE_NM: f64 = 5.5;

/// A table with coarse steps.
#[derive(Clone, Debug)]
pub(crate) struct Coarse {
    /// The mean step in nm.
    pub step_nm: f64,
    /// The values by 1 nm, joined by smooth curves.
    pub smooth: FineSpectrum,
}

/// What the option --interpolation takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CoarseTable {
    /// Straight lines, as in pictures
    Lines,
    /// Sprague's polynomials (CIE 167:2005)
    Sprague,
}

impl Source {
    /// The spectrum with the values of a coarse table joined in the way that was asked for.
    pub(crate) fn interpolated(mut self, wanted: Option<CoarseTable>) -> Self {
        match (wanted, self.coarse.take()) {
            (Some(CoarseTable::Sprague), Some(coarse)) => self.fine = coarse.smooth,
            (Some(CoarseTable::Lines), _) => {}
            (_, coarse) => self.coarse = coarse,
        }
        self
    }
}

/// A spectrum by 1 nm, for numbers.
pub(super) fn fine(
    named: &NamedSpectrum,
    outside: Outside,
) -> Result<(FineSpectrum, Option<Coarse>), TableError> {
    let smooth = named.to_fine(Some(outside), Interpolation::Smooth)?;
    let step_nm = named.step_nm();
    if step_nm <= COARSE_NM {
        return Ok((smooth, None));
    }
    Ok((named.to_fine(Some(outside), Interpolation::Lines)?, Some(Coarse { step_nm, smooth })))
}
