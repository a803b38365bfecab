//! Words of the command line that name things: spectra, lobes, variations, bounds.

pub mod lobes;
pub mod spectra;
pub mod thresholds;
pub mod vary;
