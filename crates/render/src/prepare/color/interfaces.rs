//! What boundaries, films, panes and coats do to each wavelength at an angle.

use glanz_bsdf::terms::{
    fresnel_conductor, fresnel_dielectric, fresnel_film, fresnel_polarized, fresnel_slab,
};
use glanz_bsdf::{coat_reflectance, coated_reflectance};
use glanz_color::{Ior, Spectrum, lambda_nm};
use glanz_scene::{Boundary, CoatedBoundary, Film, Pane, Polarization};

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

/// What a boundary below a coat reflects, without what the coat itself reflects; `left` is what absorption in the coat leaves
/// on the way down and up. Inside of the coat indices count relative to the coat's, and so does a film's thickness, by which
/// the phase is as in air.
pub(crate) fn coated(boundary: &CoatedBoundary, cosine: f64, left: &Spectrum) -> Spectrum {
    let on_top = coat_reflectance(boundary.eta(), boundary.alpha, cosine);
    let coat = &boundary.coat.eta;
    let relative = |ior: &Ior| {
        let over = |part: &Spectrum| Spectrum(core::array::from_fn(|i| part[i] / coat[i]));
        (over(&ior.eta), over(&ior.k))
    };
    let inside = |i: usize| cosine_inside(cosine, coat[i]);
    let below = match &boundary.below {
        Boundary::Medium(ior) => {
            let (eta, k) = relative(ior);
            Spectrum(core::array::from_fn(|i| match k[i] {
                0.0 => fresnel_dielectric(inside(i), eta[i]),
                k => fresnel_conductor(inside(i), eta[i], k),
            }))
        }
        Boundary::Polarized(ior, polarization) => {
            let (eta, k) = relative(ior);
            Spectrum(core::array::from_fn(|i| {
                let (s, p) = fresnel_polarized(inside(i), eta[i], k[i]);
                if *polarization == Polarization::S { s } else { p }
            }))
        }
        Boundary::Film(film) => {
            let ((eta, _), (base, k)) = (relative(&film.film), relative(&film.base));
            Spectrum(core::array::from_fn(|i| {
                let thickness = film.thickness_nm * coat[i];
                fresnel_film(inside(i), lambda_nm(i), eta[i], thickness, (base[i], k[i]))
            }))
        }
    };
    Spectrum(core::array::from_fn(|i| coated_reflectance(on_top, below[i] * left[i])))
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
    use std::sync::Arc;

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

    /// |(m − n − i k) / (m + n + i k)|² at normal incidence from a medium of index m.
    fn at_normal(ior: &Ior, m: f64, nm: f64) -> f64 {
        let (n, k) = (ior.eta.at(nm), ior.k.at(nm));
        ((m - n) * (m - n) + k * k) / ((m + n) * (m + n) + k * k)
    }

    #[test]
    fn a_metal_under_a_coat_meets_the_coat() {
        let copper = glanz_color::ior("Cu").expect("copper is known");
        let below = Boundary::Medium(Arc::new(copper.clone()));
        let boundary = CoatedBoundary { below, coat: Ior::constant(1.5), alpha: 0.001 };
        let got = coated(&boundary, 1.0, &Spectrum::ONE);
        let half = coated(&boundary, 1.0, &Spectrum::constant(0.5));
        // The coat's own 0.04 lies on top. From copper's table, linear in n and k: 0.5383, 0.6235, 0.9352 in air.
        for (nm, published) in [(450.0, 0.4506), (550.0, 0.5426), (650.0, 0.9121)] {
            let r = at_normal(&copper, 1.5, nm);
            let whole = 0.04 + 0.96 * 0.96 * r / (1.0 - 0.04 * r);
            assert!((got.at(nm) + 0.04 - whole).abs() < 1e-5, "{nm}: {} for {whole}", got.at(nm) + 0.04);
            assert!((whole - published).abs() < 1e-3, "{nm}: {whole}");
            // What absorbs takes its part of every way down and up.
            let dimmed = 0.96 * 0.96 * 0.5 * r / (1.0 - 0.04 * 0.5 * r);
            assert!((half.at(nm) - dimmed).abs() < 1e-5, "{nm}: {} for {dimmed}", half.at(nm));
        }
    }

    #[test]
    fn what_is_as_the_coat_reflects_nothing_below_it() {
        let glass = Boundary::Medium(Arc::new(Ior::constant(1.5)));
        let oil = Film { thickness_nm: 400.0, film: Ior::constant(1.5), base: Ior::constant(1.5) };
        for below in [glass, Boundary::Film(Arc::new(oil))] {
            let boundary = CoatedBoundary { below, coat: Ior::constant(1.5), alpha: 0.001 };
            for cosine in [1.0, 0.5, 0.1] {
                assert!(coated(&boundary, cosine, &Spectrum::ONE).max() < 1e-12);
            }
        }
    }

    #[test]
    fn a_film_below_a_coat_is_one_between_both() {
        // A film whose ends have the same index as the coat and the base is the boundary of both.
        let base = glanz_color::ior("Al").expect("aluminium is known");
        let film = Film { thickness_nm: 500.0, film: Ior::constant(1.5), base: base.clone() };
        let under = |below| CoatedBoundary { below, coat: Ior::constant(1.5), alpha: 0.001 };
        for cosine in [1.0, 0.6, 0.2] {
            let with = coated(&under(Boundary::Film(Arc::new(film.clone()))), cosine, &Spectrum::ONE);
            let bare = coated(&under(Boundary::Medium(Arc::new(base.clone()))), cosine, &Spectrum::ONE);
            for i in 0..glanz_color::SAMPLES {
                assert!((with[i] - bare[i]).abs() < 1e-9, "{cosine}: {} {}", with[i], bare[i]);
            }
        }
        let (s, p) = (Polarization::S, Polarization::P);
        let polarized = |way| {
            coated(&under(Boundary::Polarized(Arc::new(base.clone()), way)), 0.3, &Spectrum::ONE).at(550.0)
        };
        assert!(polarized(s) > polarized(p));
    }

    #[test]
    fn a_path_runs_steeper_inside() {
        assert!((cosine_inside(0.5, 1.5) - libm::sqrt(1.0 - 0.75 / 2.25)).abs() < 1e-15);
        assert_eq!(cosine_inside(1.0, 1.5), 1.0);
    }
}
