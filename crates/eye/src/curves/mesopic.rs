//! Mesopic luminance: what cones and rods see together.

use libm::log10;

use super::within;

/// What the scotopic luminance counts beside the photopic one, 683/1700: V′ in the luminance of CIE 191.
pub const SCOTOPIC_WEIGHT: f64 = 683.0 / 1700.0;

/// The state of an eye between day and night.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesopic {
    /// The share m of the cones: 1 by day (from 5 cd/m²), 0 at night (up to 0.005 cd/m²).
    pub m: f64,
    /// The mesopic luminance in cd/m².
    pub luminance: f64,
}

/// The system MES2 of CIE 191:2010: mesopic luminance from photopic and scotopic luminance, both in cd/m².
///
/// **Formula** Lmes = (m Lp + (1 − m) Ls v)/(m + (1 − m) v) with v = 683/1700, and m = 0.7670 + 0.3334 log10 Lmes, held in 0 … 1.
/// **Range** any; negative luminance is read as 0. Of the adapting field, not of a single patch: [`mesopic_with`] takes the m of the
/// field for a patch in it.
/// **How we differ** the CIE iterates on m, which does not converge for extreme ratios of Ls and Lp; m is found by bisection here.
/// **Source** CIE 191:2010 in implementations; its text was not at hand.
///
/// ```
/// let dusk = glanz_eye::curves::mesopic(0.1, 0.1);
/// // Where both luminances are the same, so is the mesopic one.
/// assert!((dusk.m - 0.4336).abs() < 5e-5 && (dusk.luminance - 0.1).abs() < 1e-12);
/// ```
pub fn mesopic(photopic: f64, scotopic: f64) -> Mesopic {
    // Halved so often, the interval is that of two neighbouring numbers.
    const HALVINGS: usize = 60;
    let wanted = |m: f64| {
        let luminance = mesopic_with(m, photopic, scotopic).max(f64::MIN_POSITIVE);
        within(0.7670 + 0.3334 * log10(luminance), 0.0, 1.0)
    };
    let (mut low, mut high) = (0.0, 1.0);
    if wanted(1.0) >= 1.0 {
        low = 1.0;
    }
    if low == 0.0 && wanted(0.0) <= 0.0 {
        high = 0.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match wanted(middle) > middle {
            true => low = middle,
            false => high = middle,
        }
    }
    let m = 0.5 * (low + high);
    Mesopic { m, luminance: mesopic_with(m, photopic, scotopic) }
}

/// The mesopic luminance in cd/m² of a patch in a field whose share of the cones is `m` (CIE 191:2010).
///
/// ```
/// use glanz_eye::curves::{mesopic, mesopic_with};
///
/// // A blue flower with eight times as much scotopic as photopic luminance gains at dusk.
/// let field = mesopic(0.1, 0.25);
/// assert!(mesopic_with(field.m, 0.006, 0.048) > 0.012);
/// ```
pub fn mesopic_with(m: f64, photopic: f64, scotopic: f64) -> f64 {
    // Beyond any luminance; held, the sums are finite.
    let [photopic, scotopic] = [photopic, scotopic].map(|value| within(value, 0.0, 1e300));
    let m = within(m, 0.0, 1.0);
    let rods = (1.0 - m) * SCOTOPIC_WEIGHT;
    (m * photopic + rods * scotopic) / (m + rods)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    /// Of numbers that are equal but for the rounding of a few sums.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn the_share_of_the_cones_has_the_values_of_cie_191() {
        // eye.md 39–41.
        for (luminance, known) in [(0.01, "0.1002"), (0.1, "0.4336"), (1.0, "0.7670")] {
            assert_digits(mesopic(luminance, luminance).m, known);
        }
        // eye.md 42–43: incandescent light and daylight.
        for (ratio, m, luminance) in [(1.41, "0.45185", "0.11343"), (2.47, "0.48621", "0.14381")] {
            let found = mesopic(0.1, 0.1 * ratio);
            assert_digits(found.m, m);
            assert_digits(found.luminance, luminance);
        }
    }

    #[test]
    fn where_both_luminances_are_the_same_so_is_the_mesopic_one() {
        for exponent in -40..=40 {
            let luminance = libm::pow(10.0, 0.1 * f64::from(exponent));
            let found = mesopic(luminance, luminance).luminance;
            assert!((found / luminance - 1.0).abs() < ROUNDING, "{luminance}: {found}");
        }
    }

    #[test]
    fn day_and_night_have_their_ends() {
        assert_eq!((mesopic(5.0, 5.0).m, mesopic(100.0, 3.0).m), (1.0, 1.0));
        assert_eq!((mesopic(0.005, 0.005).m, mesopic(0.0, 0.0).m), (0.0, 0.0));
        assert_eq!(mesopic(0.001, 0.002).luminance, 0.002);
        assert_eq!(mesopic(50.0, 3.0).luminance, 50.0);
    }

    #[test]
    fn the_share_solves_its_equation_for_extreme_ratios_too() {
        // The iteration of the CIE swings there: Lighting Research and Technology, 2015.
        for ratio in [0.01, 0.1, 10.0, 50.0] {
            let found = mesopic(0.1, 0.1 * ratio);
            let again = (0.7670 + 0.3334 * log10(found.luminance)).clamp(0.0, 1.0);
            assert!((again - found.m).abs() < ROUNDING, "{ratio}: {} {again}", found.m);
        }
    }

    #[test]
    fn red_darkens_and_blue_brightens_at_dusk() {
        // eye.md 45–50: the ColorChecker's red and blue relative to white of D65, by Y and V′; white of 0.1 cd/m².
        // Half a unit of the last digit, for the reflectances and for the results.
        const GIVEN: f64 = 1e-5;
        let ratio = 2.46463;
        let white = mesopic(0.1, 0.1 * ratio);
        assert_digits(white.m, "0.48606");
        for (by_day, by_night, known) in [(0.11826, 0.04781, 0.08222), (0.06230, 0.15423, 0.10932)] {
            let patch = mesopic_with(white.m, 0.1 * by_day, 0.1 * ratio * by_night) / white.luminance;
            assert!((patch - known).abs() <= GIVEN, "{patch} {known}");
        }
    }
}
