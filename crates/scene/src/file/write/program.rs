//! Shaders in place of materials.

use super::names::Names;
use super::side_files::SideFiles;
use super::text::{Table, numbers, string};
use crate::{Program, ProgramText, UniformValue};

/// A program as a value.
pub(super) fn value(program: &Program, names: &Names, files: &mut SideFiles) -> String {
    let mut table = Table::default();
    for (key, text) in [("vertex", &program.vertex), ("fragment", &program.fragment)] {
        if let Some(text) = text {
            table.put(key, string(&file(text, files)));
        }
    }
    let mut uniforms = Table::default();
    for (name, value) in &program.uniforms {
        let value = match value {
            UniformValue::Numbers(values) => numbers(values),
            UniformValue::Texture(texture) => string(&names.textures[*texture]),
            UniformValue::Cube(faces) => {
                format!("[{}]", faces.map(|face| string(&names.textures[face])).join(", "))
            }
        };
        uniforms.put(name, value);
    }
    table.put_unless(program.uniforms.is_empty(), "uniforms", uniforms.inline());
    table.inline()
}

/// The name of a text's file; what it includes is beside it.
fn file(text: &ProgramText, files: &mut SideFiles) -> String {
    let own = text.name.rsplit(['/', '\\']).next().unwrap_or_default();
    let own = if own.is_empty() { "shader" } else { own };
    let includes = text.includes.iter().map(|(name, text)| (name.as_str(), text.as_bytes()));
    let all: Vec<_> = std::iter::once((own, text.text.as_bytes())).chain(includes).collect();
    files.add_folder("program", &all)
}
