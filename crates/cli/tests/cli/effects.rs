//! No option does nothing without a word.

use crate::folder::{Folder, SCENE};

/// Options without effect on the usual scene, which is drawn in RGB and by no program, and what is said of each.
const WITHOUT_EFFECT: [(&[&str], &str); 11] = [
    (&["render", "scene.toml", "--fps", "10", "-o", "a.png"], "--frames"),
    (&["render", "scene.toml", "--time", "2", "-o", "a.png"], "--time needs a program"),
    (&["render", "scene.toml", "--mouse", "2,3", "-o", "a.png"], "--mouse needs a program"),
    (&["sweep", "scene.toml", "--vary", "render.ev=0,1", "--time", "2"], "--time needs a program"),
    (&["render", "scene.toml", "--white", "light", "-o", "a.png"], "--white has no effect in mode rgb"),
    (
        &["sweep", "scene.toml", "--vary", "render.ev=0,1", "--white", "light"],
        "--white has no effect in mode rgb",
    ),
    (&["render", "scene.toml", "--ev", "1", "-o", "a.exr"], "--ev is for pictures of codes"),
    (
        &["render", "scene.toml", "--tone-map", "reinhard", "-o", "a.exr"],
        "--tone-map is for pictures of codes",
    ),
    (&["render", "scene.toml", "--dither", "-o", "a.exr"], "--dither is for pictures of codes"),
    (
        &["render", "scene.toml", "--bit-depth", "16", "-o", "a.exr"],
        "--bit-depth 16 is for pictures of codes",
    ),
    (&["render", "scene.toml", "--bit-depth", "16", "--dither", "-o", "a.png"], "--dither has no effect"),
];

#[test]
fn an_option_without_effect_is_refused() {
    let folder = Folder::with_scene();
    for (words, said) in WITHOUT_EFFECT {
        let run = folder.glanz(words);
        assert_eq!(run.code, 2, "{words:?}: {}", run.stderr);
        assert!(run.stderr.contains(said), "{words:?}: {}", run.stderr);
    }
    assert_eq!(folder.names(), ["scene.toml"]);
}

#[test]
fn the_same_options_are_taken_where_they_have_an_effect() {
    let folder = Folder::with_scene();
    folder.write("a.frag", crate::shader::FRAGMENT);
    for words in [
        &["render", "scene.toml", "--frames", "0..2", "--turntable", "--fps", "10", "-o", "a.gif"][..],
        &["render", "scene.toml", "--fs", "a.frag", "--time", "2", "--mouse", "1,1", "-o", "a.png"],
        &["render", "scene.toml", "--mode", "spectral", "--white", "light", "-o", "a.png"],
        &["modes", "scene.toml", "--white", "light", "--modes", "rgb,spectral", "-o", "a.png"],
        &["relight", "scene.toml", "--white", "scene", "--light", "A", "-o", "a.png"],
        &["render", "scene.toml", "--ev", "1", "--preview=blocks", "-o", "a.exr"],
        &["render", "scene.toml", "--bit-depth", "16", "--ev", "1", "-o", "a.png"],
    ] {
        let run = folder.glanz(words);
        assert_eq!(run.code, 0, "{words:?}: {}", run.stderr);
    }
}

#[test]
fn the_time_of_a_program_reaches_all_commands_that_draw() {
    let folder = Folder::new();
    folder.write("scene.toml", SCENE);
    folder.write(
        "a.frag",
        "#version 330\nuniform float time;\nout vec4 color;\nvoid main() { color = vec4(vec3(time / 2.0), 1.0); }\n",
    );
    for words in [
        &["render", "scene.toml"][..],
        &["sweep", "scene.toml", "--vary", "render.ev=0,1"],
        &["shade-compare", "scene.toml"],
    ] {
        let picture = |time: &str| {
            let more = ["--fs", "a.frag", "--time", time, "-o", "a.png"];
            let run = folder.glanz(&[words, &more].concat());
            assert_eq!(run.code, 0, "{words:?}: {}", run.stderr);
            folder.read("a.png")
        };
        assert_ne!(picture("0"), picture("1"), "{words:?}");
    }
}
