//! The colours of lights and surfaces, in words and as JSON.

use std::sync::Arc;

use glanz_color::{Rgb, Spectrum, rgb_spectra};
use glanz_scene::{Boundary, CoatedBoundary, LightColor, Polarization, Tint};
use serde_json::{Value, json};

use glanz_plot::number;

/// A light's colour for people: in RGB, and where it is a spectrum.
pub(super) fn light_text(color: &LightColor) -> String {
    match color {
        LightColor::Rgb(rgb) => rgb_text(rgb.0.map(f64::from)),
        LightColor::Spectrum(spectrum) => {
            format!("{} (a spectrum)", rgb_text(rgb_spectra::rgb_of_light(spectrum)))
        }
    }
}

/// A light's colour for programs.
pub(super) fn light_json(color: &LightColor) -> Value {
    match color {
        LightColor::Rgb(rgb) => json!(rgb),
        LightColor::Spectrum(spectrum) => spectrum_json(spectrum),
    }
}

/// A tint for people.
pub(super) fn tint_text(tint: &Tint) -> String {
    match tint {
        Tint::Rgb(rgb) => rgb_text(rgb.0.map(f64::from)),
        Tint::Spectrum(spectrum) => {
            format!("{} under D65 (a spectrum)", rgb_text(rgb_spectra::rgb_of_reflectance(spectrum)))
        }
        Tint::Reradiation(matrix) => {
            let sent = matrix.apply(&rgb_spectra::daylight());
            format!("{} under D65 (fluorescent)", rgb_text(rgb_spectra::rgb_of_light(&sent)))
        }
        Tint::Ior(ior) => format!("Fresnel reflection of {}", ior.name),
        Tint::Polarized(ior, way) => {
            format!("Fresnel reflection of {}, {} polarised", ior.name, polarization(*way))
        }
        Tint::Schlick(at_normal) => format!("Schlick's Fresnel reflection from {}", tint_text(at_normal)),
        Tint::Film(film) => format!(
            "Fresnel reflection of {} nm of {} on {}",
            number(film.thickness_nm),
            film.film.name,
            film.base.name
        ),
        Tint::Coated(boundary) => {
            format!("{} under a coat of {}", tint_text(&below(boundary)), boundary.coat.name)
        }
        Tint::Pane(pane) => {
            format!("Fresnel reflection of a pane of {}, {} mm", pane.ior.name, number(pane.thickness * 1e3))
        }
    }
}

/// A tint for programs.
pub(super) fn tint_json(tint: &Tint) -> Value {
    match tint {
        Tint::Rgb(Rgb(channels)) => json!(channels),
        Tint::Spectrum(spectrum) => spectrum_json(spectrum),
        Tint::Reradiation(matrix) => {
            json!({ "reradiation": { "diagonal": matrix.reflectance().0.as_slice() } })
        }
        Tint::Ior(ior) => json!({ "ior": ior.name }),
        Tint::Polarized(ior, way) => json!({ "ior": ior.name, "polarization": polarization(*way) }),
        Tint::Schlick(at_normal) => json!({ "schlick": tint_json(at_normal) }),
        Tint::Film(film) => json!({ "film": {
            "thickness_nm": film.thickness_nm, "ior": film.film.name, "base": film.base.name,
        } }),
        Tint::Coated(boundary) => json!({ "coated": {
            "below": tint_json(&below(boundary)), "coat": boundary.coat.name, "alpha": boundary.alpha,
        } }),
        Tint::Pane(pane) => json!({ "pane": {
            "ior": pane.ior.name, "thickness_mm": pane.thickness * 1e3,
            "absorption_per_m": spectrum_json(&pane.absorption),
        } }),
    }
}

/// The tint that a boundary below a coat has in air.
fn below(boundary: &CoatedBoundary) -> Tint {
    match &boundary.below {
        Boundary::Medium(ior) => Tint::Ior(Arc::clone(ior)),
        Boundary::Polarized(ior, way) => Tint::Polarized(Arc::clone(ior), *way),
        Boundary::Film(film) => Tint::Film(Arc::clone(film)),
    }
}

fn polarization(way: Polarization) -> &'static str {
    match way {
        Polarization::S => "s",
        Polarization::P => "p",
    }
}

fn spectrum_json(spectrum: &Spectrum) -> Value {
    json!({ "nm": { "first": glanz_color::FIRST_NM, "step": glanz_color::STEP_NM }, "value": spectrum.0.as_slice() })
}

fn rgb_text(channels: [f64; 3]) -> String {
    format!("({})", channels.map(number).join(", "))
}
