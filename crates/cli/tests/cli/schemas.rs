//! Every command with `--format json`: one object with a version, and as `glanz schema --of` says.

use serde_json::{Map, Value, json};

use crate::folder::Folder;
use crate::help::{COMMANDS, help};

/// The name of a schema, and command lines whose output is of it.
const DOCUMENTS: [(&str, &[&[&str]]); 57] = [
    ("devices", &[&["devices"]]),
    (
        "render",
        &[
            &["render", "scene.toml", "-o", "r.png"],
            &["render", "scene.toml", "-o", "r.exr", "--timings", "--repeat", "2"],
            &["render", "tetra.obj", "--size", "24x16", "-o", "r.png"],
        ],
    ),
    ("render-frames", &[&["render", "scene.toml", "--frames", "0..2", "--turntable", "-o", "f{frame}.png"]]),
    (
        "sweep",
        &[&["sweep", "scene.toml", "--vary", "render.shading=flat,phong", "--size", "24x16", "-o", "s.png"]],
    ),
    ("shade-compare", &[&["shade-compare", "scene.toml", "-o", "s.png"]]),
    ("lighting-error", &[&["lighting-error", "scene.toml", "-o", "s.png"]]),
    ("modes", &[&["modes", "scene.toml", "--modes", "rgb,sampled:4", "-o", "s.png"]]),
    ("relight", &[&["relight", "scene.toml", "--light", "A", "--light", "D65", "-o", "s.png"]]),
    ("eye-mach", &[&["eye", "scene.toml", "--mach", "y=3", "-o", "m.svg"]]),
    ("eye-population", &[&["eye", "scene.toml", "--population", "2", "-o", "s.png"]]),
    ("eye", &[&["eye", "scene.toml", "--age", "20,80", "-o", "s.png"]]),
    (
        "compare",
        &[
            &[
                "compare",
                "a.png",
                "b.png",
                "-o",
                "map.png",
                "--fail-above",
                "rmse.max=0",
                "--fail-below",
                "psnr=90",
            ],
            &["compare", "a.png", "a.png", "--fail-below", "psnr=9"],
            &["compare", "a.exr", "b.exr"],
        ],
    ),
    (
        "info",
        &[&["info", "scene.toml"], &["info", "lights.toml"], &["info", "tetra.obj"], &["info", "empty.toml"]],
    ),
    (
        "probe",
        &[
            &["probe", "scene.toml", "12,8", "0,0"],
            &["probe", "lights.toml", "12,8"],
            &["probe", "tetra.obj", "12,8", "--size", "24x16", "--shading", "gouraud"],
        ],
    ),
    ("example", &[&["example", "list"], &["example", "glass", "-o", "glass.toml"]]),
    ("bsdf-list", &[&["bsdf", "list"]]),
    ("bsdf-show", &[&["bsdf", "show", "phong"], &["bsdf", "show", "ward"]]),
    (
        "bsdf-eval",
        &[
            &["bsdf", "eval", "phong", "--wo", "30,0", "--wi", "45,180"],
            &["bsdf", "eval", "phong", "--wo", "30,0", "--wi", "120,180", "--ior", "Au"],
        ],
    ),
    (
        "bsdf-albedo",
        &[
            &["bsdf", "albedo", "lambert"],
            &["bsdf", "albedo", "ward", "--theta", "0", "--phi", "0,90", "--tint", "0.5"],
        ],
    ),
    ("sheet", &[&["sheet", "phong", "--vary", "ior=Au,1.5", "--size", "16x16", "-o", "s.png"]]),
    ("check", &[&["check", "lambert", "phong"], &["check", "--all", "--allow-known"]]),
    ("material-list", &[&["material", "list"]]),
    ("material-show", &[&["material", "show", "gold"]]),
    ("material-sheet", &[&["material", "sheet", "gold", "--size", "16", "-o", "s.png"]]),
    ("color-convert", &[&["color", "convert", "--from", "srgb", "--to", "lch", "0.5,0.5,0.5"]]),
    (
        "color-spectrum",
        &[
            &["color", "spectrum", "D65"],
            &["color", "spectrum", "UV365"],
            &["color", "spectrum", "gold", "--light", "A"],
            &["color", "spectrum", "A", "--observer", "lms2"],
        ],
    ),
    ("measure-info", &[&["measure", "info", "tile.csv"], &["measure", "info", "ggx.bsdf"]]),
    (
        "measure-appearance",
        &[
            &["measure", "appearance", "ggx"],
            &["measure", "appearance", "ggx.bsdf"],
            &["measure", "appearance", "paper-brightened", "--observer", "cie1964"],
        ],
    ),
    ("lesson-ward", &[&["lesson", "ward"], &["lesson", "ward", "--readings", "ggx.bsdf"]]),
    ("measure-fit", &[&["measure", "fit", "ggx.bsdf", "--models", "ggx+lambert,lambert", "-o", "fit.toml"]]),
    ("measure-convert", &[&["measure", "convert", "tile.csv", "-o", "again.csv"]]),
    ("measure-compare", &[&["measure", "compare", "ggx.bsdf", "ggx", "--size", "32x32"]]),
    ("measure-sample", &[&["measure", "sample", "ggx", "-o", "a.bsdf"]]),
    (
        "measure-smooth",
        &[&["measure", "smooth", "ggx.bsdf", "-o", "smooth.csv"], &["measure", "smooth", "ggx.bsdf"]],
    ),
    ("shader-run", &[&["shader", "run", "a.frag", "--size", "8x8", "-o", "toy.png"]]),
    (
        "shader-certify",
        &[&["shader", "certify", "n = 2; n / (2 * pi)"], &["shader", "certify", "1 / (dot(N, L) - 0.5)"]],
    ),
    ("shader-check", &[&["shader", "check", "a.vert", "a.frag"]]),
    ("shader-list", &[&["shader", "list"]]),
    ("shader-print", &[&["shader", "print", "phong-330"]]),
    (
        "shader-xray",
        &[
            &["shader", "xray", "scene.toml", "--fs", "sight.frag", "--pixel", "12,8", "--size", "24x16"],
            &["shader", "xray", "scene.toml", "--fs", "sight.frag", "--vertex", "0"],
        ],
    ),
    (
        "shader-picture",
        &[&["shader", "picture", "scene.toml", "--fs", "sight.frag", "--value", "up", "-o", "up.png"]],
    ),
    ("shader-export", &[&["shader", "export", "scene.toml", "-o", "program"]]),
    ("color-xy", &[&["color", "xy", "0.3127,0.329"], &["color", "xy", "0.35,0.2", "--white", "D65"]]),
    ("color-wave", &[&["color", "wave", "580nm", "2.1eV"]]),
    ("color-metamers", &[&["color", "metamers", "gold", "copper"]]),
    ("color-fluorescence", &[&["color", "fluorescence", "paper-note-pink"]]),
    ("color-list", &[&["color", "list"], &["color", "list", "models"]]),
    ("color-efficiency", &[&["color", "efficiency", "--light", "D65"]]),
    (
        "plot",
        &[
            &["plot", "phong", "-o", "-"],
            &["plot", "cook-torrance", "--kind", "terms", "-o", "-"],
            &["plot", "--kind", "attenuation", "-o", "-"],
        ],
    ),
    ("plot-eye", &[&["plot", "eye", "--kind", "pupil", "-o", "-"]]),
    ("color-plot-spectra", &[&["color", "plot", "spectra", "D65", "-o", "-"]]),
    ("color-plot-chromaticity", &[&["color", "plot", "chromaticity", "-o", "-"]]),
    ("color-plot-cones", &[&["color", "plot", "cones", "-o", "-"]]),
    ("color-plot-meyer", &[&["color", "plot", "meyer", "-o", "-"]]),
    ("color-plot-matrix", &[&["color", "plot", "matrix", "paper-note-pink", "-o", "-"]]),
    ("color-plot-tm30", &[&["color", "plot", "tm30", "FL2", "-o", "-"]]),
    ("color-plot-efficiency", &[&["color", "plot", "efficiency", "--light", "D65", "-o", "-"]]),
];

