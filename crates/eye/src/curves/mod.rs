//! Formulas of the eye in closed form: pupil, mesopic luminance, glare, contrast sensitivity, response, Mach bands, retina, chromatic
//! aberration, acuity, and the density of the lens.
//!
//! Every function takes and gives `f64` and is total: a quantity outside of the range that its formula was made for is held at the
//! nearest end of it, and NaN is read as the low end, so that no answer is NaN. Luminances are in cd/m², angles in degrees,
//! spatial frequencies in cycles per degree, ages in years, and names carry every other unit.
//!
//! ```
//! use glanz_eye::curves::{Eyes, mesopic, pupil_diameter_mm, trolands};
//!
//! // A field of 60° across at 1 cd/m², seen by both eyes of someone of twenty and of someone of eighty.
//! let young = pupil_diameter_mm(1.0, 2827.43, 20.0, Eyes::Both);
//! let old = pupil_diameter_mm(1.0, 2827.43, 80.0, Eyes::Both);
//! assert!(young > 5.3 && old < 3.8);
//! // The retina of the older one gets half of the light.
//! assert!(trolands(1.0, old) < 0.5 * trolands(1.0, young));
//! // There the rods take part: the share of the cones is 77 %.
//! assert!((mesopic(1.0, 1.0).m - 0.767).abs() < 1e-3);
//! ```

mod acuity;
mod chromatic;
mod csf;
mod glare;
mod glare_mixture;
mod lens;
mod mach;
mod mesopic;
mod pupil;
mod response;
mod retina;

pub use acuity::{acuity_cutoff, acuity_cutoff_at, blur_sigma_deg};
pub use chromatic::{chromatic_defocus, defocus_disc_deg};
pub use csf::{CsfChannel, barten_csf, castle_csf, mannos_sakrison};
pub use glare::{
    cie146_glare, spencer_photopic_glare, stiles_holladay_glare, vos_glare, vos_glare_integral, vos_glare_mtf,
};
pub use glare_mixture::{Gaussian, GlareMixture, mixture};
pub use lens::{lens_density_cie170, lens_density_cie203};
pub use mach::CenterSurround;
pub use mesopic::{Mesopic, SCOTOPIC_WEIGHT, mesopic, mesopic_with};
pub use pupil::{
    Eyes, PHOTOPIC_EFFICACY, SCOTOPIC_EFFICACY, photons_per_troland, pupil_diameter_mm, trolands,
};
pub use response::{
    cone_semisaturation, gsdf_index, gsdf_luminance, lightness, naka_rushton, rod_semisaturation,
    weber_fechner,
};
pub use retina::{
    Meridian, cone_density_deg2, eccentricity_mm, geisler_perry_cutoff, macula_density_at,
    midget_field_density_deg2, retinal_area_mm2, rod_density_mm2,
};

/// The value, held within `low` … `high`; NaN is `low`.
fn within(value: f64, low: f64, high: f64) -> f64 {
    // `max` gives the other operand for NaN, which `clamp` does not.
    value.max(low).min(high)
}

/// Tests hold a known number to its last digit: half a unit of it.
///
/// Numbers cited by "eye.md" are those of the project's notes on the eye, computed there by a program of its own, or read where it says
/// so.
#[cfg(test)]
pub(crate) fn assert_digits(found: f64, known: &str) {
    let digits = known.split_once('.').map_or(0, |(_, digits)| digits.len());
    let known: f64 = known.parse().expect("a number");
    let half = 0.5 * libm::pow(10.0, -(digits as f64));
    // A little more: the known number may itself lie half-way.
    assert!((found - known).abs() <= 1.02 * half, "{found}, known {known}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_nan_whatever_goes_in() {
        let odd =
            [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0, f64::MIN_POSITIVE, 1e-30, 1e30, f64::MAX];
        let two: [fn(f64, f64) -> f64; 18] = [
            |a, b| pupil_diameter_mm(a, b, a, Eyes::One),
            |a, b| pupil_diameter_mm(b, 900.0, a, Eyes::Both),
            trolands,
            photons_per_troland,
            |a, b| mesopic(a, b).m,
            |a, b| mesopic(a, b).luminance,
            |a, b| vos_glare(a, b, a),
            |a, b| cie146_glare(b, a, a) + stiles_holladay_glare(a, b) + spencer_photopic_glare(a),
            |a, b| vos_glare_mtf(a, b, b) + vos_glare_integral(b, a),
            |a, b| castle_csf(CsfChannel::Achromatic, a, b, a, b),
            |a, b| castle_csf(CsfChannel::RedGreen, a, b, b, a),
            |a, b| castle_csf(CsfChannel::YellowViolet, b, b, a, a),
            |a, b| barten_csf(a, b, a) + mannos_sakrison(b),
            |a, b| weber_fechner(a, b) + lightness(a) + gsdf_luminance(a) + gsdf_index(b),
            |a, b| naka_rushton(a, b, 0.73) + naka_rushton(a, a, b),
            |a, b| cone_semisaturation(a) + rod_semisaturation(b),
            |a, b| {
                acuity_cutoff_at(a, b)
                    + blur_sigma_deg(a)
                    + lens_density_cie170(a, b)
                    + lens_density_cie203(a, b)
            },
            |a, b| {
                rod_density_mm2(a)
                    + cone_density_deg2(a)
                    + midget_field_density_deg2(b, Meridian::Nasal)
                    + eccentricity_mm(b)
                    + retinal_area_mm2(b)
                    + geisler_perry_cutoff(a)
                    + macula_density_at(b)
                    + defocus_disc_deg(a, b, 555.0)
                    + chromatic_defocus(a)
            },
        ];
        for (index, f) in two.iter().enumerate() {
            for a in odd {
                for b in odd {
                    assert!(!f(a, b).is_nan(), "function {index} of {a}, {b}");
                }
            }
        }
    }
}
