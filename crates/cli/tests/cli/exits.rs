//! The exit code of every command: 1 where something was judged and failed, 2 for wrong use, 3 where the
//! work could not be done.

use crate::folder::{Folder, command};
use crate::help::{COMMANDS, help};

/// Commands that judge, with something that fails.
const JUDGED: [&[&str]; 4] = [
    &["compare", "a.png", "b.png", "--fail-above", "rmse=0"],
    &["compare", "a.png", "b.png", "--fail-below", "ssim=1"],
    &["check", "phong"],
    &["check", "lambert", "phong"],
];

/// Each command that reads or writes files, with a file that cannot be read or written.
const COULD_NOT: [&[&str]; 32] = [
    &["render", "none.toml", "-o", "a.png"],
    &["render", "none.glb", "-o", "a.png"],
    &["render", "scene.toml", "-o", "none/a.png"],
    &["render", "scene.toml", "--set", "image.width=wide", "-o", "a.png"],
    &["render", "scene.toml", "--frames", "0..2", "--turntable", "-o", "none/{frame}.png"],
    &["render", "wrong.toml", "--frames", "0..2", "--turntable", "-o", "{frame}.png"],
    &["sweep", "none.toml", "--vary", "render.ev=0,1", "-o", "a.png"],
    &["sweep", "wrong.toml", "--vary", "render.ev=0,1", "-o", "a.png"],
    &["shade-compare", "none.toml", "-o", "a.png"],
    &["modes", "wrong.toml", "-o", "a.png"],
    &["relight", "none.toml", "--light", "A", "-o", "a.png"],
    &["compare", "a.png", "none.png"],
    &["compare", "a.png", "scene.toml"],
    &["compare", "a.png", "small.png"],
    // That the pictures cannot be compared comes before any bound.
    &["compare", "a.png", "small.png", "--fail-above", "rmse=0"],
    &["info", "none.toml"],
    &["info", "wrong.toml"],
    &["bsdf", "eval", "phong", "--directions", "none.csv"],
    &["bsdf", "albedo", "phong", "--tint", "none.csv"],
    &["sheet", "phong", "--vary", "shininess=1,2", "-o", "none/a.png"],
    &["plot", "phong", "-o", "none/a.svg"],
    &["material", "sheet", "gold", "-o", "none/a.png"],
    &["color", "spectrum", "none.csv"],
    &["color", "metamers", "gold", "none.csv"],
    &["color", "fluorescence", "none.csv"],
    &["color", "efficiency", "--under", "none.csv"],
    &["color", "plot", "spectra", "D65", "-o", "none/a.svg"],
    &["color", "plot", "chromaticity", "-o", "none/a.svg"],
    &["color", "plot", "cones", "-o", "none/a.svg"],
    &["color", "plot", "meyer", "-o", "none/a.svg"],
    &["color", "plot", "matrix", "paper-note-pink", "-o", "none/a.svg"],
    &["color", "plot", "efficiency", "-o", "none/a.svg"],
];

/// Commands that only print, which fails where stdout takes nothing.
const PRINTING: [&[&str]; 11] = [
    &["bsdf", "list"],
    &["bsdf", "show", "phong"],
    &["bsdf", "albedo", "lambert"],
    &["check", "lambert"],
    &["material", "list"],
    &["material", "show", "gold"],
    &["color", "list", "lights"],
    &["color", "convert", "--from", "srgb", "--to", "lab", "1,0,0"],
    &["info", "scene.toml"],
    &["schema"],
    &["completions", "bash"],
];

/// A scene, one with an error, two pictures and a smaller one.
fn folder() -> Folder {
    let folder = Folder::with_scene();
    folder.write("wrong.toml", "[image]\nwdth = 3\n");
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
fn wrong_use_of_any_command_is_2() {
    let folder = Folder::new();
    for words in COMMANDS {
        assert_eq!(folder.glanz(&[words, &["--wrong"]].concat()).code, 2, "{words:?}");
    }
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
