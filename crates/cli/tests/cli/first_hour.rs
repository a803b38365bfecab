//! What a first hour with the command needs: remarks where a picture is hardly what was meant, a loop of editing and
//! drawing, examples, mistakes on purpose.

use std::io::Write;
use std::process::Stdio;

use crate::folder::{Folder, Run, command};
use crate::pictures::Png;

/// A red ball under one lamp from the side of the viewer.
const BALL: &str = "\
[image]\nwidth = 48\nheight = 36\nsamples = 1\n\
[camera]\neye = [0, 0, 5]\n\
[[lights]]\nkind = \"directional\"\ndirection = [-1, -1, -1]\n\
[materials.red]\ndiffuse = [0.7, 0.1, 0.1]\nspecular = 0.2\n\
[[objects]]\nname = \"ball\"\nmesh = \"sphere\"\nmaterial = \"red\"\n";

fn ball() -> Folder {
    let folder = Folder::new();
    folder.write("scene.toml", BALL);
    folder
}

/// The remarks on the picture of the ball with these options, which stderr tells, too.
fn notes(words: &[&str]) -> Vec<String> {
    let folder = ball();
    let words = [&["render", "scene.toml", "-o", "a.png", "--format", "json"], words].concat();
    let run = folder.glanz(&words);
    let notes: Vec<String> = serde_json::from_value(run.json()["notes"].clone()).unwrap();
    for note in &notes {
        assert!(run.stderr.contains(&format!("note: {note}\n")), "{}", run.stderr);
    }
    notes
}

/// The only remark.
fn note(words: &[&str]) -> String {
    let notes = notes(words);
    assert_eq!(notes.len(), 1, "{notes:?}");
    notes[0].clone()
}

