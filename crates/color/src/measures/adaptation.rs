//! Chromatic adaptation: what XYZ under one white would be under another.
//!
//! All three methods are von Kries's rule of 1902, each cone's signal scaled by the ratio of the whites,
//! and differ in the matrix from XYZ to the cones. Adaptation is full; incomplete adaptation belongs to
//! the eye.
//!
//! ```
//! use glanz_color::adaptation::Adaptation;
//! use glanz_color::models::Xyz;
//!
//! // From D65 to the D50 of print.
//! let (d65, d50) = (Xyz([0.95047, 1.0, 1.08883]), Xyz([0.96422, 1.0, 0.82521]));
//! let matrix = Adaptation::Bradford.matrix(d65, d50)?;
//! // Lindbloom's first entry, and white becomes white.
//! assert!((matrix.0[0][0] - 1.0478112).abs() < 1e-6);
//! assert!((matrix.apply(d65.0)[2] - d50.0[2]).abs() < 1e-12);
//! # Ok::<_, glanz_color::AdaptationError>(())
//! ```

use crate::algebra::Matrix3;
use crate::models::Xyz;
use crate::models::cones::adaptation_matrix;

pub use crate::models::cones::{BRADFORD, CAT16, HUNT_POINTER_ESTEVEZ_D65};

/// A method of full chromatic adaptation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Adaptation {
    /// The matrix [`BRADFORD`].
    Bradford,
    /// The matrix [`CAT16`] with degree of adaptation 1 and the whites' luminance kept apart.
    Cat16,
    /// The matrix [`HUNT_POINTER_ESTEVEZ_D65`]: plain cones.
    VonKries,
}

/// A white that no eye can adapt to.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("expected a white whose three cone signals are positive, found {cones:?} for XYZ {xyz:?}")]
pub struct AdaptationError {
    /// The white.
    pub xyz: [f64; 3],
    /// What the cones of the method make of it.
    pub cones: [f64; 3],
}

impl Adaptation {
    /// The three methods.
    pub const ALL: [Self; 3] = [Self::Bradford, Self::Cat16, Self::VonKries];

    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bradford => "bradford",
            Self::Cat16 => "cat16",
            Self::VonKries => "von-kries",
        }
    }

    /// The method of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// XYZ to the method's cones.
    pub const fn cones(self) -> Matrix3 {
        match self {
            Self::Bradford => BRADFORD,
            Self::Cat16 => CAT16,
            Self::VonKries => HUNT_POINTER_ESTEVEZ_D65,
        }
    }

    /// The matrix that takes XYZ under the white `from` to XYZ under the white `to`.
    ///
    /// Scales of the whites count: to keep luminance, give both the same Y.
    ///
    /// # Errors
    ///
    /// A white whose cone signals are not all positive and finite.
    pub fn matrix(self, from: Xyz, to: Xyz) -> Result<Matrix3, AdaptationError> {
        for Xyz(xyz) in [from, to] {
            let cones = self.cones().apply(xyz);
            if !cones.iter().all(|&signal| signal > 0.0 && signal.is_finite()) {
                return Err(AdaptationError { xyz, cones });
            }
        }
        Ok(adaptation_matrix(&self.cones(), from.0, to.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Xyz = Xyz([1.098_50, 1.0, 0.355_85]);
    const D65: Xyz = Xyz([0.950_47, 1.0, 1.088_83]);
    const D50: Xyz = Xyz([0.964_22, 1.0, 0.825_21]);

    #[test]
    fn the_white_becomes_the_other_white() {
        for method in Adaptation::ALL {
            let adapted = method.matrix(A, D65).unwrap().apply(A.0);
            for (found, expected) in adapted.iter().zip(D65.0) {
                assert!((found - expected).abs() < 1e-14, "{method:?} {adapted:?}");
            }
        }
    }

    #[test]
    fn bradford_from_d65_to_d50_is_lindblooms_matrix() {
        // Lindbloom, "Chromatic Adaptation", 2017, to the seven digits printed.
        let printed = [
            [1.047_811_2, 0.022_886_6, -0.050_127_0],
            [0.029_542_4, 0.990_484_4, -0.017_049_1],
            [-0.009_234_5, 0.015_043_6, 0.752_131_6],
        ];
        let found = Adaptation::Bradford.matrix(D65, D50).unwrap();
        for (row, expected) in found.0.iter().flatten().zip(printed.iter().flatten()) {
            assert!((row - expected).abs() < 1e-7, "{found:?}");
        }
    }

    #[test]
    fn cat16_from_a_to_d65_is_the_matrix_of_colour_science() {
        // colour-science 0.4.7, matrix_chromatic_adaptation_VonKries with "CAT16".
        let printed = [
            [0.950_689_405, -0.187_376_349, 0.262_790_607],
            [-0.025_665_231, 1.032_306_743, -0.011_559_609],
            [-0.002_740_639, 0.090_967_452, 2.812_626_498],
        ];
        let found = Adaptation::Cat16.matrix(A, D65).unwrap();
        for (found, expected) in found.0.iter().flatten().zip(printed.iter().flatten()) {
            assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
        }
    }

    #[test]
    fn a_white_without_blue_is_refused() {
        let error = Adaptation::VonKries.matrix(Xyz([1.0, 1.0, 0.0]), D65).unwrap_err();
        assert!(error.to_string().contains("positive"));
        assert!(Adaptation::Bradford.matrix(D65, Xyz([f64::NAN; 3])).is_err());
    }

    #[test]
    fn every_method_is_found_by_its_name() {
        for method in Adaptation::ALL {
            assert_eq!(Adaptation::from_name(method.name()), Some(method));
        }
        assert_eq!(Adaptation::from_name("sharp"), None);
    }
}
