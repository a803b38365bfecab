//! The numbers of a light.

use glanz_color::chromaticity::Chromaticity;
use glanz_color::colorimetry::{DisplayColor, lab, relative_xyz};
use glanz_color::cri::color_rendering;
use glanz_color::difference::ciede2000;
use glanz_color::photometry::{Adapted, efficacy_lm_per_w, luminous};
use glanz_color::ssi::similarity;
use glanz_color::temperature::{MOST_DUV, color_temperature};
use glanz_color::tm30::{HueBin, evaluate, reference};
use glanz_color::{FineSpectrum, Observer, ObserverKind, fine_light};
use serde_json::{Value, json};

use super::{Facts, coarse_facts, color_facts, hue_facts, response_facts, screen_facts};
use crate::input::spectra::Source;
use crate::print::{finite, fixed, number};

/// All that is told of a light.
pub(super) fn light_facts(facts: &mut Facts, source: &Source, observer: &Observer) {
    let light = &source.fine;
    facts.value("kind", "light");
    if observer.kind != ObserverKind::Xyz {
        response_facts(facts, light, None, observer);
    }
    let d65 = fine_light("D65").expect("D65 comes with the library");
    if let (Some(xyz), Some(white)) =
        (relative_xyz(light, light, observer), relative_xyz(&d65, &d65, observer))
    {
        color_facts(facts, xyz, white);
        screen_facts(facts, DisplayColor::of_light(xyz), "as bright as it can be");
    } else if observer.kind == ObserverKind::Xyz {
        facts.line("XYZ", "none: the observer does not see this light");
    }
    hue_facts(facts, light, Chromaticity::E, "equal energy");
    temperature_facts(facts, light);
    power_facts(facts, source);
    drawn_light_facts(facts, source, &d65, observer);
}

/// What drawing a light by 5 nm costs.
fn drawn_light_facts(facts: &mut Facts, source: &Source, white: &FineSpectrum, observer: &Observer) {
    let (told, drawn) = (&source.fine, &source.spectrum);
    let (Some(first), Some(second), Some(white)) = (
        relative_xyz(told, told, observer),
        relative_xyz(drawn, drawn, observer),
        relative_xyz(white, white, observer),
    ) else {
        return;
    };
    let de2000 = ciede2000(lab(first, white), lab(second, white));
    let kelvin =
        |xy: Option<Chromaticity>| xy.and_then(|xy| color_temperature(xy).ok()).map(|found| found.cct_k);
    let shift = kelvin(Chromaticity::of_light(drawn)).zip(kelvin(Chromaticity::of_light(told)));
    let shift = shift.map(|(drawn, told)| drawn - told);
    let temperature = shift.map_or(String::new(), |shift| format!(", CCT {shift:+.1} K"));
    facts.value("drawn_by_5_nm", json!({ "de2000": de2000, "cct_shift_k": shift }));
    facts.line("drawn by 5 nm", format!("ΔE00 {de2000:.2}{temperature}"));
    if let Some(coarse) = &source.coarse
        && let Some(smooth) = relative_xyz(&coarse.smooth, &coarse.smooth, observer)
    {
        coarse_facts(facts, coarse, ciede2000(lab(first, white), lab(smooth, white)));
    }
}

fn temperature_facts(facts: &mut Facts, light: &FineSpectrum) {
    let Some(Ok(found)) = Chromaticity::of_light(light).map(color_temperature) else {
        facts.value("cct_k", Value::Null);
        facts.line("CCT", "none: no black body is near");
        return;
    };
    let far = found.duv.abs() > MOST_DUV;
    facts.value("cct_k", found.cct_k);
    facts.value("duv", found.duv);
    facts.value("cct_is_meaningful", !far);
    let warning = if far { " (too far from black bodies to mean much)" } else { "" };
    facts.line("CCT", format!("{:.1} K, Duv {:+.4}{warning}", found.cct_k, found.duv));
    if far {
        return;
    }
    match color_rendering(light) {
        Ok(rendering) => {
            facts.value("ra", rendering.ra);
            facts.value("r", rendering.r.to_vec());
            facts.line("Ra", format!("{:.1} (R9 {:.1})", rendering.ra, rendering.r[8]));
        }
        Err(error) => facts.line("Ra", format!("none: {error}")),
    }
    rendition_facts(facts, light);
}

/// TM-30, CIE 224 and the likeness to the reference.
fn rendition_facts(facts: &mut Facts, light: &FineSpectrum) {
    let Ok(found) = evaluate(light) else { return };
    let bin = |bin: &HueBin| json!({ "rf": bin.fidelity, "rcs": bin.chroma_shift, "rhs": bin.hue_shift });
    let bins: Vec<Value> = found.bins.iter().map(bin).collect();
    facts.value(
        "tm30",
        json!({ "rf": found.rf, "rg": found.rg, "rf_ces": found.samples.to_vec(), "bins": bins }),
    );
    let red = found.bins[0];
    let gamut = finite(found.rg).map_or_else(
        || "none (no sample has some of the hues under the reference)".to_owned(),
        |rg| format!("{rg:.1}"),
    );
    facts.line(
        "Rf, Rg",
        format!(
            "{:.1}, {gamut} (TM-30-20; Rf is CIE 224's; reds: Rcs,h1 {:+.1} %, Rf,h1 {:.0})",
            found.rf,
            100.0 * red.chroma_shift,
            red.fidelity
        ),
    );
    let kelvin = found.temperature.cct_k;
    let Ok(reference) = reference(kelvin) else { return };
    if let Some(index) = similarity(light, &reference) {
        facts.value("ssi", index);
        facts.line("SSI", format!("{index:.0} to the reference of {kelvin:.0} K"));
    }
}

/// What the light is in photometric units; absolute figures only where its unit is understood.
fn power_facts(facts: &mut Facts, source: &Source) {
    let light = &source.fine;
    let (day, night) = (luminous(light, Adapted::Photopic), luminous(light, Adapted::Scotopic));
    facts.value("efficacy_lm_per_w", efficacy_lm_per_w(light).and_then(finite));
    facts.value("sp_ratio", finite(night / day));
    facts.value("unit", source.unit.as_str());
    if let Some(efficacy) = efficacy_lm_per_w(light) {
        facts.line("efficacy", format!("{efficacy:.1} lm/W of 300 to 780 nm"));
    }
    facts.line(
        "S/P ratio",
        finite(night / day).map_or("none, it is not seen".to_owned(), |_| fixed(night / day, 3)),
    );
    let Some(unit) = source.power_unit else {
        if !source.unit.is_empty() {
            facts.line("luminous", format!("none: the unit '{}' is not understood", source.unit));
        }
        return;
    };
    let (day, night) = (unit.factor * day, unit.factor * night);
    let name = unit.radiometry.photometric_unit();
    facts.value("luminous", finite(day));
    facts.value("scotopic", finite(night));
    facts.value("luminous_unit", name);
    facts.line("luminous", format!("{} {name} by day, {} at night", number(day), number(night)));
}