fn with_stdin(folder: &Folder, words: &[&str], text: &str) -> Run {
    let mut child = command(&folder.path(""))
        .args(words)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    Run {
        code: output.status.code().unwrap(),
        stdout: output.stdout,
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

#[test]
fn a_good_picture_gets_no_remark() {
    assert_eq!(notes(&[]), Vec::<String>::new());
    assert_eq!(notes(&["--show", "normals"]), Vec::<String>::new());
    assert_eq!(notes(&["--bit-depth", "16"]), Vec::<String>::new());
}

#[test]
fn a_black_picture_is_told_why() {
    assert!(note(&["--set", "lights=[]"]).starts_with("the scene has no lights, so its surfaces are black"));
    assert!(note(&["--set", "objects=[]"]).starts_with("the scene has no objects"));
    let away = note(&["--eye", "0,0,5", "--target", "0,0,10"]);
    assert!(away.starts_with("no object is in view: the camera at (0.000, 0.000, 5.000)"), "{away}");
    let behind = note(&["--set", "lights.0.direction=[0,0,1]"]);
    assert!(behind.starts_with("all surfaces in view are black: no lamp reaches their front"), "{behind}");
    assert!(behind.ends_with("direction = [0, 0, -1] lights the other side"), "{behind}");
    let words = [
        "--set",
        "lights.0.direction=[0,0,1]",
        "--set",
        "ambient.color=0.3",
        "--set",
        "materials.red.ambient=1",
    ];
    let ambient = note(&words);
    assert!(ambient.starts_with("the surfaces in view get ambient or emitted light only"), "{ambient}");
    let exr = ball().glanz(&["render", "scene.toml", "-o", "a.exr", "--set", "lights.0.direction=[0,0,1]"]);
    assert!(exr.stderr.contains("no lamp reaches their front"), "{}", exr.stderr);
}

#[test]
fn films_and_sheets_tell_where_they_are_black() {
    let folder = ball();
    let notes = |words: &[&str]| -> Vec<String> {
        let run = folder.glanz(&[words, &["--format", "json", "--force"]].concat());
        serde_json::from_value(run.json()["notes"].clone()).unwrap()
    };
    let behind = "all surfaces in view are black: no lamp reaches their front";
    let film = ["render", "scene.toml", "--frames", "10..13", "-o", "a.gif", "--animate"];
    let film = notes(&[&film[..], &["lights.0.direction=[0,0.1,-1]:[0,0,1]"]].concat());
    assert_eq!(film.len(), 1, "{film:?}");
    assert!(film[0].starts_with(&format!("frame 12: {behind}")), "{film:?}");
    let files = ["render", "scene.toml", "--frames", "0..2", "-o", "{frame}.png", "--turntable"];
    let files = notes(&[&files[..], &["--set", "lights=[]"]].concat());
    assert!(files[0].starts_with("the scene has no lights"), "{files:?}");
    let vary = "lights.0.direction=[0,0,-1],[0,0,1]";
    let sheet = notes(&["sweep", "scene.toml", "--vary", vary, "--size", "48x36", "-o", "a.png"]);
    assert!(sheet[0].starts_with(&format!("lights.0.direction=[0,0,1]: {behind}")), "{sheet:?}");
    for words in [
        ["relight", "scene.toml", "--light", "A,D65"].as_slice(),
        &["modes", "scene.toml"],
        &["shade-compare", "scene.toml"],
    ] {
        let words = [words, &["-o", "a.png", "--set", "lights.0.intensity=0.5"]].concat();
        assert_eq!(notes(&words), Vec::<String>::new());
        let dark = notes(&[&words[..], &["--set", "lights.0.direction=[0,0,1]"]].concat());
        assert!(dark.len() == 1 && dark[0].starts_with(behind), "{dark:?}");
    }
}

#[test]
fn a_rate_that_a_gif_does_not_have_is_told() {
    let folder = ball();
    let film = |name: &str, fps: &str| {
        let words = ["render", "scene.toml", "--frames", "0..2", "--turntable", "--fps", fps, "-o", name];
        let run = folder.glanz(&words);
        assert_eq!(run.code, 0, "{}", run.stderr);
        run.stderr.contains("a GIF counts hundredths of a second: it has 33.3333 frames a second, not 30")
    };
    assert!(film("a.gif", "30"));
    assert!(!film("a.gif", "25") && !film("a.apng", "30"));
}

#[test]
fn a_clipped_picture_is_told_how_much_and_why() {
    let bright = notes(&["--set", "materials.red.diffuse=5"]);
    assert_eq!(bright.len(), 2, "{bright:?}");
    assert!(bright[0].contains("is up to 5, where 1 gives back all light"), "{bright:?}");
    assert!(bright[1].contains("% of the pixels with surfaces are clipped, up to "), "{bright:?}");
    let sum = note(&["--set", "materials.red.diffuse=0.8", "--set", "materials.red.specular=0.8"]);
    assert!(
        sum.contains("diffuse and specular of material 'red' add up to 1.600, where 1 is all light"),
        "{sum}"
    );
    let lamp = note(&["--set", "lights.0.intensity=4"]);
    assert!(lamp.contains("lower the lights or the colours; --ev -"), "{lamp}");
    let lamp = note(&["--set", "lights.0.intensity=4", "--ev", "1"]);
    let advised = lamp.split("--ev ").nth(1).unwrap().split(' ').next().unwrap();
    let taken = format!("--ev={advised}");
    assert_eq!(notes(&["--set", "lights.0.intensity=4", &taken]), Vec::<String>::new(), "{lamp}");
    assert_eq!(notes(&["--set", "lights.0.intensity=4", "--tone-map", "reinhard"]), Vec::<String>::new());
    assert_eq!(
        notes(&["--background", "#ffffff"]),
        Vec::<String>::new(),
        "a white background is not clipped"
    );
}

#[test]
fn raw_codes_are_the_linear_values() {
    let folder = Folder::new();
    let quad = "[image]\nwidth = 8\nheight = 8\n[materials.a]\nemission = [0.2, 0.6, 1.5]\n\
                [[objects]]\nmesh = \"quad\"\nmaterial = \"a\"\nscale = 9\n[camera]\neye = [0, 0, 3]\n";
    folder.write("scene.toml", quad);
    folder.write("raw.toml", format!("{quad}[render]\nencoding = \"raw\"\n"));
    let pixel = |words: &[&str]| {
        let run = folder.glanz(&[&["render"], words, &["-o", "a.png"]].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        Png::decode(&folder.read("a.png")).pixel(4, 4)
    };
    assert_eq!(pixel(&["scene.toml", "--encoding", "raw"]), [51, 153, 255, 255]);
    let says = |text: &str| folder.read("a.png").windows(text.len()).any(|bytes| bytes == text.as_bytes());
    assert!(says("Encoding") && says("raw: linear values"));
    assert_eq!(pixel(&["raw.toml"]), [51, 153, 255, 255]);
    assert_eq!(pixel(&["scene.toml"]), [124, 203, 255, 255]);
    assert!(!says("Encoding"));
    assert_eq!(pixel(&["raw.toml", "--encoding", "srgb"]), [124, 203, 255, 255]);
    let run = folder.glanz(&["render", "scene.toml", "--encoding", "raw", "-o", "a.exr"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("an .exr holds the linear values themselves"), "{}", run.stderr);
}

/// Each mistake, and what makes it be seen.
const MISTAKES: [(&str, &[&str]); 6] = [
    ("normal-matrix", &["--set", "objects.ball.scale=[1,1,3]"]),
    ("unclamped", &["--set", "ambient.color=0.5", "--set", "materials.red.ambient=0.8"]),
    (
        "degrees-as-radians",
        &["--set", "lights=[{kind='spot',position=[0,0,5],direction=[0,0,-1],cutoff_deg=5}]"],
    ),
    ("no-gamma", &[]),
    ("unnormalised-normal", &["--set", "objects.ball.mesh={sphere={slices=8,stacks=5}}"]),
    ("halfway-unnormalised", &["--set", "materials.red.model=blinn-phong"]),
];

#[test]
fn every_mistake_changes_the_picture_and_says_so() {
    let folder = ball();
    for (mistake, words) in MISTAKES {
        let draw = |more: &[&str]| {
            let run = folder.glanz(&[&["render", "scene.toml", "-o", "a.png"], words, more].concat());
            assert_eq!(run.code, 0, "{}", run.stderr);
            (folder.read("a.png"), run.stderr)
        };
        let (right, told) = draw(&[]);
        assert!(!told.contains("mistake"), "{told}");
        let (wrong, told) = draw(&["--mistake", mistake]);
        assert_ne!(Png::decode(&wrong), Png::decode(&right), "{mistake}");
        assert!(told.contains(&format!("drawn with the mistake '{mistake}' on purpose")), "{told}");
        let is_named = |file: &[u8]| file.windows(mistake.len()).any(|bytes| bytes == mistake.as_bytes());
        assert!(is_named(&wrong) && !is_named(&right), "{mistake} in the metadata");
        let set = format!("render.mistake={mistake}");
        assert_eq!(draw(&["--set", &set]).0.len(), wrong.len(), "{mistake} as a setting of the scene");
    }
}

#[test]
fn a_mistake_that_changes_nothing_is_told() {
    for mistake in ["normal-matrix", "degrees-as-radians", "halfway-unnormalised"] {
        let told = note(&["--mistake", mistake]);
        assert!(told.starts_with(&format!("the mistake '{mistake}' changes nothing: ")), "{told}");
    }
    let flat = note(&["--mistake", "unnormalised-normal", "--shading", "flat"]);
    assert!(flat.contains("changes nothing"), "{flat}");
    let raw = note(&["--mistake", "no-gamma", "--encoding", "raw"]);
    assert!(raw.contains("the encoding is raw already"), "{raw}");
}

#[test]
fn drawing_again_writes_over_an_own_picture_alone() {
    let folder = ball();
    for _ in 0..2 {
        assert_eq!(folder.glanz(&["render", "scene.toml"]).code, 0);
    }
    let sweep = ["sweep", "scene.toml", "--vary", "render.ev=0,1", "--size", "16x12"];
    for _ in 0..2 {
        assert_eq!(folder.glanz(&sweep).code, 0);
    }
    folder.write("scene.png", "mine");
    let run = folder.glanz(&["render", "scene.toml"]);
    assert_eq!(run.code, 3);
    assert!(run.stderr.contains("exists already, and Glanz did not write it"), "{}", run.stderr);
}

#[test]
fn a_scene_comes_from_stdin() {
    let folder = ball();
    folder.glanz(&["render", "scene.toml", "-o", "file.png"]);
    let run = with_stdin(&folder, &["render", "-", "-o", "-"], BALL);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.stdout, folder.read("file.png"));
    // Twice from one reading, and under a name of its own.
    assert_eq!(with_stdin(&folder, &["render", "-", "--repeat", "2"], BALL).stderr, "wrote scene.png\n");
    let run = with_stdin(&folder, &["info", "-"], BALL);
    assert!(run.text().starts_with("stdin\n"), "{}", run.text());
    let run = with_stdin(&folder, &["render", "-", "-o", "a.png"], "[imag]\n");
    assert_eq!(run.code, 3);
    assert!(run.stderr.contains("stdin:1:2"), "{}", run.stderr);
    let run = with_stdin(&folder, &["render", "-", "--watch"], BALL);
    assert_eq!(run.code, 2, "{}", run.stderr);
}

#[test]
fn every_example_is_written_and_drawn() {
    let folder = Folder::new();
    let list = folder.glanz(&["example", "list", "--format", "json"]).json();
    let names: Vec<&str> =
        list["examples"].as_array().unwrap().iter().map(|e| e["name"].as_str().unwrap()).collect();
    assert!(names.len() > 20 && names.contains(&"kite"), "{names:?}");
    for name in names {
        let run = folder.glanz(&["example", name]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let scene = format!("{name}.toml");
        let run = folder.glanz(&["render", &scene, "-o", "a.png", "--size", "16x12"]);
        assert_eq!(run.code, 0, "{name}: {}", run.stderr);
    }
    assert!(folder.path("models/suzanne.glb").exists());
    folder.write("kite.toml", "mine");
    assert_eq!(folder.glanz(&["example", "kite"]).code, 3);
    assert_eq!(folder.read("kite.toml"), b"mine");
    assert_eq!(folder.glanz(&["example", "kite", "--force"]).code, 0);
    let printed = folder.glanz(&["example", "glass", "-o", "-"]);
    assert!(printed.text().contains("[[objects]]"));
    assert!(printed.stderr.contains("note: it needs data/studio.hdr"), "{}", printed.stderr);
    let run = folder.glanz(&["example", "kit"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("did you mean 'kite'?"), "{}", run.stderr);
}

#[test]
fn a_preview_needs_a_terminal_unless_it_is_asked_for() {
    let folder = ball();
    let run = folder.glanz(&["render", "scene.toml", "--preview"]);
    assert_eq!(run.text(), "");
    assert!(run.stderr.starts_with("note: --preview needs a terminal"), "{}", run.stderr);
    let show = |mode: &str| {
        let option = format!("--preview={mode}");
        let run =
            folder.glanz_with(&["render", "scene.toml", &option], &[("COLUMNS", "40"), ("LINES", "11")]);
        run.text().to_owned()
    };
    let blocks = show("blocks");
    assert_eq!(blocks.lines().count(), 10, "a line is left for the shell");
    assert!(blocks.lines().all(|line| line.matches('▀').count() == 26));
    assert!(show("sixel").starts_with("\x1bPq"));
    assert!(show("kitty").starts_with("\x1b_Ga=T,f=100,"));
    assert!(show("iterm").starts_with("\x1b]1337;File=inline=1;"));
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[test]
fn a_list_of_numbers_moves_in_a_film() {
    let folder = ball();
    let motion = "lights.0.direction=[-1,-1,-1]:[1,-1,-1]";
    let words = ["render", "scene.toml", "--frames", "0..3", "--animate", motion, "-o", "{frame}.png"];
    assert_eq!(folder.glanz(&words).code, 0);
    let still = ["render", "scene.toml", "-o", "still.png", "--set", "lights.0.direction=[0,-1,-1]"];
    folder.glanz(&still);
    assert_eq!(Png::decode(&folder.read("1.png")), Png::decode(&folder.read("still.png")));
}

#[test]
fn the_vertices_of_the_kite_are_a_table() {
    let folder = Folder::new();
    folder.glanz(&["example", "kite"]);
    insta::assert_snapshot!(folder.glanz(&["info", "kite.toml", "--vertices"]).text());
    let json = folder.glanz(&["info", "kite.toml", "--vertices", "--format", "json"]).json();
    let table = &json["meshes"][0]["table"];
    assert_eq!(table["facets"].as_array().unwrap().len(), 2);
    assert!(table["vertices"][0]["color"][3].is_number());
    assert!(folder.glanz(&["info", "kite.toml", "--format", "json"]).json()["meshes"][0]["table"].is_null());
}

#[test]
fn what_is_written_otherwise_elsewhere_is_told_the_right_way() {
    let cases = [
        ("[materials.a]\ndiffuse = 0,6\n", "write 0.6"),
        ("[lights]\nkind = \"point\"\n", "write [[lights]]"),
        ("[[lights]]\nkind = \"sun\"\n", "did you mean 'directional'?"),
        ("[camera]\neye = [0, 0, 1]\nfov = 40\n", "did you mean 'fov_deg'?"),
    ];
    let folder = ball();
    for (text, expected) in cases {
        folder.write("wrong.toml", text);
        let run = folder.glanz(&["info", "wrong.toml"]);
        assert!(run.code == 3 && run.stderr.contains(expected), "{text}: {}", run.stderr);
    }
    let run = folder.glanz(&["sweep", "scene.toml", "--vary", "materials.red.shininess=1:100"]);
    assert!(run.code == 2 && run.stderr.contains("such as 1:100:5"), "{}", run.stderr);
    let run = folder.glanz(&["render", "scene.toml", "--set", "lights.3.intensity=1"]);
    assert!(run.stderr.contains("'lights' has 1 entry, counted from 0"), "{}", run.stderr);
}

#[test]
fn without_ffmpeg_a_film_says_what_to_install() {
    let folder = ball();
    let words = ["render", "scene.toml", "--frames", "0..2", "--turntable", "-o", "a.mp4"];
    let run = folder.glanz_with(&words, &[("PATH", "/nowhere")]);
    assert_eq!(run.code, 3);
    assert!(
        run.stderr.contains("the program ffmpeg") && run.stderr.contains("apt install ffmpeg"),
        "{}",
        run.stderr
    );
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::PermissionsExt;
    use std::process::Child;
    use std::thread::sleep;
    use std::time::{Duration, Instant};

    use super::*;

    /// Longer than anything here takes on a busy machine.
    const PATIENCE: Duration = Duration::from_secs(60);

    fn wait_for(what: &str, mut is_so: impl FnMut() -> bool) {
        let start = Instant::now();
        while !is_so() {
            assert!(start.elapsed() < PATIENCE, "{what}");
            sleep(Duration::from_millis(20));
        }
    }

    fn start(folder: &Folder, words: &[&str]) -> Child {
        command(&folder.path("")).args(words).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
    }

    fn interrupt(mut child: Child) -> Option<i32> {
        let done =
            std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(done.success());
        child.wait().unwrap().code()
    }

    #[test]
    fn an_interrupted_film_leaves_nothing() {
        let folder = ball();
        for name in ["spin.gif", "spin.apng"] {
            let words = [
                "render",
                "scene.toml",
                "--frames",
                "0..100000",
                "--turntable",
                "-o",
                name,
                "--size",
                "400x300",
            ];
            let child = start(&folder, &words);
            wait_for("the film begins", || folder.names().len() > 1);
            assert_eq!(interrupt(child), Some(130), "{name}");
            assert_eq!(folder.names(), ["scene.toml"], "{name}");
        }
    }

    #[test]
    fn a_watched_scene_is_drawn_again_and_a_mistake_keeps_the_last_picture() {
        let folder = ball();
        let child = start(&folder, &["render", "scene.toml", "--watch"]);
        wait_for("the first picture", || folder.path("scene.png").exists());
        let first = folder.read("scene.png");
        folder.write("scene.toml", "[imag]\n");
        sleep(Duration::from_millis(600));
        assert_eq!(folder.read("scene.png"), first, "the last good picture stays");
        folder.write("scene.toml", BALL.replace("0.7, 0.1, 0.1", "0.1, 0.1, 0.7"));
        wait_for("the second picture", || folder.read("scene.png") != first);
        assert_eq!(interrupt(child), Some(0), "Ctrl-C is the way to end");
        assert_eq!(folder.names(), ["scene.png", "scene.toml"]);
    }

    /// A program in the place of ffmpeg.
    fn with_ffmpeg(folder: &Folder, script: &str) -> String {
        std::fs::create_dir(folder.path("bin")).unwrap();
        folder.write("bin/ffmpeg", format!("#!/bin/sh\n{script}\n"));
        let file = folder.path("bin/ffmpeg");
        std::fs::set_permissions(file, std::fs::Permissions::from_mode(0o755)).unwrap();
        let path = std::env::var("PATH").unwrap();
        format!("{}:{path}", folder.path("bin").display())
    }

    const FILM: [&str; 9] =
        ["render", "scene.toml", "--frames", "0..3", "--turntable", "--size", "8x6", "-o", "a.mp4"];

    #[test]
    fn frames_go_through_ffmpeg() {
        let folder = ball();
        let script =
            "[ \"$1\" = -version ] && exit 0\nfor last; do :; done\necho \"$@\" > words\ncat > \"$last\"";
        let path = with_ffmpeg(&folder, script);
        let run = folder.glanz_with(&FILM, &[("PATH", &path)]);
        assert_eq!((run.code, run.stderr.as_str()), (0, "wrote a.mp4\n"));
        assert_eq!(folder.read("a.mp4").len(), 3 * 8 * 6 * 4);
        let words = String::from_utf8(folder.read("words")).unwrap();
        assert!(
            words.contains("-video_size 8x6 -framerate 25") && words.contains("comment=Software: glanz"),
            "{words}"
        );
    }

    #[test]
    fn a_failing_ffmpeg_leaves_nothing_and_is_quoted() {
        let folder = ball();
        let path = with_ffmpeg(&folder, "[ \"$1\" = -version ] && exit 0\necho 'no such codec' >&2\nexit 1");
        let run = folder.glanz_with(&FILM, &[("PATH", &path)]);
        assert_eq!(run.code, 3);
        assert!(run.stderr.contains("ffmpeg failed: no such codec"), "{}", run.stderr);
        assert_eq!(folder.names(), ["bin", "scene.toml"]);
    }

    #[test]
    fn an_interrupted_ffmpeg_leaves_nothing() {
        let folder = ball();
        let path = with_ffmpeg(&folder, "[ \"$1\" = -version ] && exit 0\ntouch started\nexec sleep 600");
        let mut command = command(&folder.path(""));
        command.args(FILM).env("PATH", &path).stdout(Stdio::null()).stderr(Stdio::null());
        let child = command.spawn().unwrap();
        wait_for("ffmpeg begins", || folder.path("started").exists());
        assert_eq!(interrupt(child), Some(130));
        assert_eq!(folder.names(), ["bin", "scene.toml", "started"]);
    }
}
