//! Visual acuity: the finest grating that is seen, by luminance and eccentricity.

use libm::{log10, sqrt};

use super::within;

/// log10 of the luminance in cd/m², and the highest frequency that is seen, in cycles per degree.
const SHLAER: [(f64, f64); 20] = [
    (-3.105_03, 2.09),
    (-2.664_03, 3.28),
    (-2.377_03, 3.79),
    (-2.093_03, 4.39),
    (-1.644_03, 6.11),
    (-1.358_03, 8.83),
    (-1.074_03, 10.94),
    (-0.672_03, 18.66),
    (-0.385_03, 23.88),
    (-0.101_03, 31.05),
    (0.293_97, 37.42),
    (0.580_97, 37.68),
    (0.864_97, 41.60),
    (1.256_97, 43.16),
    (1.543_97, 45.30),
    (1.827_97, 47.00),
    (2.275_97, 48.43),
    (2.562_97, 48.32),
    (2.846_97, 51.06),
    (3.248_97, 51.09),
];

/// The finest grating that is seen at a luminance, in cycles per degree: 2 by starlight to 51 by day.
///
/// **Formula** Shlaer's table, linear in the logarithm of luminance; held at its ends.
/// **Parameters** `luminance` of the adapting field in cd/m², 8e-4 to 1800.
/// **Source** S. Shlaer, Journal of General Physiology 21, 1937, as in Radiance's `pcond`; the readings of one young observer.
///
/// ```
/// use glanz_eye::curves::acuity_cutoff;
///
/// assert!(acuity_cutoff(0.01) < 6.0 && acuity_cutoff(1000.0) > 50.0);
/// ```
pub fn acuity_cutoff(luminance: f64) -> f64 {
    let log = within(log10(within(luminance, 1e-30, 1e30)), SHLAER[0].0, SHLAER[SHLAER.len() - 1].0);
    let after = SHLAER.partition_point(|(place, _)| *place < log).max(1);
    let ((from, low), (to, high)) = (SHLAER[after - 1], SHLAER[after]);
    low + (log - from) / (to - from) * (high - low)
}

/// The same at an eccentricity: [`acuity_cutoff`] times 2.3/(e + 2.3), the fall of Geisler and Perry's resolution.
///
/// **Parameters** `luminance` in cd/m²; `eccentricity_deg` e, 0 to 90°.
/// **Limits** that both factors are independent is our choice: at night the fovea has no rods, and the finest grating is seen a few
/// degrees from it.
///
/// ```
/// use glanz_eye::curves::acuity_cutoff_at;
///
/// assert_eq!(acuity_cutoff_at(100.0, 2.3), 0.5 * acuity_cutoff_at(100.0, 0.0));
/// ```
pub fn acuity_cutoff_at(luminance: f64, eccentricity_deg: f64) -> f64 {
    acuity_cutoff(luminance) * 2.3 / (within(eccentricity_deg, 0.0, 90.0) + 2.3)
}

/// The standard deviation in degrees of the Gaussian blur that leaves a tenth of the contrast at a frequency in cycles per degree:
/// √(ln 10/2π²)/f.
///
/// ```
/// assert!((glanz_eye::curves::blur_sigma_deg(1.0) - 0.34154).abs() < 5e-6);
/// ```
pub fn blur_sigma_deg(cutoff: f64) -> f64 {
    use core::f64::consts::{LN_10, PI};
    sqrt(LN_10 / 2.0) / PI / within(cutoff, 1e-3, 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use libm::pow;

    use crate::curves::assert_digits;

    #[test]
    fn the_table_of_shlaer_is_met_at_its_points_and_held_beyond() {
        // eye.md §2, whose luminances have three digits: there the curve is steep, at most 40 cycles per degree a decade.
        const GIVEN: f64 = 0.0005 * 40.0;
        for (log, known) in [
            (-3.105, 2.09),
            (-2.093, 4.39),
            (-1.074, 10.94),
            (-0.101, 31.05),
            (0.865, 41.60),
            (1.828, 47.00),
            (3.249, 51.09),
        ] {
            let found = acuity_cutoff(pow(10.0, log));
            assert!((found - known).abs() < GIVEN, "{log}: {found}");
        }
        assert_eq!((acuity_cutoff(0.0), acuity_cutoff(1e9)), (2.09, 51.09));
    }

    #[test]
    fn between_its_points_it_is_linear_in_the_logarithm() {
        let middle = pow(10.0, 0.5 * (SHLAER[8].0 + SHLAER[9].0));
        assert!((acuity_cutoff(middle) - 0.5 * (23.88 + 31.05)).abs() < 1e-9);
    }

    #[test]
    fn the_blur_leaves_a_tenth_of_the_contrast() {
        let sigma = blur_sigma_deg(30.0);
        let x = core::f64::consts::PI * sigma * 30.0;
        assert!((libm::exp(-2.0 * x * x) - 0.1).abs() < 1e-12);
        assert_digits(blur_sigma_deg(1.0), "0.34154");
    }
}
