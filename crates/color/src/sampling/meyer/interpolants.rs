//! A reflectance from its values at Meyer's four wavelengths.

use std::sync::LazyLock;

use super::NODES_NM;
use crate::algebra::solve;
use crate::spectra::Spectrum;

/// Over how many nm reflectances of surfaces keep alike. Between 40 and 60 nm the error over the
/// ColorChecker changes by less than 0.1 ΔE00 under E, D65, A, FL2 and FL11.
const ALIKE_NM: f64 = 50.0;

/// The best linear guess of a reflectance from four samples: it is Σ sample · interpolant.
///
/// Reflectances are taken as random functions of unknown mean whose likeness falls with the distance of
/// wavelengths as a Gaussian of 50 nm; of all sums that reproduce constants this one has the least expected
/// square error (ordinary kriging, Matheron 1963). Their sum is 1 at each wavelength, and each is 1 at its
/// own wavelength and 0 at the other three.
pub fn interpolants() -> &'static [Spectrum; 4] {
    static BASIS: LazyLock<[Spectrum; 4]> = LazyLock::new(|| {
        let mut basis = [Spectrum::ZERO; 4];
        for (i, (nm, _)) in Spectrum::ZERO.points().enumerate() {
            let values = at(nm);
            for (spectrum, value) in basis.iter_mut().zip(values) {
                spectrum.0[i] = value;
            }
        }
        basis
    });
    &BASIS
}

/// The four interpolants at a wavelength in nm.
pub(super) fn at(nm: f64) -> [f64; 4] {
    let matrix = core::array::from_fn(|row| core::array::from_fn(|column| entry(row, column)));
    let right = core::array::from_fn(|row| NODES_NM.get(row).map_or(1.0, |node| likeness(*node, nm)));
    let solved: [f64; 5] = solve(matrix, right).expect("four different wavelengths are independent");
    core::array::from_fn(|i| solved[i])
}

/// Likeness of the samples, bordered by the condition that the weights sum to 1.
fn entry(row: usize, column: usize) -> f64 {
    match (NODES_NM.get(row), NODES_NM.get(column)) {
        (Some(a), Some(b)) => likeness(*a, *b),
        (None, None) => 0.0,
        _ => 1.0,
    }
}

fn likeness(a_nm: f64, b_nm: f64) -> f64 {
    let distance = (a_nm - b_nm) / ALIKE_NM;
    libm::exp(-0.5 * distance * distance)
}
