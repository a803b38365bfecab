//! The exit code of every command: 1 where something was judged and failed, 2 for wrong use, 3 where the
//! work could not be done.

use crate::folder::{Folder, Run, command};
use crate::help::{COMMANDS, help};

/// Commands that judge, with something that fails.
const JUDGED: [&[&str]; 4] = [
    &["compare", "a.png", "b.png", "--fail-above", "rmse=0"],
    &["compare", "a.png", "b.png", "--fail-below", "ssim=1"],
    &["check", "phong"],
    &["check", "lambert", "phong"],
];

/// Each command that reads or writes files, with a file that cannot be read or written.
const COULD_NOT: [&[&str]; 59] = [
    &["render", "none.toml", "-o", "a.png"],
    &["render", "none.glb", "-o", "a.png"],
    &["render", "scene.toml", "-o", "none/a.png"],
    &["render", "scene.toml", "--frames", "0..2", "--turntable", "-o", "none/{frame}.png"],
    &["render", "wrong.toml", "--frames", "0..2", "--turntable", "-o", "{frame}.png"],
    &["sweep", "none.toml", "--vary", "render.ev=0,1", "-o", "a.png"],
    &["sweep", "wrong.toml", "--vary", "render.ev=0,1", "-o", "a.png"],
    &["shade-compare", "none.toml", "-o", "a.png"],
    &["lighting-error", "none.toml", "-o", "a.png"],
    &["modes", "wrong.toml", "-o", "a.png"],
    &["eye", "none.toml", "--age", "20,80", "-o", "a.png"],
    &["relight", "none.toml", "--light", "A", "-o", "a.png"],
    &["compare", "a.png", "none.png"],
    &["compare", "a.png", "scene.toml"],
    &["compare", "a.png", "small.png"],
    // That the pictures cannot be compared comes before any bound.
    &["compare", "a.png", "small.png", "--fail-above", "rmse=0"],
    &["info", "none.toml"],
    &["info", "wrong.toml"],
    &["probe", "none.toml", "1,1"],
    &["probe", "scene.toml", "9999,1"],
    &["shader", "check", "none.frag"],
    &["shader", "check", "wrong.frag"],
    &["shader", "print", "phong-330", "--stage", "vertex", "-o", "none/a.vert"],
    &["shader", "xray", "scene.toml", "--pixel", "1,1"],
    &["shader", "xray", "scene.toml", "--fs", "wrong.frag", "--pixel", "1,1"],
    &["shader", "picture", "scene.toml", "--fs", "none.frag", "--value", "x", "-o", "a.png"],
    &["shader", "export", "none.toml", "-o", "program"],
    &["render", "scene.toml", "--fs", "wrong.frag", "-o", "a.png"],
    &["shader", "run", "none.frag", "-o", "toy.png"],
    &["shader", "run", "a.frag", "-o", "none/toy.png"],
    &["shader", "certify", "none.brdf"],
    &["measure", "appearance", "tile.csv"],
    &["measure", "fit", "tile.csv"],
    &["measure", "info", "none.csv"],
    &["measure", "info", "a.png"],
    &["measure", "convert", "tile.csv", "-o", "tile.bsdf"],
    &["measure", "sample", "phong", "-o", "none/a.csv"],
    &["measure", "compare", "none.csv", "ggx"],
    &["measure", "smooth", "tile.csv", "-o", "a.bsdf"],
    &["measure", "appearance", "none.toml"],
    &["lesson", "ward", "--readings", "tile.csv"],
    &["example", "ball", "-o", "none/a.toml"],
    &["bsdf", "eval", "phong", "--directions", "none.csv"],
    &["bsdf", "albedo", "phong", "--tint", "none.csv"],
    &["sheet", "phong", "--vary", "shininess=1,2", "-o", "none/a.png"],
    &["plot", "phong", "-o", "none/a.svg"],
    &["plot", "eye", "--kind", "lens", "-o", "none/a.svg"],
    &["material", "sheet", "gold", "-o", "none/a.png"],
    &["color", "spectrum", "none.csv"],
    &["color", "metamers", "gold", "none.csv"],
    &["color", "fluorescence", "none.csv"],
    &["color", "efficiency", "--light", "none.csv"],
    &["color", "plot", "spectra", "D65", "-o", "none/a.svg"],
    &["color", "plot", "chromaticity", "-o", "none/a.svg"],
    &["color", "plot", "cones", "-o", "none/a.svg"],
    &["color", "plot", "meyer", "-o", "none/a.svg"],
    &["color", "plot", "matrix", "paper-note-pink", "-o", "none/a.svg"],
    &["color", "plot", "tm30", "FL2", "-o", "none/a.svg"],
    &["color", "plot", "efficiency", "-o", "none/a.svg"],
];

