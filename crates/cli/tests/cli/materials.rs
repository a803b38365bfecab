//! `glanz material`: the library on the command line.

use crate::folder::Folder;
use crate::pictures::Png;

#[test]
fn the_library_is_a_table() {
    insta::assert_snapshot!(Folder::new().glanz(&["material", "list"]).text());
}

#[test]
fn a_category_is_listed_alone_for_programs() {
    let json =
        Folder::new().glanz(&["material", "list", "--category", "ngan2005", "--format", "json"]).json();
    let names: Vec<_> =
        json["materials"].as_array().unwrap().iter().map(|info| info["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["ngan-chrome", "ngan-pvc"]);
    assert!(json["materials"][0]["source"].as_str().unwrap().contains("2005"));
}

#[test]
fn a_material_is_shown_with_its_source() {
    let folder = Folder::new();
    insta::assert_snapshot!(folder.glanz(&["material", "show", "car-paint-red"]).text());
    let json = folder.glanz(&["material", "show", "car-paint-red", "--format", "json"]).json();
    assert_eq!(json["category"], "paint");
    assert!(json["toml"].as_str().unwrap().starts_with("lobes = ["));
}

/// What `glanz info` tells programs of the materials of a scene.
fn told(scene: &str) -> serde_json::Value {
    let folder = Folder::new();
    folder.write("scene.toml", scene);
    folder.glanz(&["info", "scene.toml", "--format", "json"]).json()["materials"].clone()
}

#[test]
fn what_is_shown_can_be_pasted_and_is_the_same_as_the_name() {
    let object = "[[objects]]\nmesh = 'sphere'\nmaterial = ";
    for name in ["gold-brushed", "car-paint-red", "glass-pane", "soap-film", "gl-emerald"] {
        let shown = Folder::new().glanz(&["material", "show", name]).text().to_owned();
        let pasted = told(&format!("{shown}\n{object}'{name}'"));
        assert!(!pasted[0]["lobes"].as_array().unwrap().is_empty(), "{name}");
        assert_eq!(told(&format!("{object}'{name}'")), pasted, "{name}");
        assert_eq!(
            told(&format!("[materials.{name}]\nlibrary = '{name}'\n{object}'{name}'")),
            pasted,
            "{name}"
        );
    }
}

#[test]
fn unknown_materials_are_refused_with_near_names() {
    let folder = Folder::new();
    insta::assert_snapshot!(folder.glanz(&["material", "show", "golt"]).failure());
    insta::assert_snapshot!(folder.glanz(&["material", "sheet", "gold", "golt", "-o", "a.png"]).failure());
    insta::assert_snapshot!(folder.glanz(&["material", "list", "--category", "cheese"]).failure());
    assert_eq!(folder.names(), Vec::<String>::new());
}

#[test]
fn a_sheet_shows_each_material_in_its_colours() {
    let folder = Folder::new();
    let words =
        ["material", "sheet", "rubber-red", "leaf-green", "glass-pane", "--size", "40", "-o", "a.png"];
    let run = folder.glanz(&[&words[..], &["--format", "json"]].concat());
    let json = run.json();
    assert_eq!(json["cells"][1]["values"]["material"], "leaf-green");
    let sheet = Png::decode(&folder.read("a.png"));
    assert_eq!(
        (sheet.width as u64, sheet.height as u64),
        (json["width"].as_u64().unwrap(), json["height"].as_u64().unwrap())
    );
    // Cells of 40 pixels with gaps of 6: the middles of the balls.
    let middle = |cell: usize| sheet.pixel(6 + 46 * cell + 20, 26);
    let [red, green, _] = [0, 1, 2].map(middle);
    assert!(red[0] > red[1] + 40 && red[0] > red[2] + 40, "{red:?}");
    assert!(green[1] > green[0] && green[1] > green[2] + 40, "{green:?}");
}
