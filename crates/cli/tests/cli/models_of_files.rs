//! Models as other programs write them: names, cameras, variants, textures, and files that are not there.

use serde_json::{Value, json};

use crate::folder::Folder;

/// A triangle seen by two cameras, whose names are hard to write, in two variants.
fn triangle() -> Value {
    let camera = |name: &str| json!({ "type": "perspective", "name": name, "perspective": { "yfov": 0.8 } });
    json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_materials_variants"],
        "extensions": { "KHR_materials_variants": { "variants": [{ "name": "red" }, { "name": "blue\nsky" }] } },
        "cameras": [camera("cafe\u{301}"), camera("left\nright")],
        "nodes": [
            { "mesh": 0, "name": "leaf\nblade" },
            { "camera": 0, "translation": [0, 0, 3] },
            { "camera": 1, "translation": [1, 0, 3] },
        ],
        "materials": [{
            "name": "green\ngrass",
            "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 } },
            "occlusionTexture": { "index": 0 },
        }],
        "textures": [{ "source": 0 }],
        "images": [{ "uri": "white.png" }],
        "meshes": [{ "name": "leaf", "primitives": [{ "attributes": { "POSITION": 0 }, "material": 0 }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
        "buffers": [{
            "byteLength": 36,
            "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA",
        }],
    })
}

fn folder() -> Folder {
    let folder = Folder::with_scene();
    folder.write("a.gltf", triangle().to_string());
    folder.write("a.toml", "[[objects]]\nmesh = { file = \"a.gltf\" }\n");
    folder.glanz(&["render", "scene.toml", "-o", "white.png"]).text();
    folder
}

#[test]
fn a_camera_is_found_by_name_and_by_number_in_models_and_in_scenes() {
    let folder = folder();
    for scene in ["a.gltf", "a.toml"] {
        let picture = |camera: &str| {
            let run = folder.glanz(&["render", scene, "--camera", camera, "--size", "24x16", "-o", "a.png"]);
            assert_eq!(run.code, 0, "{scene} {camera}: {}", run.stderr);
            folder.read("a.png")
        };
        assert_eq!(picture("cafe\u{301}"), picture("0"), "{scene}");
        assert_eq!(picture("left\nright"), picture("1"), "{scene}");
        assert_ne!(picture("0"), picture("1"), "{scene}");
        let run = folder.glanz(&["render", scene, "--camera", "2", "-o", "b.png"]);
        assert_eq!(run.code, 2, "{scene}: {}", run.stderr);
        assert!(run.stderr.contains("cafe\u{301}") && run.stderr.contains("left?right"), "{}", run.stderr);
    }
}

#[test]
fn names_stay_in_their_line() {
    let folder = folder();
    let told = folder.glanz(&["info", "a.gltf", "--matrices", "--vertices"]);
    for name in ["leaf?blade", "left?right", "green?grass", "blue?sky"] {
        assert!(told.text().contains(name), "{name}: {}", told.text());
    }
    let run = folder.glanz(&["info", "a.gltf", "--variant", "gre\nen"]);
    assert!(
        run.code == 3 && run.stderr.contains("blue?sky") && run.stderr.contains("gre?en"),
        "{}",
        run.stderr
    );
    let run = folder.glanz(&["shader", "export", "a.gltf", "-o", "program"]);
    assert!(run.code == 0 && !run.stderr.contains("green\ngrass"), "{}", run.stderr);
}

#[test]
fn info_lists_all_textures_and_variants() {
    let folder = folder();
    let told = folder.glanz(&["info", "a.gltf"]);
    assert!(told.text().contains("textures: metal and roughness, occlusion"), "{}", told.text());
    assert!(told.text().contains("variants of materials: 2\n    red\n    blue?sky\n"), "{}", told.text());
    let facts = folder.glanz(&["info", "a.gltf", "--format", "json"]).json();
    assert_eq!(facts["variants"], json!(["red", "blue\nsky"]));
    assert_eq!(facts["materials"][0]["textures"], json!(["metal and roughness", "occlusion"]));
}

#[test]
fn an_unknown_variant_is_marked_itself() {
    let folder = folder();
    let scene = |mesh: &str| format!("[[objects]]\nmesh = {{ file = \"{mesh}\" }}\nvariant = \"green\"\n");
    folder.write("wrong.toml", scene("a.gltf"));
    let run = folder.glanz(&["info", "wrong.toml", "--format", "json"]);
    assert_eq!(run.code, 3);
    let json: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(
        (json["error"]["line"].as_u64(), json["error"]["column"].as_u64()),
        (Some(3), Some(11)),
        "{json}"
    );
    // What is wrong with the file itself is marked there.
    folder.write("broken.gltf", "{}");
    folder.write("wrong.toml", scene("broken.gltf"));
    let run = folder.glanz(&["info", "wrong.toml", "--format", "json"]);
    let json: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(json["error"]["line"].as_u64(), Some(2), "{json}");
}

#[test]
fn a_pointer_of_git_lfs_is_told_with_what_fetches_the_file() {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n";
    let folder = folder();
    folder.write("b.glb", pointer);
    let run = folder.glanz(&["render", "b.glb", "-o", "a.png"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(
        run.stderr.contains("the pointer of Git LFS") && run.stderr.contains("git lfs pull"),
        "{}",
        run.stderr
    );
    folder.write("white.png", pointer);
    let run = folder.glanz(&["info", "a.gltf"]);
    assert!(
        format!("{}{}", run.stderr, String::from_utf8_lossy(&run.stdout)).contains("git lfs pull"),
        "{run:?}"
    );
}

#[test]
fn more_masks_than_a_material_takes_are_told_with_their_place() {
    let folder = folder();
    // Of two lobes, which have so many together; the first stands in lines 3 to 11.
    let drawn = |second: usize| {
        let mask = |i: usize| format!("  {{ picture = {{ file = \"white.png\", repeat = [{i}, 1] }} }},\n");
        let lobe = |range: std::ops::Range<usize>| {
            let masks: String = range.map(mask).collect();
            format!("[[materials.a.lobes]]\nshape = \"lambert\"\nmasks = [\n{masks}]\n")
        };
        let lobes = lobe(1..9) + &lobe(9..9 + second);
        folder.write("masks.toml", format!("{lobes}[[objects]]\nmesh = \"quad\"\nmaterial = \"a\"\n"));
        folder.glanz(&["render", "masks.toml", "--size", "8x8", "-o", "masks.png", "--format", "json"])
    };
    assert_eq!(drawn(8).code, 0, "{:?}", drawn(8));
    let run = drawn(9);
    assert_eq!(run.code, 3, "{run:?}");
    let json: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert!(json["error"]["message"].as_str().unwrap().contains("at most 16 channels of pictures"), "{json}");
    assert_eq!(json["error"]["line"], 24, "{json}");
}

#[test]
fn objects_that_reach_too_far_for_a_camera_are_told() {
    let folder = folder();
    let mut far = triangle();
    far["nodes"] = json!([{ "mesh": 0, "scale": [1e308, 1, 1] }]);
    folder.write("far.gltf", far.to_string());
    let run = folder.glanz(&["render", "far.gltf", "-o", "a.png"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(
        run.stderr.contains("no camera shows all of them") && run.stderr.contains("--eye"),
        "{}",
        run.stderr
    );
}
