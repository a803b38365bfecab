//! Files that a scene names.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::values::At;
use crate::read::{FolderFiles, ResolveError, Resolver, resolve};

impl Builder {
    /// The folder that references are relative to.
    pub(super) fn base(&self) -> &Path {
        &self.input.base
    }

    /// The file that the scene names, if it may be read.
    pub(super) fn resolve(&self, reference: &str, span: &Range<usize>) -> Result<PathBuf, Problem> {
        resolve(&self.input.base, reference, &self.input.options)
            .map_err(|error| unresolved(reference, &error, span))
    }

    /// Adds a file's bytes to the hash, once. A file that cannot be read is left out: its reader will
    /// say so.
    pub(super) fn hash_file(&mut self, path: &Path) {
        let regular = std::fs::metadata(path).is_ok_and(|metadata| metadata.is_file());
        if !regular || !self.input.hashed.insert(path.to_owned()) {
            return;
        }
        let Ok(mut file) = std::fs::File::open(path) else { return };
        let mut buffer = vec![0; 1 << 16];
        while let Ok(length) = std::io::Read::read(&mut file, &mut buffer) {
            if length == 0 {
                break;
            }
            self.input.hash.bytes(&buffer[..length]);
        }
    }
}

pub(super) fn unresolved(reference: &str, error: &ResolveError, span: &Range<usize>) -> Problem {
    match error {
        ResolveError::Outside(_) => {
            Problem::at(span, format!("'{reference}' leaves the folder of the scene file"))
                .help("files elsewhere are read only where that is allowed explicitly")
        }
        ResolveError::Missing => Problem::at(span, format!("there is no file '{reference}'"))
            .help("file names are relative to the scene file"),
        ResolveError::TooLarge { limit, found } => {
            Problem::at(span, format!("'{reference}' has {found} bytes; at most {limit} are read"))
        }
        ResolveError::Io(error) => Problem::at(span, format!("'{reference}' cannot be read: {error}")),
    }
}

impl Builder {
    /// The bytes of a file that the scene names; they count for the scene's hash.
    pub(super) fn read_beside(&mut self, file: &At<String>) -> Result<Vec<u8>, Problem> {
        let bytes = FolderFiles::new(self.base(), &self.input.options)
            .read(file)
            .map_err(|error| unresolved(file, &error, &file.span))?;
        self.input.hash.bytes(&bytes);
        Ok(bytes)
    }
}
