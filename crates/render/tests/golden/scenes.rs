//! Scenes with what single balls do not have: textures, normal maps, luminaires, glTF, vertex colours, blending.

use glanz_scene::file::{LoadOptions, load};

use super::{drawn, hash, shelf};

#[test]
fn every_scene_draws_its_gold_picture() {
    let folder = shelf::folder().join("scenes");
    let mut scenes: Vec<_> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    scenes.sort();
    assert!(scenes.len() >= 8, "the scenes are in {}", folder.display());
    let pictures = scenes.iter().map(|path| {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let scene =
            load(path, &LoadOptions::default()).unwrap_or_else(|error| panic!("{name}: {error}")).scene;
        let drawn = drawn(&scene);
        let size = [scene.image.width as usize, scene.image.height as usize];
        (name, size, drawn.rgba, hash::of(&drawn.frame))
    });
    shelf::compare("pictures", pictures.collect());
}
