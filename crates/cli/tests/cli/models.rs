//! `glanz bsdf` and `glanz info`: numbers for people and programs.

use std::io::Cursor;

use crate::folder::Folder;

/// A matte plate of glass, seen at 60° from its normal and lit at 60° from the other side.
const PLATE: &str = r#"
image = { width = 8, height = 8 }
render = { tone_map = "none" }

[camera]
eye = [8.660254, 0, 5]
target = [0, 0, 0]
projection = "orthographic"
height = 0.1

[ambient]
color = 0

[[lights]]
kind = "directional"
direction = [0.8660254, 0, -0.5]
ambient = 0

[materials.glass]
lobes = [{ shape = "lambert", tint = { ior = 1.5 } }]

[[objects]]
mesh = "quad"
material = "glass"
"#;

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn the_list_of_models_is_a_table() {
    insta::assert_snapshot!(Folder::new().glanz(&["bsdf", "list"]).text());
}

#[test]
fn the_list_of_models_for_programs_holds_the_same_names() {
    let folder = Folder::new();
    let json = folder.glanz(&["bsdf", "list", "--format", "json"]).json();
    let names: Vec<_> =
        json["models"].as_array().unwrap().iter().map(|model| model["name"].as_str().unwrap()).collect();
    let text = folder.glanz(&["bsdf", "list"]);
    let lines: Vec<_> = text.text().lines().skip(1).map(|line| line.split(' ').next().unwrap()).collect();
    assert_eq!(names, lines);
}

#[test]
fn a_model_shows_formula_parameters_laws_and_source() {
    insta::assert_snapshot!(Folder::new().glanz(&["bsdf", "show", "phong"]).text());
}

#[test]
fn the_value_for_two_directions_is_the_formula() {
    let words = ["bsdf", "eval", "phong", "--set", "shininess=32", "--wo", "30,0", "--wi", "45,180"];
    let folder = Folder::new();
    insta::assert_snapshot!(folder.glanz(&words).text());
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    // The mirrored light is 15° from the viewer.
    let expected = 15_f64.to_radians().cos().powi(32) / std::f64::consts::PI;
    assert!((number(&json["f_cos"]) - expected).abs() < 1e-9);
    assert!((number(&json["f"]) - expected / 45_f64.to_radians().cos()).abs() < 1e-9);
    assert_eq!(json["params"]["shininess"], 32.0);
}

#[test]
fn a_light_below_the_surface_has_no_bsdf() {
    let run = Folder::new().glanz(&["bsdf", "eval", "lambert", "--wo", "0,0", "--wi", "120,0"]);
    insta::assert_snapshot!(run.text());
}

#[test]
fn the_albedo_of_lambert_is_one_and_that_of_phong_falls_with_the_exponent() {
    let folder = Folder::new();
    let albedo = |words: &[&str]| {
        let words = [&["bsdf", "albedo"], words, &["--theta", "0,60", "--format", "json"]].concat();
        let json = folder.glanz(&words).json();
        [0, 1].map(|i| number(&json["values"][i]["albedo"]))
    };
    assert!(albedo(&["lambert"]).iter().all(|value| (value - 1.0).abs() < 1e-6));
    // Head on, ∫ cosⁿ/π over the hemisphere is 2/(n+1).
    for n in [1.0, 8.0, 100.0] {
        let [value, _] = albedo(&["phong", "--set", &format!("shininess={n}")]);
        assert!((value - 2.0 / (n + 1.0)).abs() < 1e-4, "n = {n}: {value}");
    }
}

#[test]
fn albedos_for_people_are_a_table() {
    let words = ["bsdf", "albedo", "phong-normalized", "--set", "shininess=8", "--theta", "0,30,60"];
    insta::assert_snapshot!(Folder::new().glanz(&words).text());
}

#[test]
fn a_scene_is_told_in_words() {
    insta::assert_snapshot!(Folder::with_scene().glanz(&["info", "scene.toml"]).text());
}

