//! Re-radiation: light that comes back at another wavelength than it came in.

use crate::spectrum::{SAMPLES, Spectrum};

/// A Donaldson matrix: the spectral radiance factor from each wavelength of incidence to each of
/// emission.
///
/// Entry `[out][in]` is what one unit of light in the band of 5 nm around `in` gives in the band of 5
/// nm around `out`. The diagonal is ordinary reflectance.
#[derive(Clone, Debug, PartialEq)]
pub struct Reradiation {
    entries: Box<[[f64; SAMPLES]]>,
}

impl Reradiation {
    /// Ordinary reflection: nothing but a diagonal.
    pub fn diagonal(reflectance: &Spectrum) -> Self {
        Self::from_fn(|out, input| if out == input { reflectance[out] } else { 0.0 })
    }

    /// The matrix of `f(out, in)`, both numbers of samples of the grid.
    pub fn from_fn(mut f: impl FnMut(usize, usize) -> f64) -> Self {
        Self { entries: (0..SAMPLES).map(|out| core::array::from_fn(|input| f(out, input))).collect() }
    }

    /// One entry.
    pub fn get(&self, out: usize, input: usize) -> f64 {
        self.entries[out][input]
    }

    /// The light that comes back: L(out) = Σ M\[out, in\] E(in).
    pub fn apply(&self, light: &Spectrum) -> Spectrum {
        Spectrum(core::array::from_fn(|out| {
            self.entries[out].iter().zip(&light.0).map(|(entry, e)| entry * e).sum()
        }))
    }
}
