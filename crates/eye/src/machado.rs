//! Dichromacy as many programs show it: a matrix on the linear light of a screen.

use glanz_color::Matrix3;

use crate::Cones;

/// The matrix on linear sRGB by which G. M. Machado, M. M. Oliveira and L. A. F. Fernandes ("A Physiologically-based Model for Simulation of
/// Color Vision Deficiency", IEEE TVCG 15(6), 2009) show what is seen without a kind of cones, at severity 1; none where none or all are
/// missing.
///
/// For comparison: it knows neither spectra nor the eye's age, and white alone stays what it is. On the patches of the ColorChecker it is
/// 2.4 (protan), 1.8 (deutan) and 4.5 (tritan) ΔE00 from the projection of true cones, up to 12.
///
/// ```
/// use glanz_eye::{Cones, machado};
///
/// let [r, g, b] = machado(Cones::NoM).expect("a kind is missing").apply([1.0; 3]);
/// assert!((r - 1.0).abs() < 1e-5 && (g - 1.0).abs() < 1e-5 && (b - 1.0).abs() < 1e-5);
/// assert!(machado(Cones::All).is_none());
/// ```
pub fn machado(cones: Cones) -> Option<Matrix3> {
    Some(Matrix3(match cones {
        Cones::NoL => [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        Cones::NoM => {
            [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
        }
        Cones::NoS => [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
        Cones::All | Cones::None => return None,
    }))
}