#[test]
fn a_scene_is_told_to_programs() {
    let json = Folder::with_scene().glanz(&["info", "scene.toml", "--format", "json"]).json();
    assert_eq!(json["image"]["width"], 48);
    assert_eq!(json["materials"][0]["lobes"][2]["params"]["shininess"], 32.0);
    assert_eq!(json["lights"].as_array().unwrap().len(), 2);
    assert_eq!(json["default_lights"], false);
    assert_eq!(json["notes"].as_array().unwrap().len(), 0);
}

#[test]
fn a_model_tells_what_is_added_and_what_is_left_out() {
    let folder = Folder::new();
    folder.write(
        "two.obj",
        "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\ncurv 0 1 1 2\n",
    );
    insta::assert_snapshot!(folder.glanz(&["info", "two.obj"]).text());
    let json = folder.glanz(&["info", "two.obj", "--format", "json"]).json();
    assert_eq!(json["triangles"], 2);
    assert_eq!(json["default_lights"], true);
    assert_eq!(json["bounds"]["max"], serde_json::json!([1.0, 1.0, 1.0]));
}

#[test]
fn a_mirror_tells_its_direction_and_its_reflectance() {
    let folder = Folder::new();
    let words = ["bsdf", "eval", "mirror", "--ior", "1.5", "--wo", "60,0", "--wi", "60,180"];
    insta::assert_snapshot!(folder.glanz(&words).text());
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    assert!((number(&json["delta"]["factor"]) - 0.089_187).abs() < 1e-6 && json["delta"]["is_wi"] == true);
}

#[test]
fn a_fresnel_tint_of_a_matte_lobe_is_that_of_pictures() {
    let folder = Folder::new();
    let words = ["bsdf", "eval", "lambert", "--ior", "1.5", "--wo", "60,0", "--wi", "60,180"];
    insta::assert_snapshot!(folder.glanz(&words).text());
    let json = folder.glanz(&[&words[..], &["--format", "json"]].concat()).json();
    assert_eq!((number(&json["tint_value"]), number(&json["fresnel_cosine"])), (0.04000000000000001, 1.0));
    // The same lobe, drawn: π · f_cos is what a light of value 1 gives.
    folder.write("plate.toml", PLATE);
    folder.glanz(&["render", "plate.toml", "-o", "plate.png", "--bit-depth", "16"]).text();
    let mut reader = png::Decoder::new(Cursor::new(folder.read("plate.png"))).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    let middle = info.line_size * 4 + info.line_size / 2;
    let code = f64::from(u16::from_be_bytes([data[middle], data[middle + 1]])) / 65535.0;
    let drawn = ((code + 0.055) / 1.055).powf(2.4);
    let told = number(&json["f_cos"]) * std::f64::consts::PI;
    assert!((drawn - told).abs() < 1e-4 && (told - 0.02).abs() < 1e-9, "{drawn} {told}");
}

#[test]
fn a_scene_is_told_with_another_model_of_highlights() {
    let folder = Folder::with_scene();
    let json = folder.glanz(&["info", "scene.toml", "--model", "blinn-phong", "--format", "json"]).json();
    let lobe = &json["materials"][0]["lobes"][2];
    assert_eq!((lobe["shape"].as_str(), number(&lobe["params"]["shininess"])), (Some("blinn-phong"), 32.0));
}

#[test]
fn old_names_of_options_work_with_a_remark() {
    let folder = Folder::with_scene();
    let run = folder.glanz(&["color", "metamers", "gold", "copper", "--under", "D65,A"]);
    assert_eq!(run.stderr, "note: --under is called --light now\n");
    let new = folder.glanz(&["color", "metamers", "gold", "copper", "--light", "D65", "--light", "A"]);
    assert_eq!((new.text(), new.stderr.as_str()), (run.text(), ""));
    let run = folder.glanz(&["color", "efficiency", "--light", "D65", "--set", "samples"]);
    assert_eq!(run.stderr, "note: --set is called --surfaces now\n");
    let run =
        folder.glanz(&["sweep", "scene.toml", "--vary", "render.ev=-2,-1", "--cell", "8x8", "-o", "a.png"]);
    assert_eq!(run.stderr, "note: --cell is called --size now\nwrote a.png\n");
    let run = folder.glanz(&["material", "sheet", "gold", "--size", "16", "-o", "b.png"]);
    assert_eq!(run.stderr, "note: --size is WxH now, such as 16x16\nwrote b.png\n");
}