/// Commands that only print, which fails where stdout takes nothing.
const PRINTING: [&[&str]; 23] = [
    &["licenses"],
    &["devices"],
    &["bsdf", "list"],
    &["bsdf", "show", "phong"],
    &["bsdf", "albedo", "lambert"],
    &["check", "lambert"],
    &["material", "list"],
    &["material", "show", "gold"],
    &["color", "list", "lights"],
    &["color", "xy", "0.31,0.33"],
    &["color", "wave", "580nm"],
    &["color", "convert", "--from", "srgb", "--to", "lab", "1,0,0"],
    &["info", "scene.toml"],
    &["shader", "check", "a.frag"],
    &["shader", "list"],
    &["shader", "print", "phong-330"],
    &["shader", "certify", "1 / pi"],
    &["measure", "info", "tile.csv"],
    &["measure", "appearance", "lambert"],
    &["lesson", "ward"],
    &["example", "list"],
    &["schema"],
    &["completions", "bash"],
];

/// A scene, one with an error, two pictures and a smaller one.
fn folder() -> Folder {
    let folder = Folder::with_scene();
    folder.write("wrong.toml", "[image]\nwdth = 3\n");
    folder.write("tile.csv", crate::measure::TILE);
    folder.write("a.frag", crate::shader::FRAGMENT);
    folder.write("wrong.frag", "#version 330\nvoid main() { x }\n");
    for (name, more) in [
        ("a.png", &["--size", "24x16"][..]),
        ("b.png", &["--size", "24x16", "--ev", "-1"]),
        ("small.png", &["--size", "12x8"]),
    ] {
        folder.glanz(&[&["render", "scene.toml", "-o", name], more].concat()).text();
    }
    folder
}

#[test]
fn what_is_judged_and_fails_is_1() {
    let folder = folder();
    for words in JUDGED {
        assert_eq!(folder.glanz(words).code, 1, "{words:?}");
    }
    assert_eq!(folder.glanz(&["compare", "a.png", "b.png", "--fail-above", "rmse=1"]).code, 0);
    assert_eq!(folder.glanz(&["check", "lambert"]).code, 0);
}

#[test]
fn known_faults_pass_where_they_are_allowed() {
    let folder = Folder::new();
    for words in [&["phong"][..], &["lambert", "phong"], &["--all"]] {
        let words = [&["check"], words].concat();
        assert_eq!(folder.glanz(&words).code, 1, "{words:?}");
        let allowed = folder.glanz(&[&words[..], &["--allow-known"]].concat());
        assert_eq!((allowed.code, allowed.stderr.as_str()), (0, ""), "{words:?}");
        assert_eq!(allowed.stdout, folder.glanz(&words).stdout, "the certificate is the same");
    }
    let json = folder.glanz(&["check", "phong", "--allow-known", "--format", "json"]).json();
    assert!(json["error"].is_null() && json["certificates"][0]["healthy"] == false, "{json}");
}

#[test]
fn wrong_use_of_any_command_is_2() {
    let folder = Folder::new();
    for words in COMMANDS {
        assert_eq!(folder.glanz(&[words, &["--wrong"]].concat()).code, 2, "{words:?}");
    }
}

#[test]
fn a_name_of_the_command_line_that_there_is_not_is_2() {
    let folder = Folder::new();
    let names: [&[&str]; 5] = [
        &["shader", "print", "phong"],
        &["bsdf", "show", "pong"],
        &["material", "show", "glod"],
        &["color", "spectrum", "glod"],
        &["example", "bal"],
    ];
    for words in names {
        let run = folder.glanz(words);
        assert_eq!(run.code, 2, "{words:?}: {}", run.stderr);
    }
}

