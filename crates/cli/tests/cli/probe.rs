//! `glanz probe`: the names that it gives are those that other options take.

use crate::folder::Folder;

#[test]
fn lights_are_named_as_paths_name_them() {
    let folder = Folder::new();
    folder.glanz(&["example", "ball"]);
    let lamp = folder.glanz(&["probe", "ball.toml", "150,150"]);
    let lamp = lamp.text();
    assert!(lamp.contains("lights.0, directional 'lamp': "), "{lamp}");
    let off = folder.glanz(&["probe", "ball.toml", "150,150", "--set", "lights.0.intensity=0"]);
    let off = off.text();
    assert!(off.contains("lights.0, directional 'lamp': (0, 0, 0)"), "{off}");
    let run = folder.glanz(&["probe", "ball.toml", "150,150", "--format", "json"]);
    assert_eq!(run.json()["pixels"][0]["surface"]["points"][0]["lights"][0]["light"], 0);
}
