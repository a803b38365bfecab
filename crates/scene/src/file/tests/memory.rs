//! What scenes may take of memory.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::io::Cursor;
use std::path::PathBuf;

use glanz_math::MemoryBudget;

use super::*;
use crate::memory::{LEAST_TRIANGLE_BYTES, environment_bytes, texture_bytes};
use crate::{OpenError, open};

/// A folder with two white pictures of 64×32 texels, two skies of 16×8 pixels, and a model of two triangles that is there often.
struct Folder(PathBuf);

/// How often the model has its mesh.
const NODES: u64 = 500;

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glanz-memory-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        let mut png = Cursor::new(Vec::new());
        image::GrayImage::new(64, 32).write_to(&mut png, image::ImageFormat::Png).unwrap();
        let mut sky = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n".to_vec();
        sky.extend([9, 9, 9, 128].repeat(8 * 16));
        for file in ["a", "b"] {
            std::fs::write(path.join(file).with_extension("png"), png.get_ref()).unwrap();
            std::fs::write(path.join(file).with_extension("hdr"), &sky).unwrap();
        }
        let nodes = vec!["{\"mesh\":0}"; NODES as usize].join(",");
        let model = format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{nodes}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],
            "buffers":[{{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}]}}"#
        );
        std::fs::write(path.join("m.gltf"), model).unwrap();
        Self(path)
    }

    fn parse(&self, text: &str, bytes: u64) -> Result<Loaded, String> {
        parse_str(text, &self.0, &options(bytes)).map_err(|error| error.message)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn options(bytes: u64) -> LoadOptions {
    LoadOptions { memory: MemoryBudget::of_bytes(bytes), ..LoadOptions::default() }
}

#[test]
fn textures_together_are_within_the_budget() {
    let folder = Folder::new("textures");
    let text = "[textures.a]\nfile = 'a.png'\n[textures.b]\nfile = 'b.png'\n";
    let both = 2 * texture_bytes(64, 32);
    assert!(folder.parse(text, both).is_ok());
    let message = folder.parse(text, both - 1).unwrap_err();
    assert!(
        message.contains("found 38.3 kB: 19.2 kB for a texture of 64×32 texels beside 19.2 kB of what came before; it takes at least --memory 39kB"),
        "{message}"
    );
}

#[test]
fn environments_together_are_within_the_budget() {
    let folder = Folder::new("environments");
    let light = |file: &str| format!("[[lights]]\nkind = 'environment'\nfile = '{file}.hdr'\n");
    let text = light("a") + &light("b");
    let both = 2 * environment_bytes(16, 8);
    assert!(folder.parse(&text, both).is_ok());
    let message = folder.parse(&text, both - 1).unwrap_err();
    assert!(
        message.contains("for an environment of 16×8 pixels beside 3.59 kB of what came before"),
        "{message}"
    );
}

#[test]
fn triangles_are_within_the_budget_however_they_come_in() {
    let folder = Folder::new("triangles");
    let bytes = NODES * LEAST_TRIANGLE_BYTES;
    let asked = format!("{NODES} triangles; it takes at least --memory");
    let from_file = "[[objects]]\nmesh = { file = 'm.gltf' }\n";
    let found = folder.parse(from_file, bytes - 1).unwrap_err();
    assert!(folder.parse(from_file, bytes).is_ok() && found.contains(&asked), "{found}");
    let model = folder.0.join("m.gltf");
    let Err(OpenError::Model(error)) = open(&model, &options(bytes - 1)) else { panic!("it is too large") };
    assert!(open(&model, &options(bytes)).is_ok() && error.to_string().contains(&asked), "{error}");
    let many = "[[objects]]\nmesh = 'quad'\n".repeat(NODES as usize / 2);
    let found = folder.parse(&many, bytes - 1).unwrap_err();
    assert!(folder.parse(&many, bytes).is_ok() && found.contains(&asked), "{found}");
    let cut = "[[objects]]\nmesh = { sphere = { slices = 500, stacks = 101 } }\nsubdivide = 7\n";
    assert!(folder.parse(cut, u64::MAX).unwrap_err().contains("expected at most 500000000 triangles"));
}
