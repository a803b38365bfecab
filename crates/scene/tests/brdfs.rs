//! Users' BRDFs in scenes.
#![cfg(feature = "shader")]

use std::path::PathBuf;

use glanz_bsdf::{DirectionPair, LightTerm, Shape};
use glanz_scene::file::{self, FileError, LoadOptions, Loaded};
use glanz_scene::{Lobe, Scene};

const PHONG: &str = "::begin parameters\nfloat n 1 100 20\n::end parameters\n::begin shader\n#include \"pi.glsl\"\n\
    vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n  return vec3(pow(max(dot(reflect(-L, N), V), 0.0), n) / (PI * dot(N, L)));\n}\n::end shader\n";

/// A folder of its own with the BRDF, what it includes, and a faulty one.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("glanz-scene-brdfs-{name}-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("lib")).expect("the folder takes files");
    std::fs::write(folder.join("lib/phong.brdf"), PHONG).expect("the folder takes files");
    std::fs::write(folder.join("lib/pi.glsl"), "const float PI = 3.14159265358979;\n")
        .expect("the folder takes files");
    std::fs::write(folder.join("wrong.brdf"), PHONG.replace("PI *", "PJ *").replace("#include", "//"))
        .expect("the folder takes files");
    folder
}

fn load(name: &str, lobe: &str) -> Result<Loaded, FileError> {
    let folder = folder(name);
    let text =
        format!("[materials.own]\nlobes = [{lobe}]\n[[objects]]\nmesh = \"sphere\"\nmaterial = \"own\"\n");
    let loaded = file::parse_str(&text, &folder, &LoadOptions::default());
    std::fs::remove_dir_all(folder).expect("the folder takes files");
    loaded
}

fn lobe(scene: &Scene) -> &Lobe {
    let material = scene.materials.iter().find(|material| material.name == "own").expect("it is in the file");
    &material.lobes[0]
}

#[test]
fn a_file_beside_the_scene_is_a_shape_with_its_parameters() {
    let loaded =
        load("file", "{ shape = { file = \"lib/phong.brdf\", n = 12 }, tint = { ior = \"Au\" } }").unwrap();
    let shape = &lobe(&loaded.scene).shape;
    assert_eq!(
        (shape.info().name, shape.params(), shape.info().term),
        ("phong.brdf", vec![12.0], LightTerm::Specular)
    );
    let built_in = Shape::named("phong", &[("shininess", 12.0)]).unwrap();
    let pair = DirectionPair::isotropic(0.8_f32, 0.7, 0.9);
    let (own, expected) = (shape.f_cos(&pair), built_in.f_cos(&pair));
    assert!((own - expected).abs() < 1e-6, "{own} {expected}");
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
    let matte = load("function", "{ shape = { function = \"1 / pi\", term = \"diffuse\" } }").unwrap();
    let lobe = lobe(&matte.scene);
    assert_eq!((lobe.shape.info().term, lobe.textured), (LightTerm::Diffuse, true));
}

#[test]
fn a_scene_with_a_brdf_is_written_hashed_and_serialised() {
    let load = |name: &str, n: u32| {
        load(name, &format!("{{ shape = {{ file = \"lib/phong.brdf\", n = {n} }}, tint = [0.5, 0.6, 0.7] }}"))
            .unwrap()
            .scene
    };
    let (scene, same, other) = (load("a", 12), load("b", 12), load("c", 13));
    assert_eq!(scene, same);
    assert_eq!(scene.content_hash(), same.content_hash());
    assert_ne!(scene.content_hash(), other.content_hash());
    let written = file::write(&scene, "data").unwrap();
    assert!(written.text.contains("name = \"phong.brdf\", n = 12"), "{}", written.text);
    let folder = folder("written");
    std::fs::create_dir_all(folder.join("data")).unwrap();
    for (name, bytes) in &written.files {
        std::fs::write(folder.join(name), bytes).unwrap();
    }
    let again = file::parse_str(&written.text, &folder, &LoadOptions::default()).unwrap().scene;
    std::fs::remove_dir_all(folder).unwrap();
    assert_eq!(again, scene);
    assert_eq!(again.content_hash(), scene.content_hash());
    let json = serde_json::to_string(&scene).unwrap();
    assert_eq!(serde_json::from_str::<Scene>(&json).unwrap(), scene);
}

#[test]
fn what_is_wrong_is_told_at_its_place() {
    let error = |lobe: &str| load("wrong", lobe).unwrap_err().to_string();
    for (lobe, expected) in [
        ("{ shape = { file = \"wrong.brdf\" } }", "2:29: wrong.brdf:7:59: 'PJ' is not declared"),
        ("{ shape = { file = \"none.brdf\" } }", "2:29: there is no file 'none.brdf'"),
        ("{ shape = { file = \"../x.brdf\" } }", "leaves the folder of the scene file"),
        (
            "{ shape = { file = \"lib/phong.brdf\", n = 500 } }",
            "2:51: parameter 'n' of model 'phong.brdf' is 500, but must be between 1 and 100",
        ),
        (
            "{ shape = { file = \"lib/phong.brdf\", m = 5 } }",
            "2:47: model 'phong.brdf' has no parameter 'm'; it has: n",
        ),
        (
            "{ shape = { file = \"lib/phong.brdf\" }, n = 5 }",
            "unknown key 'n' in a lobe of a BRDF of one's own",
        ),
        ("{ shape = { function = \"1 / p\" } }", "expression:1:5: 'p' is not declared"),
        ("{ shape = { n = 5 } }", "a BRDF needs its 'file', or its 'function'"),
        (
            "{ shape = { file = \"a\", function = \"b\" } }",
            "a BRDF is from a 'file' or a 'function', not both",
        ),
        ("{ shape = 5 }", "the name of a shape, or a BRDF such as"),
    ] {
        let error = error(lobe);
        assert!(error.contains(expected), "{lobe}: {error}");
    }
}
