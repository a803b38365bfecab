//! A scene that is saved loads back as the same scene.

#![allow(clippy::expect_used, reason = "a test")]

mod scenes;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use glam::DMat4;
use glanz_bsdf::Shape;
use glanz_color::{Ior, Rgb, Spectrum};
use glanz_scene::builtin::Builtin;
use glanz_scene::file::{LoadOptions, WriteError, load, save, write};
use glanz_scene::read::{ReadOptions, read_model};
use glanz_scene::*;
use proptest::prelude::*;

/// A folder of its own, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("glanz-round-trip-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a folder for the test");
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn saved_and_loaded(scene: &Scene) -> Scene {
    let folder = Folder::new();
    let path = folder.0.join("a scene.toml");
    save(&path, scene).expect("the scene can be written");
    let loaded = load(&path, &LoadOptions::default());
    match loaded {
        Ok(loaded) => loaded.scene,
        Err(error) => panic!("{error}\n{}", std::fs::read_to_string(&path).unwrap_or_default()),
    }
}

/// Compares part by part, so that a failure does not print a whole scene.
fn assert_same(scene: &Scene, again: &Scene, what: &str) {
    assert_eq!(scene.image, again.image, "{what}");
    assert_eq!(scene.render, again.render, "{what}");
    assert_eq!(scene.camera, again.camera, "{what}");
    assert_eq!(scene.photometric, again.photometric, "{what}");
    assert!(scene.observer == again.observer, "{what}: observer");
    assert!(scene.eye == again.eye, "{what}: eye");
    assert_eq!(scene.objects, again.objects, "{what}");
    assert!(scene.programs == again.programs && scene.program == again.program, "{what}: programs");
    for (a, b) in scene.lights.iter().zip(&again.lights) {
        assert!(a == b, "{what}: light '{}'", a.name);
    }
    for (a, b) in scene.materials.iter().zip(&again.materials) {
        assert_eq!((&a.name, a.lobes.len()), (&b.name, b.lobes.len()), "{what}");
        for (left, right) in a.lobes.iter().zip(&b.lobes) {
            assert_eq!(left, right, "{what}: material '{}'", a.name);
        }
        assert!(a == b, "{what}: material '{}'", a.name);
    }
    for (a, b) in scene.meshes.iter().zip(&again.meshes) {
        assert_eq!(a.name, b.name, "{what}");
        assert!(a == b, "{what}: mesh '{}'", a.name);
    }
    assert!(scene == again, "{what}: something else");
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn every_scene_of_examples_and_gold_pictures_survives() {
    let mut count = 0;
    for folder in ["examples", "crates/render/tests/golden/scenes"] {
        for entry in std::fs::read_dir(workspace().join(folder)).expect("the folder is there") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                let options = LoadOptions { allow_outside: true, ..LoadOptions::default() };
                let scene = load(&path, &options).expect("it loads").scene;
                assert_same(&scene, &saved_and_loaded(&scene), &path.display().to_string());
                count += 1;
            }
        }
    }
    assert!(count > 25, "{count} scenes");
}

/// A medium that is the same at all wavelengths is no complex number of that name, unless it is written as one.
#[test]
fn media_keep_their_names_also_empty_ones() {
    for name in ["", "mine", "1.5+3i"] {
        let (eta, k) = (Spectrum::constant(1.5), Spectrum::constant(3.0));
        let medium = Arc::new(Ior { name: name.to_owned(), eta, k, source: String::new() });
        let coat = CoatedBoundary {
            below: Boundary::Medium(Arc::clone(&medium)),
            coat: Ior::constant(1.5),
            alpha: 0.1,
        };
        let mirror = || Shape::named("mirror", &[]).expect("it is known");
        let lobes =
            vec![Lobe::new(mirror(), Tint::Ior(medium)), Lobe::new(mirror(), Tint::Coated(Arc::new(coat)))];
        let mut scene = Scene::default();
        scene.materials.push(Material::of_lobes("m", lobes));
        assert_same(&scene, &saved_and_loaded(&scene), name);
    }
}

#[test]
fn models_survive() {
    let mut triangles = 0;
    for folder in ["examples/models", "crates/render/tests/golden/scenes"] {
        for entry in std::fs::read_dir(workspace().join(folder)).expect("the folder is there") {
            let path = entry.expect("an entry").path();
            let Ok(model) = read_model(&path, &ReadOptions::default()) else { continue };
            let mut scene = Scene::default();
            model.append_to(&mut scene, DMat4::IDENTITY, None, true);
            triangles += scene.meshes.iter().map(Mesh::triangle_count).sum::<usize>();
            assert_same(&scene, &saved_and_loaded(&scene), &path.display().to_string());
        }
    }
    assert!(triangles > 100, "{triangles} triangles");
}

