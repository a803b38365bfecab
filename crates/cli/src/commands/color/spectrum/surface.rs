//! The numbers of a surface.

use glanz_color::chromaticity::Chromaticity;
use glanz_color::colorimetry::{DisplayColor, lab, relative_xyz};
use glanz_color::difference::ciede2000;
use glanz_color::models::Lab;
use glanz_color::{Observer, ObserverKind};
use serde_json::json;

use super::{Facts, coarse_facts, color_facts, hue_facts, response_facts, screen_facts};
use crate::input::spectra::Source;

/// All that is told of a surface.
pub(super) fn surface_facts(facts: &mut Facts, source: &Source, light: &Source, observer: &Observer) {
    let seen = &source.fine * &light.fine;
    facts.value("kind", "surface");
    facts.value("under", light.name.as_str());
    facts.line("under", format!("{}, {}", light.name, light.title));
    if observer.kind != ObserverKind::Xyz {
        response_facts(facts, &seen, Some(&light.fine), observer);
    }
    let white = relative_xyz(&light.fine, &light.fine, observer);
    let color = relative_xyz(&seen, &light.fine, observer).zip(white);
    if let Some((xyz, white)) = color {
        color_facts(facts, xyz, white);
        if let Some(screen) = DisplayColor::adapted(xyz, white) {
            screen_facts(facts, screen, &format!("adapted from {}", light.name));
        }
    } else if observer.kind == ObserverKind::Xyz {
        facts.line("XYZ", "none: the observer does not see this light");
    }
    if let Some(white) = Chromaticity::of_light(&light.fine) {
        hue_facts(facts, &seen, white, &light.name);
    }
    if let Some((xyz, white)) = color {
        drawn_surface_facts(facts, source, light, lab(xyz, white), observer);
        if let Some(coarse) = &source.coarse
            && let Some(smooth) = relative_xyz(&(&coarse.smooth * &light.fine), &light.fine, observer)
        {
            coarse_facts(facts, coarse, ciede2000(lab(xyz, white), lab(smooth, white)));
        }
    }
}

/// What drawing a surface by 5 nm costs: each colour to the white of its own sums.
fn drawn_surface_facts(facts: &mut Facts, source: &Source, light: &Source, told: Lab, observer: &Observer) {
    let (white, seen) = (light.spectrum, source.spectrum * light.spectrum);
    if let (Some(white), Some(xyz)) =
        (relative_xyz(&white, &white, observer), relative_xyz(&seen, &white, observer))
    {
        let de2000 = ciede2000(told, lab(xyz, white));
        facts.value("drawn_by_5_nm", json!({ "de2000": de2000 }));
        facts.line("drawn by 5 nm", format!("ΔE00 {de2000:.2}"));
    }
}
