//! Attenuation and cones of lights, from the keys of scene files.

use std::path::Path;

use glanz_plot::light::{Attenuation, AttenuationPlot, Cone, SpotPlot, attenuation_label};
use glanz_plot::{Lang, LineChart, Variation};
use glanz_scene::LightKind;
use glanz_scene::file::{LoadOptions, parse_str};

use crate::load::failure_of_scene;
use crate::print::failure::Failure;

/// The laws that are plotted where none is named.
const LAWS: [&str; 4] =
    ["none", "{ constant = 1, linear = 1 }", "{ constant = 1, quadratic = 1 }", "physical"];
/// The exponents that are plotted where nothing is set.
const EXPONENTS: [&str; 4] = ["0", "4", "16", "64"];
/// The most curves.
const MAX_CURVES: usize = 1000;
/// The greatest distance where none is given, in metres.
const TO_M: f64 = 10.0;

/// The keys of a light that set its cone.
const CONE_KEYS: [&str; 4] = ["cutoff_deg", "cutoff_rad", "exponent", "smooth_edge"];

/// Values of keys, in one combination.
type Values = Vec<(String, String)>;

/// Laws of attenuation over the distance.
pub(super) fn attenuation(
    set: &[Variation],
    to_m: Option<f64>,
    log: bool,
    lang: Lang,
) -> Result<LineChart, Failure> {
    let set = or_default(set, "attenuation", &LAWS);
    let mut laws = Vec::new();
    for values in combinations(&set, &["attenuation"])? {
        let LightKind::Point { attenuation, .. } = light("point", &values)? else {
            unreachable!("the kind is written below")
        };
        let (constant, linear, quadratic) = (attenuation.constant, attenuation.linear, attenuation.quadratic);
        let sum = attenuation_label(constant, linear, quadratic, lang);
        let named = values.iter().map(|(_, text)| text.trim_matches('"')).find(|text| !text.contains('{'));
        let label = named.map_or(sum.clone(), |name| format!("{name}: {sum}"));
        laws.push(Attenuation { label, constant, linear, quadratic });
    }
    let plot = AttenuationPlot { laws, to_m: to_m.unwrap_or(TO_M), log, lang };
    Ok(plot.chart()?)
}

/// Cones of spots over the angle.
pub(super) fn spot(set: &[Variation], log: bool, lang: Lang) -> Result<LineChart, Failure> {
    let set = or_default(set, "exponent", &EXPONENTS);
    let mut cones = Vec::new();
    for values in combinations(&set, &CONE_KEYS)? {
        let LightKind::Spot { cutoff, exponent, smooth_edge, .. } = light("spot", &values)? else {
            unreachable!("the kind is written below")
        };
        let label: Vec<_> = values.iter().map(|(key, text)| format!("{key} = {text}")).collect();
        let cutoff_deg = cutoff.to_degrees();
        cones.push(Cone { label: label.join(", "), cutoff_deg, exponent, smooth_edge });
    }
    Ok(SpotPlot { cones, log, lang }.chart()?)
}

fn or_default(set: &[Variation], key: &str, values: &[&str]) -> Vec<Variation> {
    match set.is_empty() {
        true => {
            let values = values.iter().map(|value| (*value).to_owned()).collect();
            vec![Variation { path: key.to_owned(), values }]
        }
        false => set.to_vec(),
    }
}

/// Every combination of the values of these keys; the last key runs fastest.
fn combinations(set: &[Variation], keys: &[&str]) -> Result<Vec<Values>, Failure> {
    if let Some(wrong) = set.iter().find(|vary| !keys.contains(&vary.path.as_str())) {
        let near = glanz_math::names::did_you_mean(&wrong.path, keys.iter().copied());
        let keys = keys.join(", ");
        return Err(Failure::Usage(format!("--set {}: expected one of the keys {keys}{near}", wrong.path)));
    }
    let mut all: Vec<Values> = vec![Vec::new()];
    for vary in set {
        if all.len() * vary.values.len() > MAX_CURVES {
            return Err(Failure::Usage(format!("--set makes more than {MAX_CURVES} combinations")));
        }
        let with = |values: &Values, text: &String| {
            let mut values = values.clone();
            values.push((vary.path.clone(), text.clone()));
            values
        };
        all = all.iter().flat_map(|values| vary.values.iter().map(|text| with(values, text))).collect();
    }
    Ok(all)
}

/// A light of this kind with these values of its keys, read as a scene file is.
fn light(kind: &str, values: &Values) -> Result<LightKind, Failure> {
    let text = format!("[[lights]]\nkind = \"{kind}\"\nposition = [0, 0, 0]\n");
    let aim = if kind == "spot" { "direction = [0, 0, -1]\n" } else { "" };
    let sets = values.iter().map(|(key, text)| (format!("lights.0.{key}"), text.clone())).collect();
    let options = LoadOptions { sets, ..LoadOptions::default() };
    let loaded = parse_str(&(text + aim), Path::new(""), &options)
        .map_err(|error| failure_of_scene(error, "--set"))?;
    let light = loaded
        .scene
        .lights
        .into_iter()
        .find(|light| matches!(light.kind, LightKind::Point { .. } | LightKind::Spot { .. }));
    light.map(|light| light.kind).ok_or_else(|| Failure::new("the light is not among those read"))
}
