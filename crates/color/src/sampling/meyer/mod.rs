//! Meyer's four samples: light and reflectance at four wavelengths instead of all.
//!
//! **Formula.** A, C1, C2 are sums of weighted samples at 456.4, 490.9, 557.7 and 631.4 nm, XYZ follow by the
//! inverse of [`XYZ_TO_AC1C2`], divided by 1.057863 so that the constant
//! spectrum 1 has Y = 1.
//!
//! **Where the numbers come from.** The nodes are those of the Gauss quadrature whose weight functions are the
//! curves of A, C1 and C2; [`gauss()`] recomputes them. C1 (two nodes) gives 490.88 and 631.44 nm, C2 (one
//! node) 456.43 nm; the middle one of A's three nodes is 557.76 nm, and A's outer two are moved to C1's, with
//! weights that keep its first three moments. In often copied source code C1's .31824 stands under 557.7 nm:
//! wrong, it belongs to 490.9 nm. The constant spectrum cannot tell the two apart; the curve's higher
//! moments can, and a test holds it.
//!
//! **Limits.** Four samples do not beat RGB in general. Over the 24 patches of the ColorChecker, with the white
//! computed alike, the mean ΔE00 is about 3 under E and D65 but near 10 under A; lights with lines fare
//! worse. With weights re-solved for the light ([`MeyerSamples::adapted`]) it is 2 to 3 under all of these.
//!
//! **Source.** G. W. Meyer, "Wavelength Selection for Synthetic Image Generation", CVGIP 41:57–79, 1988.
//!
//! ```
//! use glanz_color::meyer::{MeyerSamples, curves, gauss, sample};
//! use glanz_color::{Spectrum, light};
//!
//! // Four numbers for a spectrum; the constant one has Y = 1.
//! let [_, y, _] = MeyerSamples::published().xyz(sample(&Spectrum::ONE));
//! assert!((y - 1.0).abs() < 1e-5);
//! // The wavelengths are the nodes of a Gauss quadrature: those of C1 are 490.9 and 631.4 nm.
//! let nodes = gauss(&curves()[1], 2).expect("C1 has a rule of two nodes").nodes_nm;
//! assert!((nodes[0] - 490.88).abs() < 0.01 && (nodes[1] - 631.44).abs() < 0.01);
//! # Ok::<_, glanz_color::UnknownName>(())
//! ```

mod gauss;
mod interpolants;
#[cfg(test)]
mod tests;

use crate::measures::chromaticity::cie1931;
use crate::models::{AC1C2_TO_XYZ, XYZ_TO_AC1C2};
use crate::observers::cie1931_by_1_nm;
use crate::spectra::Spectrum;

pub use gauss::{GaussError, MOST_NODES, Rule, gauss};
pub use interpolants::interpolants;

/// Meyer's wavelengths in nm.
pub const NODES_NM: [f64; 4] = [456.4, 490.9, 557.7, 631.4];

/// Meyer's weights of the samples for A, C1 and C2, C1's first one in its right place.
pub const PUBLISHED: [[f64; 4]; 3] =
    [[0.0, 0.188_92, 0.674_93, 0.192_53], [0.0, 0.318_24, 0.0, -0.460_08], [0.546_40, 0.0, 0.0, 0.0]];

/// The Y that the published weights give the constant spectrum 1.
const PUBLISHED_Y: f64 = 1.057_863;

/// The unit of wavelength in which the integrals of the curves are the published weights, in nm:
/// Σ ȳ = 106.8564 nm is 1.0580 of it.
const PUBLISHED_UNIT_NM: f64 = 101.0;

/// A value at each of the four wavelengths, interpolated linearly.
pub fn sample(spectrum: &Spectrum) -> [f64; 4] {
    NODES_NM.map(|nm| spectrum.at(nm))
}

/// XYZ from samples at the four wavelengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeyerSamples {
    /// What each sample counts for X, Y and Z.
    pub weights: [[f64; 4]; 3],
}

impl MeyerSamples {
    /// The published weights. Samples are those of **light that reaches the eye**, light times reflectance.
    ///
    /// XYZ come on the scale where the light of value 1 at all wavelengths has Y = 1; for colours relative to
    /// a white, divide by the Y of the white's samples.
    pub fn published() -> Self {
        let columns: [[f64; 3]; 4] =
            core::array::from_fn(|node| AC1C2_TO_XYZ.apply(core::array::from_fn(|row| PUBLISHED[row][node])));
        Self { weights: core::array::from_fn(|row| core::array::from_fn(|i| columns[i][row] / PUBLISHED_Y)) }
    }

    /// Weights re-solved for a light. Samples are those of the **reflectance** alone.
    ///
    /// The same scale as [`published`](Self::published); the white surface has exactly the light's XYZ. The
    /// weights are those that reconstruct the reflectance by [`interpolants`] and integrate it with the
    /// light and the CIE 1931 observer in full, so a light's lines count whole.
    pub fn adapted(light: &Spectrum) -> Self {
        let scale = 1.0 / cie1931()[1].integral();
        let weight = |curve: &Spectrum| interpolants().map(|basis| basis.dot(&(*light * *curve)) * scale);
        Self { weights: cie1931().map(weight) }
    }

    /// XYZ of four samples.
    pub fn xyz(&self, samples: [f64; 4]) -> [f64; 3] {
        self.weights.map(|row| row.iter().zip(samples).map(|(weight, sample)| weight * sample).sum())
    }
}

/// The curves of A, C1 and C2: wavelength in nm and value, 380 to 780 nm by 1 nm, in the unit of the
/// published weights, so that their sums are the sums of the weights.
pub fn curves() -> [Vec<(f64, f64)>; 3] {
    let seen = || cie1931_by_1_nm().iter().filter(|(nm, _)| (380.0..=780.0).contains(nm));
    core::array::from_fn(|row| {
        seen().map(|(nm, xyz)| (*nm, XYZ_TO_AC1C2.apply(*xyz)[row] / PUBLISHED_UNIT_NM)).collect()
    })
}
