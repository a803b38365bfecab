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
}

pub(super) fn unresolved(reference: &str, error: &ResolveError, span: &Range<usize>) -> Problem {
    match error {
        ResolveError::Outside(_) => {
            Problem::at(span, format!("'{reference}' leaves the folder of the scene file"))
                .help("files elsewhere are read only where that is allowed: by the option --allow-outside, in a program by LoadOptions::allow_outside")
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
    /// The bytes of a file that the scene names.
    pub(super) fn read_beside(&mut self, file: &At<String>) -> Result<Vec<u8>, Problem> {
        FolderFiles::new(self.base(), &self.input.options)
            .read(file)
            .map_err(|error| unresolved(file, &error, &file.span))
    }
}
