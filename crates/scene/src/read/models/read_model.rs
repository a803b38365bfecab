//! Models from files and bytes of any known format.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use glanz_color::read::{Place, ReadError, excerpt};

use super::context::{Context, LFS_POINTER, is_lfs_pointer};
use super::format::Format;
use super::model::Model;
use super::{gltf, obj, ply, stl};
use crate::read::notes::Notes;
use crate::read::{FolderFiles, ReadOptions, ResolveError, Resolver, resolve};

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
            excerpt(&head[..head.len().min(16)]),
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
    if let (Some(variant), false) = (&options.variant, format == Format::Gltf) {
        let expected = "glTF, which alone has variants of materials";
        return Err(ReadError::unsupported(file, Place::File, expected, excerpt(variant)));
    }
    let begin = reader.fill_buf().map_err(|source| ReadError::Io {
        file: file.to_owned(),
        place: Place::File,
        source,
    })?;
    if is_lfs_pointer(begin) {
        return Err(ReadError::malformed(file, Place::File, "a model", LFS_POINTER));
    }
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
