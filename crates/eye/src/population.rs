//! People differ: eyes of a population.

use crate::eye::{Eye, MAX_SHIFT_NM};

/// The standard deviations of people: of the densities of lens, macula, and the pigments of L, M and S in parts, of their peaks in nm.
///
/// Y. Asano, M. D. Fairchild, L. Blondé, "Individual Colorimetric Observer Model", PLOS ONE 11(2), 2016, as restated in programs.
pub const ASANO: [f64; 8] = [0.191, 0.372, 0.179, 0.179, 0.147, 4.0, 3.0, 2.5];

/// The least density in parts of the usual: a normal distribution has no end.
const LEAST: f64 = 0.05;

impl Eye {
    /// A person of the same age and field who differs from the mean by so many standard deviations of people: in the densities of lens
    /// and macula, in those of the pigments of L, M and S, and in their peaks.
    ///
    /// ```
    /// use glanz_eye::Eye;
    ///
    /// let mean = Eye::default();
    /// assert_eq!(mean.individual([0.0; 8]), mean);
    /// let other = mean.individual([1.0, -0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    /// assert!((other.lens_density - 1.191).abs() < 1e-12 && other.shift_nm[0] == 4.0);
    /// assert!(other.check().is_ok());
    /// ```
    #[must_use]
    pub fn individual(&self, deviations: [f64; 8]) -> Self {
        let part = |usual: f64, i: usize| (usual * (1.0 + ASANO[i] * deviations[i])).clamp(LEAST, 3.0);
        let shift = |c: usize| {
            (self.shift_nm[c] + ASANO[5 + c] * deviations[5 + c]).clamp(-MAX_SHIFT_NM, MAX_SHIFT_NM)
        };
        Self {
            lens_density: part(self.lens_density, 0),
            macula_density: part(self.macula_density, 1),
            pigment_density: [0, 1, 2].map(|c| part(self.pigment_density[c], 2 + c)),
            shift_nm: [0, 1, 2].map(shift),
            ..self.clone()
        }
    }
}