#[test]
fn a_side_file_of_another_length_is_refused() {
    let folder = Folder::new();
    let mesh = Builtin::Sphere { radius: 1.0, slices: 16, stacks: 8 }.mesh().expect("in range");
    let scene = Scene { meshes: vec![mesh], ..Scene::default() };
    let path = folder.0.join("ball.toml");
    save(&path, &scene).expect("it can be written");
    let written = write(&scene, "ball-data").expect("it can be written");
    let [(name, bytes)] = &written.files[..] else { panic!("{} files", written.files.len()) };
    std::fs::write(folder.0.join(name), &bytes[4..]).expect("the file is there");
    let error = load(&path, &LoadOptions::default()).expect_err("a word is missing");
    assert!(error.message.contains("expected") && error.message.contains("bytes"), "{error}");
}

#[test]
fn the_old_name_of_transmittance_is_read_with_a_remark() {
    let text = "[materials.a]\ndiffuse = 0.5\nsee_through = 0.25\n";
    let loaded = file::parse_str(text, Path::new(""), &LoadOptions::default()).expect("it is valid");
    assert_eq!(loaded.notes, ["material 'a': 'see_through' is now 'transmittance'"]);
    let seen = loaded.scene.materials[0].transmittance.as_ref();
    assert_eq!(seen, Some(&Transmittance::Constant(Tint::Rgb(Rgb::gray(0.25)))));
}

#[test]
fn every_material_of_the_library_survives() {
    let mut scene = Scene::default();
    for name in library::names() {
        scene.materials.push(library::info(name).expect("a name of the list").material());
    }
    assert_same(&scene, &saved_and_loaded(&scene), "the library");
}

#[test]
fn scenes_survive_json() {
    let options = LoadOptions { allow_outside: true, ..LoadOptions::default() };
    for name in ["full.toml", "fluorescence.toml", "soap.toml"] {
        let scene = load(&workspace().join("examples").join(name), &options).expect("it loads").scene;
        let text = serde_json::to_string(&scene).expect("scenes are plain");
        assert!(serde_json::from_str::<Scene>(&text).expect("it was written so") == scene, "{name}");
    }
}

#[test]
fn a_scene_is_written_as_people_would() {
    let text = "[[lights]]\nkind = \"directional\"\ndirection = [0.0, -1.0, 0.0]\ncolor = 0.5\n\n\
        [materials.red]\ndiffuse = [1.0, 0.0, 0.0]\nspecular = 0.25\nshininess = 64.0\n\n\
        [[objects]]\nname = \"ball\"\nmesh = \"sphere\"\nmaterial = \"red\"\nscale = 2.0\n";
    let loaded = file::parse_str(text, Path::new(""), &LoadOptions::default()).expect("it is valid");
    let written = write(&loaded.scene, "data").expect("it can be written");
    assert_eq!(written.text, text);
    assert!(written.files.is_empty());
}

#[test]
fn what_leads_nowhere_or_is_out_of_range_is_an_error() {
    let material = Material { base_color: Some(TextureUse::plain(3)), ..Material::default_gray() };
    let scene = Scene { materials: vec![material], ..Scene::default() };
    assert!(matches!(write(&scene, ""), Err(WriteError::Index { what: "texture", index: 3, count: 0 })));
    let image = Image { width: 0, ..Image::default() };
    assert!(matches!(write(&Scene { image, ..Scene::default() }, ""), Err(WriteError::Range(_))));
    let render = RenderSettings { ev: f64::NAN, ..RenderSettings::default() };
    assert!(matches!(write(&Scene { render, ..Scene::default() }, ""), Err(WriteError::Range(_))));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, max_shrink_iters: 64, ..ProptestConfig::default() })]

    #[test]
    fn any_scene_survives(scene in scenes::scene()) {
        assert_same(&scene, &saved_and_loaded(&scene), "a generated scene");
    }

    #[test]
    fn any_scene_survives_serde(scene in scenes::scene()) {
        let text = serde_json::to_string(&scene).expect("scenes are plain");
        let again: Scene = serde_json::from_str(&text).expect("it was written so");
        assert_same(&scene, &again, "a generated scene");
    }
}
