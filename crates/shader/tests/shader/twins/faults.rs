//! Faults in twins are noticed: every operator is changed once.

use glanz_bsdf::Shape;
use glanz_bsdf::wgsl::{self, Part, Twin};
use glanz_shader::Shader;

use super::cases::cases;
use super::{Place, call, difference, shader};

/// What is written in place of what.
const CHANGES: [(&str, &str); 9] = [
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " / "),
    (" / ", " * "),
    (" < ", " > "),
    (" > ", " < "),
    (" & ", " | "),
    ("max(", "min("),
    ("min(", "max("),
];

/// Random places for each set of parameters.
const RANDOM: usize = 1_000;

/// Changes that no twin has other bits for, since none calls or reads it, or multiplies nothing with it. The first two are held by
/// `helpers`.
const HARMLESS: &[&str] = &[
    // It is for Fresnel's law.
    "bsdf/src/direction_pair.wgsl: return sqrt(clamp(pair.half2 * 0.25, 0.0, 1.0)); [*]",
    // Models give no cosine below 0.
    "math/src/real.wgsl: return select(angle, 3.141592653589793 - angle, x < 0.0); [-]",
    // It saves time: a compensation of weight 0 is 0.
    "bsdf/src/models/ggx/model.wgsl: let multiscatter = number(at + 2u * AXES_NUMBERS + 2u); [+]",
    // Both are 0 where the series is not fitted, as for GGX surfaces of one width.
    "bsdf/src/microfacet/compensation.wgsl: let sum = compensation_series(lobe, center * q - lobe.origin); [-]",
    "bsdf/src/microfacet/compensation.wgsl: return max(cosine * q * sum - lobe.less, 0.0); [-]",
    // Ward's successors read it.
    "bsdf/src/terms/ward.wgsl: return Highlight(gauss, x2 + y2, per_height_squared); [+]",
];

/// All texts with one change, each with the line and the change.
fn faulty(text: &str) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for (from, to) in CHANGES {
        for (at, _) in text.match_indices(from) {
            let line = text[..at].rfind('\n').map_or(0, |i| i + 1);
            let line = text[line..].lines().next().unwrap_or("").trim();
            if !line.starts_with("//") {
                let changed = format!("{}{to}{}", &text[..at], &text[at + from.len()..]);
                all.push((changed, format!("{line} [{}]", from.trim())));
            }
        }
    }
    all
}

/// A twin with the shapes and places at which it is looked at.
type Case = (&'static Twin, Vec<(Shape, Vec<Place>)>);

/// Whether the twin with this text in place of the part's is refused, or has other bits.
fn is_noticed((twin, cases): &Case, part: &Part, text: &str) -> bool {
    let text = wgsl::text([*twin]).replace(part.text, text);
    match Shader::fragment(shader(&text, &call(twin))).named("twin.wgsl").compile() {
        Err(_) => true,
        Ok(program) => cases.iter().any(|(shape, places)| difference(&program, shape, places).is_some()),
    }
}

fn add(parts: &mut Vec<&'static Part>, part: &'static Part) {
    if !parts.iter().any(|known| known.file == part.file) {
        parts.push(part);
        part.needs.iter().for_each(|need| add(parts, need));
    }
}

#[test]
fn every_changed_operator_is_noticed() {
    let cases: Vec<Case> = wgsl::twins().iter().map(|twin| (twin, cases(twin, RANDOM).collect())).collect();
    let mut parts = Vec::new();
    wgsl::twins().iter().for_each(|twin| add(&mut parts, &twin.part));
    let (mut count, mut unnoticed) = (0, Vec::new());
    for part in parts {
        let users: Vec<_> =
            cases.iter().filter(|(twin, _)| wgsl::text([*twin]).contains(part.text)).collect();
        for (text, what) in faulty(part.text) {
            count += 1;
            if !users.iter().any(|case| is_noticed(case, part, &text)) {
                unnoticed.push(format!("{}: {what}", part.file));
            }
        }
    }
    println!("{count} changes");
    assert_eq!(unnoticed, HARMLESS);
}
