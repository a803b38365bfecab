//! `glanz devices`, and `--device`.

use serde_json::Value;

use crate::folder::Folder;

const SCENE: &str = "[image]\nwidth = 32\nheight = 24\nsamples = 1\n[[objects]]\nmesh = \"sphere\"\n\
    [[lights]]\nkind = \"point\"\nposition = [1, 2, 3]\n";
const NORMALS: &str = "#version 330\nin vec3 normal; out vec4 color;\n\
    void main() { color = vec4(0.5 * normalize(normal) + 0.5, 1.0); }\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("scene.toml", SCENE);
    folder.write("normals.frag", NORMALS);
    folder
}

/// The GPUs that are listed, by what --device takes.
fn gpus(folder: &Folder) -> Vec<String> {
    let run = folder.glanz(&["devices", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "drivers are quiet");
    let document: Value = serde_json::from_slice(&run.stdout).unwrap();
    let list = document["devices"].as_array().unwrap();
    assert_eq!((&list[0]["device"], &list[0]["draws"]), (&Value::from("cpu"), &Value::from("everything")));
    list[1..].iter().map(|own| own["device"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn every_device_that_is_listed_draws_programs() {
    let folder = folder();
    let found = gpus(&folder);
    if found.is_empty() {
        eprintln!("!!! SKIPPED: there is no GPU here");
    }
    let cpu = folder.glanz(&["render", "scene.toml", "--fs", "normals.frag", "-o", "cpu.png"]);
    assert_eq!(cpu.code, 0, "{}", cpu.stderr);
    for device in found {
        let words = ["render", "scene.toml", "--fs", "normals.frag", "--device", &device, "-o", "gpu.png"];
        let run = folder.glanz(&words);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(run.stderr.contains("note: drawn by "), "{}", run.stderr);
        let run = folder.glanz(&["compare", "cpu.png", "gpu.png", "--format", "json"]);
        let document: Value = serde_json::from_slice(&run.stdout).unwrap();
        let worst = document["metrics"]["de2000"]["max"].as_f64().unwrap();
        assert!(worst < 1.0, "{device}: {document}");
    }
}

#[test]
fn materials_are_not_drawn_by_gpus() {
    let folder = folder();
    let run = folder.glanz(&["render", "scene.toml", "--device", "gpu", "-o", "x.png"]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    assert!(run.stderr.contains("object 1 of the scene has none"), "{}", run.stderr);
    let run = folder.glanz(&["render", "scene.toml", "--device", "auto", "-o", "x.png"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("note: drawn by the CPU: "), "{}", run.stderr);
}

#[test]
fn devices_that_are_not_there_are_an_error() {
    let folder = folder();
    let run = folder.glanz(&["render", "scene.toml", "--device", "cuda", "-o", "x.png"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("expected cpu, gpu, gpu:WORDS or auto"), "{}", run.stderr);
    let words = ["render", "scene.toml", "--fs", "normals.frag", "--device", "gpu:warp drive", "-o", "x.png"];
    let run = folder.glanz(&words);
    assert_eq!(run.code, 3);
    assert!(run.stderr.starts_with("error: --device: "), "{}", run.stderr);
    assert!(!folder.names().contains(&"x.png".to_owned()), "nothing is written");
}
