//! The numbers for people.

use std::fmt::Write as _;

use super::document::{ColorFacts, Document};

/// Channels that are shown; programs get all of them.
const SHOWN: usize = 8;

/// For people.
pub(super) fn text(facts: &Document) -> String {
    let names: Vec<String> = facts.channels.iter().take(SHOWN).map(|name| format!("{name:>9}")).collect();
    let mut text = format!("{}\n{:<16}{}\n", facts.name, "", names.join(" "));
    channels(&mut text, facts);
    colors(&mut text, facts);
    indices(&mut text, facts);
    for note in &facts.notes {
        line(&mut text, format_args!("note: {note}"));
    }
    line(&mut text, format_args!("not verified against a standard:"));
    for what in &facts.not_verified {
        line(&mut text, format_args!("  {what}"));
    }
    text
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

/// A row of numbers, one for each channel.
fn row(text: &mut String, name: &str, values: &[f64], digits: usize) {
    let few = &values[..values.len().min(SHOWN)];
    // No rounded number is -0.
    let least = 0.5 * libm::exp10(-(digits as f64));
    let number = |value: &f64| if value.abs() < least { 0.0 } else { *value };
    let words: Vec<String> = few.iter().map(|value| format!("{:>9.digits$}", number(value))).collect();
    let more = if values.len() > few.len() { "  …" } else { "" };
    line(text, format_args!("{name:<16}{}{more}", words.join(" ")));
}

/// What has a number for each channel.
fn channels(text: &mut String, facts: &Document) {
    for (angle, gloss) in [(20.0, &facts.gloss_20), (60.0, &facts.gloss_60), (85.0, &facts.gloss_85)] {
        row(text, &format!("gloss {angle}°"), gloss, 1);
    }
    row(text, "haze ISO 13803", &facts.haze_iso_13803, 2);
    row(text, "logarithmic", &facts.log_haze, 1);
    row(text, "haze E430 2°", &facts.haze_e430_narrow, 2);
    row(text, "haze E430 5°", &facts.haze_e430_wide, 2);
    if let Some(haze) = facts.haze_d4039.iter().copied().collect::<Option<Vec<f64>>>() {
        row(text, "haze D4039", &haze, 1);
    }
    row(text, "45°/0°", &facts.factor_45_0, 4);
    for (light, angles) in [(45, &facts.multi_angle), (15, &facts.multi_angle_15)] {
        for angle in angles {
            row(text, &format!("{light}° as {:>4}°", angle.aspecular_deg), &angle.factor, 4);
        }
    }
    row(text, "sphere SCI", &facts.sphere_included, 4);
    row(text, "sphere SCE", &facts.sphere_excluded, 4);
    line(text, format_args!("gloss at {}° tells such surfaces apart best", facts.gloss_chosen_deg));
}

/// The colour in each geometry.
fn colors(text: &mut String, facts: &Document) {
    if facts.colors.is_empty() {
        return;
    }
    line(text, format_args!("\nunder {} for {}", facts.light, facts.observer));
    line(
        text,
        format_args!("{:<16}{:>9} {:>9} {:>9} {:>9} {:>9} {:>9}", "", "X", "Y", "Z", "L*", "a*", "b*"),
    );
    for ColorFacts { geometry, xyz, lab } in &facts.colors {
        let numbers: Vec<String> =
            xyz.iter().chain(lab).map(|value| format!("{:>9.2}", unsigned(*value))).collect();
        line(text, format_args!("{geometry:<16}{}", numbers.join(" ")));
    }
    for list in &facts.lists {
        line(text, format_args!("{}: {}", list.name, list.geometries.join(", ")));
    }
}

/// Flop, whiteness, yellowness.
fn indices(text: &mut String, facts: &Document) {
    if let Some(flop) = facts.flop_index {
        line(text, format_args!("{:<16}{flop:>9.2}", "flop index"));
    }
    match &facts.whiteness {
        Some(white) if white.is_valid => {
            let (w, t) = (white.whiteness, white.tint);
            line(text, format_args!("{:<16}{w:>9.2}, tint {t:.2}", "whiteness CIE"));
        }
        Some(_) => {
            line(text, format_args!("no whiteness: W and T are beyond the limits of the CIE for whites"))
        }
        None => {}
    }
    for found in &facts.yellowness {
        let standard = found.standard.trim_start_matches("astm-").to_uppercase();
        let (name, yellowness) = (format!("yellowness {standard}"), unsigned(found.yellowness));
        line(text, format_args!("{name:<18}{yellowness:>7.2}  {}, {}", found.light, found.observer));
    }
}

/// A number that is told with two decimals: no zero has a sign.
fn unsigned(value: f64) -> f64 {
    if value.abs() < 0.005 { 0.0 } else { value }
}
