//! What commands refuse for the memory that it would take, and how that is raised.

use crate::folder::Folder;

/// A scene of some 100 000 triangles with shadows.
const MANY: &str = "[render]\nshadows = true\n[[lights]]\nkind = \"directional\"\ndirection = [0, -1, -1]\n\
                    [[objects]]\nmesh = { sphere = { slices = 500, stacks = 101 } }\n";

/// A folder with scenes and a white picture of 64×64 pixels.
fn folder() -> Folder {
    let folder = Folder::with_scene();
    folder.write("many.toml", MANY);
    folder.write("empty.toml", "[image]\nwidth = 64\nheight = 64\nbackground = [1, 1, 1]\n");
    assert_eq!(folder.glanz(&["render", "empty.toml", "-o", "white.png"]).code, 0);
    let textured =
        "[materials.a]\nbase_color_texture = \"white.png\"\n[[objects]]\nmesh = \"quad\"\nmaterial = \"a\"\n";
    folder.write("textured.toml", textured);
    folder
}

#[test]
fn what_takes_more_than_the_budget_is_one_error_before_it_is_taken() {
    let folder = folder();
    let cases: [(&[&str], &str); 8] = [
        (&["render", "textured.toml", "-o", "a.png", "--memory", "30kB"], "a texture of 64×64 texels"),
        (&["info", "textured.toml", "--memory", "30kB"], "a texture of 64×64 texels"),
        (&["info", "many.toml", "--memory", "1MB"], "100000 triangles"),
        (&["render", "many.toml", "-o", "a.png", "--memory", "5MB"], "100000 triangles"),
        (&["render", "many.toml", "-o", "a.png", "--memory", "20MB"], "the shadows of 100000 triangles"),
        (
            &["render", "empty.toml", "-o", "a.png", "--size", "999x999", "--memory", "1MB"],
            "a picture of 999×999 pixels in 8 bits",
        ),
        (&["compare", "white.png", "white.png", "--memory", "90kB"], "a picture of 64×64 pixels"),
        (&["compare", "white.png", "white.png", "--memory", "130kB"], "de2000 of 64×64 pixels"),
    ];
    for (words, what) in cases {
        let run = folder.glanz(words);
        let told = run.failure();
        assert!(
            run.code == 3 && told.contains("expected at most") && told.contains("of memory, found"),
            "{words:?} {told}"
        );
        assert!(told.contains(what) && told.contains("--memory "), "{words:?} {told}");
        assert!(!folder.names().contains(&"a.png".to_owned()));
    }
}

#[test]
fn films_and_sheets_are_within_the_budget() {
    let folder = folder();
    let before = folder.names();
    let film = ["render", "many.toml", "--frames", "0..2", "--turntable", "--memory", "5MB", "-o"];
    let large =
        ["render", "empty.toml", "--frames", "0..2", "--turntable", "--size", "999x999", "--memory", "1MB"];
    let cases: [(Vec<&str>, &str); 6] = [
        ([&film[..], &["f{frame}.png"]].concat(), "100000 triangles"),
        ([&film[..], &["f.gif"]].concat(), "100000 triangles"),
        ([&large[..], &["-o", "f{frame}.png"]].concat(), "a picture of 999×999 pixels"),
        ([&large[..], &["-o", "f.apng"]].concat(), "a picture of 999×999 pixels"),
        (
            vec!["sweep", "many.toml", "--vary", "render.ev=0,1", "--memory", "5MB", "-o", "f.png"],
            "100000 triangles",
        ),
        (vec!["shade-compare", "many.toml", "--memory", "5MB", "-o", "f.png"], "100000 triangles"),
    ];
    for (words, what) in cases {
        let run = folder.glanz(&words);
        let told = run.failure();
        assert!(run.code == 3 && told.contains(what) && told.contains("--memory "), "{words:?} {told}");
        assert_eq!(folder.names(), before, "{words:?}");
    }
}

#[test]
fn info_tells_what_drawing_refuses() {
    let folder = folder();
    let told = folder.glanz(&["info", "many.toml", "--memory", "20MB"]);
    assert!(told.text().contains("drawing    refused: expected at most 20 MB of memory"), "{}", told.text());
    assert!(told.text().contains("--memory "), "{}", told.text());
    let facts = folder.glanz(&["info", "many.toml", "--memory", "20MB", "--format", "json"]).json();
    assert!(facts["refusal"].as_str().unwrap().contains("the shadows of 100000 triangles"), "{facts}");
    let facts = folder.glanz(&["info", "many.toml", "--format", "json"]).json();
    assert!(facts["refusal"].is_null(), "{facts}");
}

#[test]
fn a_picture_for_an_eye_is_within_the_budget() {
    let folder = folder();
    let told = folder.glanz(&["eye", "white.png", "--memory", "200kB"]).failure();
    assert!(told.contains("what an eye sees of 64×64 pixels"), "{told}");
    assert_eq!(folder.glanz(&["eye", "white.png"]).code, 0);
}

#[test]
fn a_larger_budget_allows_it_in_any_unit() {
    let folder = folder();
    for size in ["60MB", "0.06GB", "60 MB", "58MiB", "60000kb"] {
        let run = folder.glanz(&[
            "render",
            "many.toml",
            "-o",
            "b.png",
            "--size",
            "8x8",
            "--force",
            "--memory",
            size,
        ]);
        assert_eq!(run.code, 0, "{size}: {}", run.stderr);
    }
    for wrong in ["8", "lots", "0GB", "-1GB", "8 apples"] {
        let told = folder.glanz(&["info", "many.toml", &format!("--memory={wrong}")]).failure();
        assert!(told.starts_with('2') && told.contains("such as 8GB"), "{wrong}: {told}");
    }
}
