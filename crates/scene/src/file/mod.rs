//! Scene files: TOML with a JSON Schema from the same types.
//!
//! [`load`] reads a file, [`parse_str`] a text; [`save`] and [`write()`] are their inverses. A scene file is taken literally: without lights the
//! picture is dark. Unknown keys are refused with the nearest known name; every error has its place.
//! The tables of a file are described by [`schema`], with all keys, ranges and defaults.
//!
//! A file has at most 16 MiB, names no file outside of its folder unless that is allowed, and makes no
//! more than 500 million triangles. What takes memory asks a budget first ([`LoadOptions::memory`]).
//!
//! ```
//! use glanz_scene::file::{LoadOptions, parse_str, write};
//!
//! let text = "[materials.red]\ndiffuse = [0.7, 0.1, 0.1]\n[[objects]]\nmesh = \"cube\"\nmaterial = \"red\"\n";
//! let sets = vec![("materials.red.shininess".to_owned(), "64".to_owned())];
//! let options = LoadOptions { sets, ..LoadOptions::default() };
//! let loaded = parse_str(text, "".as_ref(), &options)?;
//! assert_eq!(loaded.scene.objects.len(), 1);
//! // And back.
//! let written = write(&loaded.scene, "files")?;
//! assert_eq!(parse_str(&written.text, "".as_ref(), &LoadOptions::default())?.scene, loaded.scene);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod build;
mod error;
mod explain;
mod factors;
pub(crate) mod near;
mod schema;
mod sets;
mod tables;
#[cfg(test)]
mod tests;
mod write;

use std::path::Path;

pub use error::FileError;
use glanz_math::MemoryBudget;
pub use schema::schema;
use serde::Deserialize;
use toml::Spanned;
use toml::de::DeTable;
pub use write::{WriteError, Written, save, write};

use crate::{DefaultLights, Material, Scene};
use build::Builder;
use error::{Problem, Source};
use explain::{Paths, explain, refuse_single_tables, with_comma};
use tables::appearance::materials::MaterialTable;
use tables::scene::SceneTable;

/// The most bytes that a scene file may have.
pub const MAX_BYTES: u64 = 16 << 20;

/// How a scene file is read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LoadOptions {
    /// Whether files outside of the scene file's folder are read.
    pub allow_outside: bool,
    /// Values to set before the file is understood: paths such as `materials.ball.shininess` or
    /// `lights.0.color`, and TOML. What is not TOML is taken as a string.
    pub sets: Vec<(String, String)>,
    /// The lights of a model, in place of its own; without them one that has none gets three lights. A scene file says its own.
    pub lights: Option<DefaultLights>,
    /// The variant of a glTF model whose materials are taken, in place of its own. A scene file says it of each object.
    pub variant: Option<String>,
    /// What textures, environments and triangles may take of memory, by what is drawn of them.
    pub memory: MemoryBudget,
}

/// What a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// What was ignored or approximated, in words for people.
    pub notes: Vec<String>,
}

/// Reads a scene file.
pub fn load(path: &Path, options: &LoadOptions) -> Result<Loaded, FileError> {
    let text = read_text(path).map_err(|message| FileError::whole(path, message))?;
    parse(path, &text, path.parent().unwrap_or(Path::new("")), options)
}

/// Reads a scene from a text. Files that it names are relative to `base`.
pub fn parse_str(text: &str, base: &Path, options: &LoadOptions) -> Result<Loaded, FileError> {
    parse(Path::new("scene"), text, base, options)
}

/// The material that the keys of a table `[materials.NAME]` mean: everything but its textures, which need a scene.
pub fn parse_material(name: &str, text: &str) -> Result<Material, FileError> {
    let source = Source::new(Path::new(name), text);
    let understand = || {
        let root = read_document(text, &[])?;
        let table = MaterialTable::deserialize(toml::de::Deserializer::from(root)).map_err(|error| {
            explain(&error, read_document(text, &[]).ok().as_ref().map(Paths::of).as_ref())
        })?;
        table.build(name, &mut Builder::new(Path::new(""), false, MemoryBudget::default()))
    };
    understand().map_err(|problem| source.error(problem))
}

fn read_text(path: &Path) -> Result<String, String> {
    use std::io::Read;
    let cannot = |error: std::io::Error| format!("the scene file cannot be read: {error}");
    // Asked before opening, since opening a pipe waits for its other end.
    let length = std::fs::metadata(path).map_err(cannot)?.len();
    let too_long = |found| format!("expected a scene file of at most {MAX_BYTES} bytes, found {found}");
    if length > MAX_BYTES {
        return Err(too_long(length.to_string()));
    }
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(cannot)?;
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(too_long("more".to_owned()));
    }
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        format!("expected UTF-8 text, found byte {byte} that is not")
    })
}

fn parse(path: &Path, text: &str, base: &Path, options: &LoadOptions) -> Result<Loaded, FileError> {
    let mut source = Source::new(path, text);
    check_length(path, text)?;
    let sets = sets::collect(&mut source, &options.sets);
    let result = sets.and_then(|sets| understand(text, &sets, base, options));
    result.map_err(|problem| source.error(problem))
}

fn check_length(path: &Path, text: &str) -> Result<(), FileError> {
    if text.len() as u64 > MAX_BYTES {
        let message = format!("expected a scene of at most {MAX_BYTES} bytes, found {}", text.len());
        return Err(FileError::whole(path, message));
    }
    Ok(())
}

/// The document with its overrides, not yet understood.
fn read_document<'i>(text: &'i str, sets: &'i [sets::Override]) -> Result<Spanned<DeTable<'i>>, Problem> {
    let mut root = DeTable::parse(text).map_err(|error| with_comma(explain(&error, None), text))?;
    for set in sets {
        set.apply(root.get_mut())?;
    }
    Ok(root)
}

/// That a text is a scene file as far as can be told without the files that it names.
fn check_text(text: &str) -> Result<(), FileError> {
    check_length(Path::new("scene"), text)?;
    let source = Source::new(Path::new("scene"), text);
    read_table(text, &[]).map(drop).map_err(|problem| source.error(problem))
}

fn read_table(text: &str, sets: &[sets::Override]) -> Result<SceneTable, Problem> {
    let root = read_document(text, sets)?;
    refuse_single_tables(root.get_ref())?;
    SceneTable::deserialize(toml::de::Deserializer::from(root))
        .map_err(|error| explain(&error, read_document(text, sets).ok().as_ref().map(Paths::of).as_ref()))
}

fn understand(
    text: &str,
    sets: &[sets::Override],
    base: &Path,
    options: &LoadOptions,
) -> Result<Loaded, Problem> {
    let table = read_table(text, sets)?;
    let mut builder = Builder::new(base, options.allow_outside, options.memory);
    builder.build(&table)?;
    Ok(Loaded { scene: builder.scene, notes: builder.input.notes })
}
