//! Lights that are given by a formula.

use std::sync::LazyLock;

use crate::spectra::table::Table;
use crate::spectra::{Outside, Sampled};

/// The wavelength at which most relative spectra are 1, in nm.
pub(super) const UNIT_NM: f64 = 560.0;

/// The second radiation constant c₂ = h c / k, in nm K (SI, 2019: all three are exact).
const C2_NM_K: f64 = 1.438_776_877e7;
/// The c₂ by which illuminant A is defined (CIE 15:2004).
const C2_A_NM_K: f64 = 1.435e7;
/// The temperature of illuminant A with that c₂, in K.
const T_A_K: f64 = 2848.0;
/// The c₂ when the D illuminants were named, and when their tables were computed (CIE 15:2004): D65 is
/// 6500 K on the old scale.
const C2_NAMED: f64 = 1.4380;
const C2_TABLED: f64 = 1.4388;

/// The width between half values of a Gaussian in standard deviations: 2 √(2 ln 2).
const FWHM_PER_SIGMA: f64 = 2.354_820_045_030_949;

/// The narrowest Gaussian that is sampled at the grid's wavelengths: its sum is its integral to 1e-6.
const SAMPLED_FWHM_NM: f64 = 10.0;

/// The components of daylight: mean, and two eigenvectors; linear between the CIE's values, as its illuminants are
/// (CIE 15:2018, section 4.1.2).
static DAYLIGHT: LazyLock<[Component; 3]> = LazyLock::new(|| {
    let table = Table::parse(include_str!("../../data/daylight.csv"));
    ["S0", "S1", "S2"].map(|name| table.points(name).expect("the table has S0, S1, S2"))
});

/// Wavelengths in nm and values.
type Component = (Vec<f64>, Vec<f64>);

/// Planck's law, 1 at 560 nm. The temperature is in K, above 0.
pub(crate) fn blackbody<S: Sampled>(kelvin: f64) -> S {
    S::build(&planck_at(kelvin))
}

/// Planck's law over the wavelength in nm, 1 at 560 nm.
pub(crate) fn planck_at(kelvin: f64) -> impl Fn(f64) -> f64 {
    planck(kelvin, C2_NM_K)
}

/// Illuminant A (ISO/CIE 11664-2): Planck's law with the constants of its definition.
pub(super) fn illuminant_a<S: Sampled>() -> S {
    S::build(&planck(T_A_K, C2_A_NM_K))
}

/// The exponentials are taken as a quotient, so that they do not overflow at low temperatures.
fn planck(kelvin: f64, c2_nm_k: f64) -> impl Fn(f64) -> f64 {
    let x = move |nm: f64| c2_nm_k / (nm * kelvin);
    let unit = libm::expm1(-x(UNIT_NM));
    move |nm| {
        let ratio = UNIT_NM / nm;
        let fifth = ratio * ratio * ratio * ratio * ratio;
        let tails = unit / libm::expm1(-x(nm));
        fifth * libm::exp(x(UNIT_NM) - x(nm)) * tails
    }
}

/// The daylight that a D illuminant's name stands for: 65 for D65, of 6504 K. The factors of S1 and S2
/// are rounded to three decimals, as CIE did for its tables.
pub(super) fn daylight_named<S: Sampled>(hundreds: f64) -> S {
    let (m1, m2) = daylight_factors(hundreds * 100.0 * C2_TABLED / C2_NAMED);
    daylight_sum(libm::round(m1 * 1000.0) / 1000.0, libm::round(m2 * 1000.0) / 1000.0)
}

/// Daylight of a correlated colour temperature of 4000 … 25000 K (CIE 15:2004, section 3.1), 1 at
/// 560 nm. The factors of S1 and S2 are not rounded: there are no steps between near temperatures.
pub(super) fn daylight<S: Sampled>(cct_k: f64) -> S {
    let (m1, m2) = daylight_factors(cct_k);
    daylight_sum(m1, m2)
}

fn daylight_sum<S: Sampled>(m1: f64, m2: f64) -> S {
    let [(nm, s0), (_, s1), (_, s2)] = &*DAYLIGHT;
    let values: Vec<f64> =
        s0.iter().zip(s1).zip(s2).map(|((s0, s1), s2)| (s0 + s1 * m1 + s2 * m2) / 100.0).collect();
    S::linear(nm, &values, Outside::Zero).expect("the components are tables")
}

/// M1 and M2, the amounts of S1 and S2.
fn daylight_factors(cct_k: f64) -> (f64, f64) {
    let (x, y) = daylight_xy(cct_k);
    let m = 0.0241 + 0.2562 * x - 0.7341 * y;
    let m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / m;
    let m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / m;
    (m1, m2)
}

/// The chromaticity of daylight of a correlated colour temperature in K.
fn daylight_xy(cct_k: f64) -> (f64, f64) {
    let t = 1000.0 / cct_k;
    let x = if cct_k <= 7000.0 {
        ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244_063
    } else {
        ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237_040
    };
    (x, -3.000 * x * x + 2.870 * x - 0.275)
}

/// A Gaussian with peak 1. One narrower than 10 nm is projected like a fine table, which keeps its
/// integral; its greatest sample is then below 1.
pub(super) fn gaussian<S: Sampled>(centre_nm: f64, fwhm_nm: f64) -> S {
    let sigma = fwhm_nm / FWHM_PER_SIGMA;
    let value = |nm: f64| {
        let z = (nm - centre_nm) / sigma;
        libm::exp(-0.5 * z * z)
    };
    if fwhm_nm >= SAMPLED_FWHM_NM {
        return S::build(&value);
    }
    // 8 standard deviations on each side, 32 points in each: both beyond the digits of f64 in the sum.
    const SIDE: i32 = 8 * 32;
    let nm: Vec<f64> = (-SIDE..=SIDE).map(|i| centre_nm + sigma * f64::from(i) / 32.0).collect();
    let values: Vec<f64> = nm.iter().map(|nm| value(*nm)).collect();
    S::tabled(&nm, &values, Outside::Zero).expect("a Gaussian is a table")
}

/// A line with power 1: where it lies on a sample, that is 1/5 per nm.
pub(super) fn line<S: Sampled>(nm: f64) -> S {
    S::lined(&[(nm, 1.0)]).expect("a line in the grid")
}
