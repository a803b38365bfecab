//! A program that uses the library gets what the scene file says: the picture of the command.

use glanz_render::Shot;
use glanz_scene::file::{LoadOptions, load};
use glanz_scene::open;

use crate::folder::Folder;
use crate::pictures::Png;

const SCENE: &str = r#"[image]
width = 48
height = 40
background = [0.0, 0.0, 0.0]

[render]
mode = "spectral"

[camera]
projection = "orthographic"
eye = [0.0, 0.0, 4.0]
height = 2.4

[[lights]]
kind = "directional"
direction = [-1.0, -1.0, -1.0]
spectrum = "A"

[materials.orange]
model = "blinn-phong"
diffuse = { spectrum = "orange" }
specular = 0.4
shininess = 20

[[objects]]
mesh = { sphere = { slices = 12, stacks = 7 } }
material = "orange"
"#;

/// What a scene file can say of the picture, each as values on top of a scene.
const SETTINGS: [&[&str]; 16] = [
    &[],
    &["render.ev=1.5"],
    &["render.tone_map='reinhard'"],
    &["render.show='normals'"],
    &["render.show='depth'"],
    &["render.mode='rgb'"],
    &["render.mode='meyer'"],
    &["render.mode='sampled:5'"],
    &["render.shading='flat'"],
    &["render.shading='gouraud'", "render.interpolation='scanline'"],
    &["render.white='scene'", "lights.0.spectrum='FL11'"],
    &["render.observer='cie1964'"],
    &["image.samples=8", "image.supersample=true"],
    &["image.background='transparent'"],
    &["image.background=[0.1, 0.5, 0.2]"],
    &["camera.height=3.0"],
];

#[test]
fn the_library_draws_what_the_command_draws() {
    let folder = Folder::new();
    folder.write("scene.toml", SCENE);
    let mut pictures = Vec::new();
    for settings in SETTINGS {
        let sets = settings.iter().flat_map(|set| ["--set", set]);
        let words: Vec<&str> = ["render", "scene.toml", "-o", "-"].into_iter().chain(sets).collect();
        let run = folder.glanz(&words);
        assert_eq!(run.code, 0, "{settings:?}: {}", run.stderr);
        let command = Png::decode(&run.stdout).rgba;

        let pair = |set: &&str| set.split_once('=').map(|(key, value)| (key.to_owned(), value.to_owned()));
        let sets = settings.iter().filter_map(pair).collect();
        let options = LoadOptions { sets, ..LoadOptions::default() };
        let scene = load(&folder.path("scene.toml"), &options).unwrap().scene;
        let library = Shot::new(&scene).unwrap().rgba8().unwrap();
        assert!(library == command, "{settings:?}");
        pictures.push(library);
    }
    // Each value changes the picture: none of them is read past.
    for (settings, picture) in SETTINGS.iter().zip(&pictures).skip(1) {
        assert!(*picture != pictures[0], "{settings:?} changes nothing");
    }
}

#[test]
fn the_library_writes_the_files_of_the_command() {
    let folder = Folder::new();
    folder.write("scene.toml", SCENE);
    folder.write("rgb.toml", SCENE.replace("mode = \"spectral\"", "mode = \"rgb\""));
    folder
        .write("tall.toml", SCENE.replace("[render]", "[render]\nobserver = \"cie1964\"\nwhite = \"scene\""));
    folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for input in ["scene.toml", "rgb.toml", "tall.toml", "triangle.obj"] {
        for ending in ["png", "exr", "gif", "apng"] {
            let (ours, theirs) = (format!("library-{input}.{ending}"), format!("command-{input}.{ending}"));
            let run = folder.glanz(&["render", input, "-o", &theirs]);
            assert_eq!(run.code, 0, "{input}: {}", run.stderr);
            let scene = open(&folder.path(input), &LoadOptions::default()).unwrap().scene;
            Shot::new(&scene).unwrap().save(folder.path(&ours)).unwrap();
            let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
            assert!(bytes(&ours) == bytes(&theirs), "{input} as {ending}");
        }
    }
}
