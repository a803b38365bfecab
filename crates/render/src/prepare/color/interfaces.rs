//! What boundaries, films, panes and coats do to each wavelength at an angle.

use glanz_bsdf::terms::{
    fresnel_conductor, fresnel_dielectric, fresnel_film, fresnel_polarized, fresnel_slab,
};
use glanz_color::{Ior, Spectrum, lambda_nm};
use glanz_scene::{Film, Pane, Polarization};

use crate::prepare::data::tint_coordinate::cosine_inside;

/// What a boundary between air and a medium reflects.
pub(crate) fn boundary(ior: &Ior, cosine: f64) -> Spectrum {
    Spectrum(core::array::from_fn(|i| match ior.k[i] {
        0.0 => fresnel_dielectric(cosine, ior.eta[i]),
        k => fresnel_conductor(cosine, ior.eta[i], k),
    }))
}

/// The same of light of one polarisation.
pub(crate) fn polarized(ior: &Ior, polarization: Polarization, cosine: f64) -> Spectrum {
    Spectrum(core::array::from_fn(|i| {
        let (s, p) = fresnel_polarized(cosine, ior.eta[i], ior.k[i]);
        if polarization == Polarization::S { s } else { p }
    }))
}

/// What a film reflects, interference included.
pub(crate) fn film(film: &Film, cosine: f64) -> Spectrum {
    let base = |i: usize| (film.base.eta[i], film.base.k[i]);
    Spectrum(core::array::from_fn(|i| {
        fresnel_film(cosine, lambda_nm(i), film.film.eta[i], film.thickness_nm, base(i))
    }))
}

/// What a pane reflects and what it lets through.
pub(crate) fn pane(pane: &Pane, cosine: f64) -> (Spectrum, Spectrum) {
    let depth = pane.absorption * pane.thickness;
    let (mut reflected, mut transmitted) = (Spectrum::ZERO, Spectrum::ZERO);
    for (i, depth) in depth.0.iter().enumerate() {
        let eta = pane.ior.eta[i];
        let left = libm::exp(-depth / cosine_inside(cosine, eta));
        (reflected.0[i], transmitted.0[i]) = fresnel_slab(cosine, eta, left);
    }
    (reflected, transmitted)
}

/// What is left on a path of so many times the thickness of this optical depth.
pub(crate) fn left(depth: &Spectrum, path: f64) -> Spectrum {
    depth.map(|depth| libm::exp(-depth * path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clear_pane_takes_nothing_and_a_coloured_one_what_beer_and_lambert_say() {
        let mut glass = Pane { ior: Ior::constant(1.5), thickness: 0.004, absorption: Spectrum::ZERO };
        for cosine in [1.0, 0.7, 0.2] {
            let (r, t) = pane(&glass, cosine);
            assert!((r[50] + t[50] - 1.0).abs() < 1e-12);
        }
        // Both sides of clear glass reflect 2F / (1 + F).
        assert!((pane(&glass, 1.0).0[50] - 0.08 / 1.04).abs() < 1e-12);
        glass.absorption = Spectrum::constant(100.0);
        let left = libm::exp(-0.4);
        let expected = 0.96 * 0.96 * left / (1.0 - 0.04 * 0.04 * left * left);
        assert!((pane(&glass, 1.0).1[50] - expected).abs() < 1e-12);
    }

    #[test]
    fn a_path_runs_steeper_inside() {
        assert!((cosine_inside(0.5, 1.5) - libm::sqrt(1.0 - 0.75 / 2.25)).abs() < 1e-15);
        assert_eq!(cosine_inside(1.0, 1.5), 1.0);
    }
}