#[test]
fn a_value_that_the_command_line_sets_wrongly_is_2() {
    let folder = Folder::with_scene();
    let render = ["render", "scene.toml", "-o", "a.png"];
    for set in ["image.width=wide", "materials.ball.shininess=-1", "materials.nobody.shininess=1", "image="] {
        let run = folder.glanz(&[&render[..], &["--set", set]].concat());
        assert_eq!(run.code, 2, "{set}: {}", run.stderr);
    }
    let vary = ["sweep", "scene.toml", "--vary", "materials.ball.shininess=4,-4", "-o", "a.png"];
    assert_eq!(folder.glanz(&vary).code, 2);
    let error =
        error(&folder.glanz(&[&render[..], &["--set", "image.width=wide", "--format", "json"]].concat()));
    assert!(error["message"].as_str().unwrap().contains("string"), "{error}");
    assert!(error["file"].is_null(), "{error}");
}

#[test]
fn what_could_not_be_done_is_3() {
    let folder = folder();
    let before = folder.names();
    for words in COULD_NOT {
        let run = folder.glanz(words);
        assert_eq!(run.code, 3, "{words:?}: {}", run.stderr);
        assert_eq!(folder.names(), before, "{words:?} leaves a file behind");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_stdout_that_is_full_is_3() {
    let folder = folder();
    for words in PRINTING {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = command(&folder.path("")).args(words).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(3), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_help_that_stdout_does_not_take_is_3() {
    let folder = Folder::new();
    for words in [&["--help"][..], &["-h"], &["render", "--help"], &["help", "render"], &["--version"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = command(&folder.path("")).args(words).stdout(full).output().unwrap();
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(3), "{words:?}: {told}");
        assert!(told.contains("stdout"), "{words:?}: {told}");
    }
}

#[test]
fn no_command_is_left_out() {
    let tested = || COULD_NOT.iter().chain(&PRINTING);
    for words in COMMANDS.iter().filter(|words| !words.is_empty()) {
        let is_group = COMMANDS.iter().any(|other| other.len() > words.len() && other.starts_with(words));
        assert!(is_group || tested().any(|one| one.starts_with(words)), "{words:?}");
    }
}

#[test]
fn the_help_tells_the_codes() {
    let help = help(&[]);
    for code in ["0  done", "1  judged and failed", "2  usage", "3  could not"] {
        assert!(help.contains(code), "{help}");
    }
}

/// The error that a run with `--format json` printed, and nothing else anywhere.
fn error(run: &Run) -> serde_json::Value {
    assert!(run.stderr.is_empty(), "{}", run.stderr);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["version"], 1, "{json}");
    let error = json["error"].as_object().unwrap();
    let keys: Vec<_> = error.keys().map(String::as_str).collect();
    assert_eq!(keys, ["column", "file", "help", "line", "message"]);
    json["error"].clone()
}

#[test]
fn programs_are_told_an_error_with_its_place() {
    let folder = Folder::with_scene();
    folder.write("wrong.toml", "[image]\nwidth = 3\n  heigth = 4\n");
    folder.write("broken.obj", "v 0 0 0\nv 0 0 x\n");
    folder.write("a.csv", "nm,reflectance\n300,0.5\n310,half\n");
    type Case = (&'static [&'static str], &'static str, Option<u64>, Option<u64>);
    let cases: [Case; 7] = [
        (&["info", "wrong.toml"], "wrong.toml", Some(3), Some(3)),
        (&["info", "none.toml"], "none.toml", None, None),
        (&["render", "broken.obj", "-o", "a.png"], "broken.obj", Some(2), None),
        (&["color", "spectrum", "a.csv"], "a.csv", Some(3), None),
        (&["color", "spectrum", "none.csv"], "none.csv", None, None),
        (&["compare", "none.png", "none.png"], "none.png", None, None),
        (&["render", "scene.toml", "-o", "none/a.png"], "none/a.png", None, None),
    ];
    for (words, file, line, column) in cases {
        let run = folder.glanz(&[words, &["--format", "json"]].concat());
        assert_eq!(run.code, 3, "{words:?}");
        let error = error(&run);
        assert_eq!(error["file"], file, "{error}");
        assert_eq!(error["line"].as_u64(), line, "{error}");
        assert_eq!(error["column"].as_u64(), column, "{error}");
        assert!(!error["message"].as_str().unwrap().is_empty());
    }
    let error = error(&folder.glanz(&["info", "wrong.toml", "--format=json"]));
    assert!(error["message"].as_str().unwrap().contains("heigth"), "{error}");
    assert!(error["help"].as_str().unwrap().contains("height"), "{error}");
}

#[test]
fn every_failure_is_json_where_json_is_asked_for() {
    let folder = folder();
    for words in COULD_NOT {
        let run = folder.glanz(&[words, &["--format", "json"]].concat());
        // CSV has its own form, and a plot's file says its format itself.
        let has_format = !words.contains(&"--directions") && !words.contains(&"none/a.svg");
        assert_eq!(run.code, if has_format { 3 } else { 2 }, "{words:?}");
        error(&run);
    }
}

#[test]
fn wrong_use_is_json_where_json_is_asked_for() {
    let folder = Folder::with_scene();
    for words in COMMANDS {
        for format in [&["--format", "json"][..], &["--format=json"]] {
            let run = folder.glanz(&[words, &["--wrong"], format].concat());
            assert_eq!(run.code, 2, "{words:?}");
            let error = error(&run);
            assert!(error["help"].as_str().unwrap().contains("--help"), "{error}");
            assert!(!error["message"].as_str().unwrap().contains("error:"), "{error}");
        }
    }
    // What the parser lets through, and the command refuses.
    let words = ["render", "scene.toml", "--ev", "1000", "--format", "json"];
    let run = folder.glanz(&words);
    assert_eq!(run.code, 2);
    assert_eq!(error(&run)["message"], "--ev is 1000, but must be between -64 and 64 stops");
    // After -- there are no options.
    let run = folder.glanz(&["info", "--", "--format", "json"]);
    assert!(run.stdout.is_empty() && run.code == 2, "{run:?}");
}

#[test]
fn what_is_judged_is_one_document_with_its_error() {
    let folder = folder();
    for words in JUDGED {
        let run = folder.glanz(&[words, &["--format", "json"]].concat());
        assert_eq!(run.code, 1, "{words:?}");
        let error = error(&run);
        assert!(!error["message"].as_str().unwrap().is_empty());
    }
    let run = folder.glanz(&["compare", "a.png", "b.png", "--fail-above", "rmse=0", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["bounds"][0]["holds"], false);
    let good =
        folder.glanz(&["compare", "a.png", "b.png", "--fail-above", "rmse=1", "--format", "json"]).json();
    assert!(good["error"].is_null());
}

#[test]
fn stdout_takes_json_or_a_picture_but_not_both() {
    let folder = folder();
    let commands: [&[&str]; 9] = [
        &["render", "scene.toml", "-o", "-"],
        &["render", "scene.toml", "--preview"],
        &["sweep", "scene.toml", "--vary", "render.ev=0,1", "-o", "-"],
        &["shade-compare", "scene.toml", "-o", "-"],
        &["modes", "scene.toml", "-o", "-"],
        &["lighting-error", "scene.toml", "-o", "-"],
        &["sheet", "phong", "--vary", "shininess=1,2", "-o", "-"],
        &["material", "sheet", "gold", "-o", "-"],
        &["compare", "a.png", "b.png", "-o", "-"],
    ];
    for words in commands {
        let run = folder.glanz(&[words, &["--format", "json"]].concat());
        assert_eq!(run.code, 2, "{words:?}");
        assert!(error(&run)["message"].as_str().unwrap().contains("stdout cannot take both"));
    }
}

#[test]
#[cfg(unix)]
fn what_is_judged_fails_where_nobody_reads_it_too() {
    let folder = Folder::new();
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = command(&folder.path(""))
        .args(["check", "ward"])
        .stdout(writer)
        .stderr(std::process::Stdio::null())
        .status();
    assert_eq!(status.unwrap().code(), Some(1));
}
