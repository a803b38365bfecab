//! Wavelength, frequency and period of light in vacuum: λ = c T, T = 1 / f.
//!
//! ```
//! use glanz_color::units::{frequency_hz, lambda_nm_of_frequency};
//!
//! // 540 THz, by which the candela is defined, are about 555 nm.
//! assert!((lambda_nm_of_frequency(540e12) - 555.17).abs() < 0.01);
//! assert!((frequency_hz(500.0) / 599.58e12 - 1.0).abs() < 1e-5);
//! ```

/// The speed of light in vacuum, in m/s: exact, it defines the metre (SI, 1983).
pub const SPEED_OF_LIGHT: f64 = 299_792_458.0;

/// Planck's constant in J s: exact, it defines the kilogram (SI, 2019).
pub const PLANCK: f64 = 6.626_070_15e-34;

/// The charge of a proton in C, and so 1 eV in J: exact, it defines the ampere (SI, 2019).
pub const ELEMENTARY_CHARGE: f64 = 1.602_176_634e-19;

/// Nanometres in a metre.
const NM_PER_M: f64 = 1e9;

/// The frequency in Hz of light of a wavelength in nm.
pub fn frequency_hz(lambda_nm: f64) -> f64 {
    SPEED_OF_LIGHT * NM_PER_M / lambda_nm
}

/// The period in s of light of a wavelength in nm.
pub fn period_s(lambda_nm: f64) -> f64 {
    lambda_nm / (SPEED_OF_LIGHT * NM_PER_M)
}

/// The wavelength in nm of light of a frequency in Hz.
pub fn lambda_nm_of_frequency(frequency_hz: f64) -> f64 {
    SPEED_OF_LIGHT * NM_PER_M / frequency_hz
}

/// The energy of a photon in J of light of a wavelength in nm: E = h c / λ.
pub fn photon_energy_j(lambda_nm: f64) -> f64 {
    PLANCK * SPEED_OF_LIGHT * NM_PER_M / lambda_nm
}

/// The wavelength in nm of light whose photons have this energy in eV.
pub fn lambda_nm_of_energy(energy_ev: f64) -> f64 {
    PLANCK * SPEED_OF_LIGHT * NM_PER_M / (energy_ev * ELEMENTARY_CHARGE)
}

/// The wavelength in nm of light of a period in s.
pub fn lambda_nm_of_period(period_s: f64) -> f64 {
    period_s * (SPEED_OF_LIGHT * NM_PER_M)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a few products and quotients.
    const ROUNDING: f64 = 1e-15;

    #[test]
    fn green_light_swings_540_thz() {
        // 555 nm, where the candela is defined by 540 THz (SI, 1979).
        assert!((frequency_hz(555.171) / 540.000_000e12 - 1.0).abs() < 1e-6);
        assert!((period_s(555.171) * 540e12 - 1.0).abs() < 1e-6);
        assert!((lambda_nm_of_frequency(299_792_458e6) - 1000.0).abs() < 1e-12);
    }

    #[test]
    fn a_photon_of_1_ev_is_infrared() {
        // h c / e = 1239.84198 eV nm (CODATA 2018).
        assert!((lambda_nm_of_energy(1.0) - 1_239.841_98).abs() < 1e-5);
        assert!((photon_energy_j(1_239.841_984) / ELEMENTARY_CHARGE - 1.0).abs() < 1e-9);
    }

    #[test]
    fn both_ways_lead_back() {
        for nm in [300.0, 456.4, 555.0, 780.0] {
            assert!((lambda_nm_of_frequency(frequency_hz(nm)) / nm - 1.0).abs() < ROUNDING);
            assert!((lambda_nm_of_period(period_s(nm)) / nm - 1.0).abs() < ROUNDING);
            assert!((frequency_hz(nm) * period_s(nm) - 1.0).abs() < ROUNDING);
        }
    }
}
