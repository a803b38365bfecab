//! Readers of the formats of others: glTF 2.0 (`.gltf`, `.glb`), Wavefront OBJ with MTL, PLY, STL.
//!
//! Every reader is total: whatever the bytes are, it returns a [`Model`] or one [`ReadError`] that
//! names the file, the place and what was expected there. It never allocates by what a file claims,
//! only by what it holds, and it follows references only inside the folder of [`ReadOptions::root`].
//!
//! Beside models there are textures, sensors, the profiles of luminaires (LM-63, EULUMDAT) and pictures of
//! environments (Radiance HDR, OpenEXR), each with a function of its own.
//!
//! What a reader left out or could only approximate is told in [`Model::notes`].

mod environment;
mod error;
mod faces;
mod finish;
mod gltf;
mod lines;
mod model;
mod notes;
mod obj;
mod options;
mod ply;
mod profile;
mod resolve;
mod sensor;
mod stl;
mod texture;

use std::io::{BufRead, BufReader, Read};
use std::path::Path;

pub use environment::read_environment;
pub use error::{Place, ReadError};
pub use model::Model;
pub use options::ReadOptions;
pub use profile::{MAX_PROFILE_BYTES, read_profile};
pub use resolve::{FolderFiles, NoFiles, ResolveError, Resolver, resolve};
pub use sensor::read_sensor;
pub use texture::read_texture;

use notes::Notes;

/// A file format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// glTF 2.0, as JSON or in one binary file.
    Gltf,
    /// Wavefront OBJ, with MTL.
    Obj,
    /// The Stanford polygon format, as text or binary.
    Ply,
    /// Stereolithography triangles, as text or binary.
    Stl,
}

impl Format {
    /// The file name endings that are known, for messages.
    pub const EXTENSIONS: &'static str = ".glb, .gltf, .obj, .ply or .stl";

    /// The format of a file of this name that begins with these bytes: unmistakable first bytes
    /// count more than the name, the name more than other first bytes.
    pub fn detect(path: &Path, head: &[u8]) -> Option<Self> {
        if head.starts_with(b"glTF") {
            return Some(Self::Gltf);
        }
        if head.starts_with(b"ply\n") || head.starts_with(b"ply\r") {
            return Some(Self::Ply);
        }
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("gltf" | "glb") => Some(Self::Gltf),
            Some("obj") => Some(Self::Obj),
            Some("ply") => Some(Self::Ply),
            Some("stl") => Some(Self::Stl),
            _ if head.trim_ascii_start().starts_with(b"{") => Some(Self::Gltf),
            _ if head.starts_with(b"solid") => Some(Self::Stl),
            _ => None,
        }
    }
}

/// What all readers share while they read one file.
struct Context<'a> {
    /// The file's name, for messages.
    file: &'a str,
    options: &'a ReadOptions,
    resolver: &'a dyn Resolver,
    notes: Notes,
}

/// Reads a model from a file of any known format.
///
/// Where `options.root` is set, `path` itself must lie in it, too.
pub fn read_model(path: &Path, options: &ReadOptions) -> Result<Model, ReadError> {
    let file = path.display().to_string();
    let at_file = |error: ResolveError| error.at(&file, Place::File, &file);
    if options.root.is_some() {
        resolve(Path::new(""), &file_reference(path), options).map_err(at_file)?;
    }
    let (handle, len) = resolve::open(path, options.max_bytes).map_err(at_file)?;
    // The file may grow while it is read: the limit holds all the same.
    let mut reader = BufReader::with_capacity(1 << 18, handle.take(options.max_bytes));
    let head = reader.fill_buf().map_err(|source| at_file(ResolveError::Io(source)))?;
    let format = Format::detect(path, head).ok_or_else(|| {
        ReadError::unsupported(
            &file,
            Place::File,
            format!("a model whose name ends in {}", Format::EXTENSIONS),
            error::excerpt(&head[..head.len().min(16)]),
        )
    })?;
    let resolver = FolderFiles::new(path.parent().unwrap_or(Path::new("")), options);
    read_stream(reader, len, format, &file, &resolver, options)
}

/// The path as a reference, with an absolute one kept.
fn file_reference(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// Reads a model from bytes in memory. `name` is the file's name in messages; `resolver` knows the
/// files that it refers to.
pub fn read_model_bytes(
    bytes: &[u8],
    format: Format,
    name: &str,
    resolver: &dyn Resolver,
    options: &ReadOptions,
) -> Result<Model, ReadError> {
    read_stream(bytes, bytes.len() as u64, format, name, resolver, options)
}

/// Reads a model from a stream of `len` bytes.
fn read_stream(
    mut reader: impl BufRead,
    len: u64,
    format: Format,
    file: &str,
    resolver: &dyn Resolver,
    options: &ReadOptions,
) -> Result<Model, ReadError> {
    let mut context = Context { file, options, resolver, notes: Notes::default() };
    let model = match format {
        Format::Gltf => {
            let mut bytes = Vec::new();
            let read = match bytes.try_reserve_exact(len as usize) {
                Ok(()) => reader.read_to_end(&mut bytes),
                Err(error) => Err(std::io::Error::new(std::io::ErrorKind::OutOfMemory, error)),
            };
            read.map_err(|source| ReadError::Io { file: file.to_owned(), place: Place::File, source })?;
            gltf::read(&bytes, &mut context)?
        }
        Format::Obj => obj::read(reader, &mut context)?,
        Format::Ply => ply::read(reader, len, &mut context)?,
        Format::Stl => stl::read(reader, len, &mut context)?,
    };
    Ok(Model { notes: context.notes.into_strings(), ..model })
}

#[cfg(test)]
mod tests;
