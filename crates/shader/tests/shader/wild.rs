//! Shaders of others, from a folder that is named: `GLANZ_SHADERS=folder cargo test --release -p glanz-shader --test shader
//! wild -- --ignored --nocapture`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glanz_math::SimdLevel;
use glanz_shader::{Program, Shader, ShaderError, Stage};

use crate::common::{Numbers, outputs_at};

fn files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() { files(&path, out) } else { out.push(path) }
    }
}

fn stage(path: &Path) -> Option<Stage> {
    let name = path.file_name()?.to_str()?;
    let end = name.rsplit('.').next()?;
    match end {
        "vs" | "vert" | "vertexshader" | "vshader" => Some(Stage::Vertex),
        "fs" | "frag" | "fragmentshader" | "fshader" | "brdf" => Some(Stage::Fragment),
        _ => None,
    }
}

/// The texts of the folder.
pub(crate) fn texts() -> Vec<String> {
    let mut all = Vec::new();
    if let Ok(folder) = std::env::var("GLANZ_SHADERS") {
        files(Path::new(&folder), &mut all);
    }
    all.sort();
    all.iter()
        .filter(|path| stage(path).is_some())
        .filter_map(|path| std::fs::read_to_string(path).ok())
        .collect()
}

/// Bits of all outputs; NaN is all the same.
fn bits(program: &Program, level: SimdLevel) -> Vec<[u32; 16]> {
    let mut numbers = Numbers(9);
    let mut uniforms = program.uniforms();
    for uniform in &program.interface().uniforms {
        let values: Vec<f32> = (0..uniform.ty.scalars()).map(|_| numbers.unit() * 2.0).collect();
        uniforms.set(&uniform.name, &values).expect("it is there");
    }
    let out = outputs_at(program, &uniforms, level, &|i, k, lane| {
        ((i * 7 + k * 3 + lane) % 17) as f32 * 0.11 - 0.7
    });
    out.into_iter().map(|row| row.map(|x| if x.is_nan() { 1 } else { x.to_bits() })).collect()
}

#[test]
#[ignore = "needs shaders of others"]
fn wild_shaders_pass_or_say_why_not() {
    let Ok(folder) = std::env::var("GLANZ_SHADERS") else { return };
    let mut all = Vec::new();
    files(Path::new(&folder), &mut all);
    all.sort();
    let (mut passed, mut total) = (0, 0);
    let mut reasons: BTreeMap<String, usize> = BTreeMap::new();
    for path in &all {
        let (Some(stage), Ok(text)) = (stage(path), std::fs::read_to_string(path)) else { continue };
        total += 1;
        let include = |name: &str, _: &str| std::fs::read_to_string(path.parent()?.join(name)).ok();
        let shader = Shader::new(stage, text).named(path.display().to_string()).include(&include);
        match shader.compile() {
            Ok(program) => {
                // A trace leaves nothing out.
                let traced = shader.traced().compile().expect("it compiles");
                assert_eq!(bits(&program, SimdLevel::best()), bits(&traced, SimdLevel::best()), "{path:?}");
                let first = bits(&program, SimdLevel::narrowest());
                assert!(
                    SimdLevel::available().into_iter().all(|(_, level)| bits(&program, level) == first),
                    "{path:?}"
                );
                program.warnings().iter().for_each(|w| println!("warning: {}", w.message));
                passed += 1;
            }
            Err(error) => {
                let message = match &error {
                    ShaderError::Invalid { message, .. } | ShaderError::Unsupported { message, .. } => {
                        message.clone()
                    }
                    ShaderError::Broken => "broken".to_owned(),
                };
                println!("{error}");
                *reasons.entry(message).or_default() += 1;
            }
        }
    }
    println!("{passed} of {total} pass");
    let mut reasons: Vec<_> = reasons.into_iter().collect();
    reasons.sort_by_key(|r| std::cmp::Reverse(r.1));
    reasons.iter().for_each(|(reason, n)| println!("{n:4} {reason}"));
}
