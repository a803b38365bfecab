//! `glanz bsdf` and `glanz info`: numbers for people and programs.

use crate::folder::Folder;

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
