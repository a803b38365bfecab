//! Whether a re-radiation matrix can be a real material: not more light leaves it than comes in.

use super::Reradiation;
use crate::spectra::{SAMPLES, lambda_nm};

/// How far the sum of a column may exceed 1. A measured radiance factor is no better than the
/// calibration of its white standard, about 1 %.
const SUM_TOLERANCE: f64 = 0.01;
/// How much of a band's light may seem to leave at shorter wavelengths. In the eight materials measured
/// with a Labsphere BFC-450 by S. Gonzalez and M. Fairchild (RIT) clipped noise and the width of the
/// instrument's bands reach 0.071.
const UP_CONVERSION_NOISE: f64 = 0.1;

/// What the conservation of energy says of a re-radiation matrix. Fractions are of the light that comes in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyReport {
    /// The greatest fraction of energy that leaves: the greatest sum of a column.
    pub max_column_sum: f64,
    /// The wavelength of incidence at which it is reached, in nm.
    pub at_nm: f64,
    /// The greatest fraction of photons that leave: the greatest of Σ M\[out\]\[in\] λ_out / λ_in, since a
    /// photon's energy is h c / λ. With emission at longer wavelengths it is the stricter bound: each
    /// photon that comes in gives at most one.
    pub max_photon_sum: f64,
    /// The wavelength of incidence at which it is reached, in nm.
    pub photons_at_nm: f64,
    /// The greatest fraction of energy that leaves at shorter wavelengths than it came in. Fluorescence
    /// gives none (Stokes); measurements show noise.
    pub up_conversion: f64,
    /// Whether both sums are at most 1.01, up-conversion is at most 0.1, and no entry is negative or
    /// no number.
    pub ok: bool,
}

impl Reradiation {
    /// Checks that at most as much light leaves as comes in, and none at shorter wavelengths.
    pub fn energy(&self) -> EnergyReport {
        let mut report = EnergyReport {
            max_column_sum: 0.0,
            at_nm: lambda_nm(0),
            max_photon_sum: 0.0,
            photons_at_nm: lambda_nm(0),
            up_conversion: 0.0,
            ok: false,
        };
        for input in 0..SAMPLES {
            let column = |out: usize| self.get(out, input);
            let sum: f64 = (0..SAMPLES).map(column).sum();
            let photons: f64 = (0..SAMPLES).map(|out| column(out) * lambda_nm(out) / lambda_nm(input)).sum();
            if sum > report.max_column_sum {
                (report.max_column_sum, report.at_nm) = (sum, lambda_nm(input));
            }
            if photons > report.max_photon_sum {
                (report.max_photon_sum, report.photons_at_nm) = (photons, lambda_nm(input));
            }
            report.up_conversion = report.up_conversion.max((0..input).map(column).sum());
        }
        let limit = 1.0 + SUM_TOLERANCE;
        let entries = self.entries.iter().flatten().all(|entry| entry.is_finite() && *entry >= 0.0);
        report.ok = entries
            && report.max_column_sum <= limit
            && report.max_photon_sum <= limit
            && report.up_conversion <= UP_CONVERSION_NOISE;
        report
    }
}
