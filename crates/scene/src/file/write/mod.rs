//! From a scene to a scene file that loads back as the same scene.
//!
//! What people write by hand is written as they would: materials by name, the classic block where it fits, defaults
//! left out. What has no such form is written by its numbers, exactly. Large meshes, textures and environment maps
//! go into files beside the scene, whose names hold a number for their content: saving again never changes a file
//! that an older scene file still names.
//!
//! Not kept is what a light's kind ignores, such as the direction of a sphere.

mod color;
mod eye;
mod light;
mod lobe;
mod material;
mod mesh;
mod names;
mod object;
mod program;
mod settings;
mod side_files;
mod text;

use std::path::Path;

use glanz_picture::output::{OutputError, write_atomically};
use thiserror::Error;

use super::{FileError, check_text};
use crate::{MeshError, Scene, UniformValue};
use names::Names;
use side_files::SideFiles;
use text::Document;

/// A scene file and the files beside it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// The scene file.
    pub text: String,
    /// Names, relative to the scene file, and bytes of the files that it names.
    pub files: Vec<(String, Vec<u8>)>,
}

/// Why a scene cannot be written.
#[derive(Debug, Error)]
pub enum WriteError {
    /// An index leads nowhere.
    #[error("{what} {index}: there are only {count}")]
    Index {
        /// What is numbered.
        what: &'static str,
        /// The index.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A mesh is not as [`crate::Mesh`] promises.
    #[error("mesh {index}: {source}")]
    Mesh {
        /// Its number.
        index: usize,
        /// What is wrong.
        source: MeshError,
    },
    /// Something that has no meaning, so that no key says it.
    #[error("{place}: {what} cannot be written")]
    NoKey {
        /// Where.
        place: String,
        /// What it is.
        what: &'static str,
    },
    /// A picture cannot be encoded.
    #[error("{place}: {message}")]
    Picture {
        /// Which.
        place: String,
        /// What is wrong.
        message: String,
    },
    /// A value is out of the range of its key.
    #[error("a value is out of the range of scene files: {0}")]
    Range(FileError),
    /// A file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The folder for the files beside the scene cannot be made.
    #[error("{path}: cannot make the folder: {source}")]
    Folder {
        /// The folder.
        path: String,
        /// What failed.
        source: std::io::Error,
    },
}

/// The scene file of a scene. The files that it names are in `folder`, relative to the scene file.
///
/// # Errors
/// Where the scene holds an index that leads nowhere, a broken mesh, or a value that no scene file can hold.
pub fn write(scene: &Scene, folder: &str) -> Result<Written, WriteError> {
    check(scene)?;
    let mut document = Document::default();
    let mut files = SideFiles::new(folder);
    let names = Names::of(scene);
    let programs: Vec<_> = scene.programs.iter().map(|own| program::value(own, &names, &mut files)).collect();
    if let Some(own) = scene.program {
        document.line(&format!("program = {}", programs[own]));
    }
    settings::write(scene, &mut document);
    for light in &scene.lights {
        light::write(light, &mut document, &mut files)?;
    }
    for (texture, key) in scene.textures.iter().zip(&names.textures) {
        mesh::write_texture(texture, key, &mut document, &mut files)?;
    }
    for (mesh, key) in scene.meshes.iter().zip(&names.meshes) {
        mesh::write(mesh, key, &mut document, &mut files);
    }
    for (material, key) in scene.materials.iter().zip(&names.materials) {
        material::write(material, key, &names, &mut document, &mut files)?;
    }
    for object in &scene.objects {
        object::write(object, &names, &programs, &mut document);
    }
    let text = document.finish();
    check_text(&text).map_err(WriteError::Range)?;
    Ok(Written { text, files: files.finish() })
}

/// Writes a scene file, and the files that it names into a folder beside it. Each file appears whole or not at all,
/// the scene file last.
///
/// # Errors
/// As [`write()`], and where a file cannot be written.
pub fn save(path: &Path, scene: &Scene) -> Result<(), WriteError> {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_".contains(c) { c } else { '_' };
    let folder = format!("{}-data", stem.chars().map(plain).collect::<String>());
    let written = write(scene, &folder)?;
    let base = path.parent().unwrap_or(Path::new(""));
    for (name, bytes) in &written.files {
        let path = base.join(name);
        if let Some(folder) = path.parent() {
            make_folder(folder)?;
        }
        put(&path, bytes)?;
    }
    put(path, written.text.as_bytes())
}

fn make_folder(folder: &Path) -> Result<(), WriteError> {
    std::fs::create_dir_all(folder)
        .map_err(|source| WriteError::Folder { path: folder.display().to_string(), source })
}

fn put(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    write_atomically(path, |out| {
        std::io::Write::write_all(out, bytes).map_err(|source| OutputError::File {
            path: path.to_owned(),
            action: "write it",
            source,
        })
    })
    .map_err(WriteError::Output)
}

/// That every index leads somewhere and every mesh is whole.
fn check(scene: &Scene) -> Result<(), WriteError> {
    let within = |what, index, count| {
        if index < count { Ok(()) } else { Err(WriteError::Index { what, index, count }) }
    };
    for (index, mesh) in scene.meshes.iter().enumerate() {
        mesh.validate().map_err(|source| WriteError::Mesh { index, source })?;
    }
    for material in &scene.materials {
        for map in material.textures() {
            within("texture", map.texture, scene.textures.len())?;
        }
    }
    let values = scene.programs.iter().flat_map(|program| program.uniforms.values());
    for texture in values.flat_map(UniformValue::textures) {
        within("texture", *texture, scene.textures.len())?;
    }
    for program in scene.objects.iter().map(|object| object.program).chain([scene.program]).flatten() {
        within("program", program, scene.programs.len())?;
    }
    for object in &scene.objects {
        within("mesh", object.mesh, scene.meshes.len())?;
        within("material", object.material, scene.materials.len())?;
    }
    Ok(())
}