/// One light of each kind.
const LIGHTS: &str = r#"
[camera]
projection = "orthographic"
eye = [0.0, 0.0, 4.0]
height = 2.0

[[lights]]
kind = "ambient"
color = [0.1, 0.1, 0.1]

[[lights]]
kind = "directional"
direction = [0.0, -1.0, 0.0]
spectrum = "A"

[[lights]]
kind = "spot"
position = [0.0, 3.0, 0.0]
direction = [0.0, -1.0, 0.0]
cutoff_deg = 30.0

[[lights]]
kind = "sphere"
position = [0.0, 3.0, 0.0]
radius = 0.5

[[lights]]
kind = "disk"
position = [0.0, 3.0, 0.0]
direction = [0.0, -1.0, 0.0]
radius = 0.5

[[lights]]
kind = "rectangle"
position = [0.0, 3.0, 0.0]
direction = [0.0, -1.0, 0.0]
size = [1.0, 2.0]

[[lights]]
kind = "environment"
color = [0.2, 0.2, 0.2]

[materials.ball]
library = "gold"

[[objects]]
mesh = { sphere = { slices = 8, stacks = 4 } }
material = "ball"
"#;

fn folder() -> Folder {
    let folder = Folder::with_scene();
    folder.write("lights.toml", LIGHTS);
    folder.write("empty.toml", "");
    folder.write("tile.csv", crate::measure::TILE);
    folder.glanz(&["measure", "sample", "ggx", "-o", "ggx.bsdf"]).text();
    folder.write("a.vert", crate::shader::VERTEX);
    folder.write("a.frag", crate::shader::FRAGMENT);
    folder.write("sight.frag", crate::shader::SIGHT);
    folder
        .write("tetra.obj", "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
    for (name, red) in [("a.png", "0.9"), ("b.png", "0.4"), ("a.exr", "0.9"), ("b.exr", "0.4")] {
        let set = format!("materials.ball.diffuse=[{red}, 0.1, 0.1]");
        folder.glanz(&["render", "scene.toml", "-o", name, "--set", &set]).text();
    }
    folder
}

/// What is printed, whatever the exit code, and the schema of that name.
fn printed(folder: &Folder, words: &[&str]) -> Value {
    let run = folder.glanz(&[words, &["--format", "json"]].concat());
    serde_json::from_slice(&run.stdout).unwrap_or_else(|error| panic!("{words:?}: {error}: {}", run.stderr))
}

fn schema(folder: &Folder, name: &str) -> Value {
    folder.glanz(&["schema", "--of", name]).json()
}

#[test]
fn every_document_is_as_its_schema_says() {
    let folder = folder();
    for (name, commands) in DOCUMENTS {
        let schema = schema(&folder, name);
        for words in commands {
            let document = printed(&folder, words);
            assert_eq!(document["version"], 1, "{words:?}");
            let faults = faults(&schema, &document);
            assert!(faults.is_empty(), "{words:?}: {faults:#?}\n{document:#}");
        }
        assert!(!faults(&schema, &json!({ "version": 1, "strange": 3 })).is_empty(), "{name} takes anything");
    }
}

#[test]
fn every_error_is_as_its_schema_says() {
    let folder = folder();
    let schema = schema(&folder, "error");
    for words in [&["info", "none.toml"][..], &["render", "scene.toml", "--wrong"], &["plot", "phong"]] {
        let document = printed(&folder, words);
        assert_eq!(faults(&schema, &document), Vec::<String>::new(), "{words:?}: {document}");
    }
}

#[test]
fn every_command_with_a_format_has_a_schema_and_is_tried() {
    let folder = Folder::new();
    for words in COMMANDS.iter().filter(|words| help(words).contains("--format <FORMAT>")) {
        let name = words.join("-");
        let (_, commands) = DOCUMENTS.iter().find(|(known, _)| *known == name).expect(&name);
        assert!(commands.iter().all(|command| command.starts_with(words)), "{name}");
    }
    // All names of the option are tried, and the help lists them.
    let listed = help(&["schema"]);
    for name in DOCUMENTS.iter().map(|(name, _)| *name).chain(["scene", "error"]) {
        assert!(listed.contains(name), "{name}: {listed}");
        assert!(schema(&folder, name)["properties"].is_object(), "{name}");
    }
    assert_eq!(schema(&folder, "scene"), folder.glanz(&["schema"]).json());
    assert_eq!(folder.glanz(&["schema", "--of", "nothing"]).code, 2);
}

#[test]
fn the_validator_finds_what_is_wrong() {
    let schema = json!({
        "type": "object", "required": ["a"], "additionalProperties": false, "$defs": { "n": { "minimum": 0 } },
        "properties": {
            "a": { "type": ["array", "null"], "items": { "type": "integer" }, "minItems": 2, "maxItems": 2 },
            "b": { "anyOf": [{ "type": "string" }, { "type": "null" }] }, "c": { "enum": ["x", "y"] },
            "d": { "$ref": "#/$defs/n" }, "e": { "const": 1 },
        },
    });
    assert!(faults(&schema, &json!({ "a": [1, 2], "b": null, "c": "x", "d": 0, "e": 1 })).is_empty());
    let wrong = [
        json!({}),
        json!({ "a": [1] }),
        json!({ "a": [1, 2.5] }),
        json!({ "a": 1 }),
        json!({ "a": null, "b": 1 }),
        json!({ "a": null, "c": "z" }),
        json!({ "a": null, "d": -1 }),
        json!({ "a": null, "e": 2 }),
        json!({ "a": null, "f": 2 }),
        json!([]),
    ];
    for value in wrong {
        assert_eq!(faults(&schema, &value).len(), 1, "{value}");
    }
}

/// Where a value is not what the schema says. Knows the part of JSON Schema that our schemas use, and refuses
/// any other.
fn faults(root: &Value, value: &Value) -> Vec<String> {
    let mut found = Vec::new();
    validate(root, root, value, "$", &mut found);
    found
}

fn validate(root: &Value, schema: &Value, value: &Value, place: &str, found: &mut Vec<String>) {
    let Some(keys) = schema.as_object() else {
        assert_eq!(*schema, true, "a schema is an object, or true");
        return;
    };
    for (key, rule) in keys {
        let holds = match (key.as_str(), value) {
            ("$schema" | "$defs" | "title" | "description" | "format" | "default", _) => true,
            ("patternProperties" | "additionalProperties", _) => true,
            ("type", _) => has_type(rule, value),
            ("const", _) => rule == value,
            ("enum", _) => rule.as_array().unwrap().contains(value),
            ("minimum", Value::Number(number)) => number.as_f64() >= rule.as_f64(),
            ("maximum", Value::Number(number)) => number.as_f64() <= rule.as_f64(),
            ("minItems", Value::Array(items)) => items.len() as u64 >= rule.as_u64().unwrap(),
            ("maxItems", Value::Array(items)) => items.len() as u64 <= rule.as_u64().unwrap(),
            ("required", Value::Object(object)) => {
                rule.as_array().unwrap().iter().all(|key| object.contains_key(key.as_str().unwrap()))
            }
            ("anyOf" | "oneOf", _) => {
                let fits = |one: &&Value| {
                    let mut faults = Vec::new();
                    validate(root, one, value, place, &mut faults);
                    faults.is_empty()
                };
                let count = rule.as_array().unwrap().iter().filter(fits).count();
                if key == "oneOf" { count == 1 } else { count > 0 }
            }
            ("$ref", _) => {
                let pointer = rule.as_str().unwrap().strip_prefix('#').unwrap();
                validate(root, root.pointer(pointer).unwrap(), value, place, found);
                true
            }
            ("allOf", _) => {
                rule.as_array().unwrap().iter().for_each(|one| validate(root, one, value, place, found));
                true
            }
            ("items", Value::Array(items)) => {
                for (index, item) in items.iter().enumerate() {
                    validate(root, rule, item, &format!("{place}[{index}]"), found);
                }
                true
            }
            ("properties", Value::Object(object)) => {
                for (name, value) in object {
                    match rule.get(name).or_else(|| other(keys, name)) {
                        Some(rule) => validate(root, rule, value, &format!("{place}.{name}"), found),
                        None => found.push(format!("{place}: no key {name} is expected")),
                    }
                }
                true
            }
            ("minimum" | "maximum" | "minItems" | "maxItems" | "required" | "items" | "properties", _) => {
                true
            }
            _ => panic!("{place}: the validator does not know '{key}'"),
        };
        if !holds {
            found.push(format!("{place}: not {key} {rule}, but {value}"));
        }
    }
    let is_map = keys.get("type").is_some_and(|kind| *kind == "object") && !keys.contains_key("properties");
    if let (Value::Object(object), true) = (value, is_map) {
        for (name, value) in object {
            match other(keys, name) {
                Some(rule) => validate(root, rule, value, &format!("{place}.{name}"), found),
                None => found.push(format!("{place}: no key {name} is expected")),
            }
        }
    }
}

/// The rule for a key without one of its own. A key that no rule is for is a fault here: documents have none
/// that their schema does not name.
fn other<'a>(keys: &'a Map<String, Value>, name: &str) -> Option<&'a Value> {
    let patterns = keys.get("patternProperties").and_then(Value::as_object);
    let pattern = patterns.and_then(|patterns| {
        let fits = |pattern: &str| name.starts_with(pattern.trim_start_matches('^'));
        patterns.iter().find(|(pattern, _)| fits(pattern)).map(|(_, rule)| rule)
    });
    pattern.or_else(|| keys.get("additionalProperties").filter(|rule| **rule != false))
}

fn has_type(rule: &Value, value: &Value) -> bool {
    let is = |name: &Value| match name.as_str().unwrap() {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("no type '{other}'"),
    };
    rule.as_array().map_or_else(|| is(rule), |names| names.iter().any(is))
}
