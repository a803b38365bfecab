//! Three spectra that stand for R, G and B.

use std::sync::LazyLock;

use super::rgb_of_reflectance;
use crate::algebra::Matrix3;
use crate::spectra::table::Table;
use crate::spectra::{Outside, Spectrum};

/// The reflectances of the sRGB primaries: R · first + G · second + B · third is a reflectance of that linear
/// RGB.
///
/// **Source.** I. Mallett and C. Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance",
/// EGSR 2019: 380 to 780 nm by 5 nm, from colour-science 0.4.7; the values at 380 nm are held below.
///
/// **Laws.** The three sum to 1 at every wavelength (to rounding), so white is the perfect diffuser and a mix
/// of RGB in 0 … 1 lies in 0 … 1. The authors solved for their own sums; here the three are mixed anew, by
/// a matrix that differs from the identity by 1e-3, so that the round trip under D65 is exact to
/// rounding on this grid; that mixing keeps the sum.
///
/// **Limits.** Other than the sRGB gamut has no such basis. Ultraviolet is held, not known.
pub fn mallett_yuksel_basis() -> &'static [Spectrum; 3] {
    static BASIS: LazyLock<[Spectrum; 3]> = LazyLock::new(|| {
        let published = published();
        let response = Matrix3::from_columns(published.each_ref().map(|basis| rgb_of_reflectance(basis).0));
        let [r, g, b] = published;
        response.inverse().transposed().0.map(|[x, y, z]| r * x + g * y + b * z)
    });
    &BASIS
}

/// The published spectra, divided by their sum, which is 1 to the digits given.
fn published() -> [Spectrum; 3] {
    let table = Table::parse(include_str!("../../../data/mallett_yuksel.csv"));
    let [r, g, b] = ["r", "g", "b"]
        .map(|name| table.spectrum(name, Outside::Hold).expect("the table has the columns r, g and b"));
    let sum = r + g + b;
    [r, g, b].map(|basis| Spectrum(core::array::from_fn(|i| basis[i] / sum[i])))
}
