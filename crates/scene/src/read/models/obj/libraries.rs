//! The MTL files that an OBJ file names.

use std::collections::HashMap;

use glanz_color::read::{Place, ReadError};

use super::super::context::{Context, reason};
use super::super::lines::{rest, without_comment};
use super::mtl::Library;
use crate::{Material, Texture};

/// The most MTL files that one OBJ file may name.
const MAX_LIBRARIES: usize = 1024;

/// The files, each read once, and the materials of all of them.
#[derive(Default)]
pub(super) struct Libraries {
    library: Library,
    /// Why the file of a name cannot be read, if so.
    known: HashMap<String, Option<String>>,
}

impl Libraries {
    /// Reads the files that a line names: one name with spaces in it, or several.
    pub(super) fn read(
        &mut self,
        line: &[u8],
        place: Place,
        context: &mut Context<'_>,
    ) -> Result<(), ReadError> {
        let whole = rest(line);
        let name = without_comment(&whole).unwrap_or(&whole);
        for name in [&whole, name] {
            if name.is_empty() || self.read_file(name, &place, context)?.is_none() {
                return Ok(());
            }
        }
        for name in name.split_ascii_whitespace() {
            if let Some(why) = self.read_file(name, &place, context)? {
                let note = format!("the material file '{name}' {why}");
                context.notes.add_at(&note, place.clone());
            }
        }
        Ok(())
    }

    /// Reads a file, once, or says why it cannot be read.
    fn read_file(
        &mut self,
        name: &str,
        place: &Place,
        context: &mut Context<'_>,
    ) -> Result<Option<String>, ReadError> {
        if let Some(found) = self.known.get(name) {
            return Ok(found.clone());
        }
        if self.known.len() >= MAX_LIBRARIES {
            let (file, limit, found) =
                (context.file.to_owned(), MAX_LIBRARIES as u64, self.known.len() as u64 + 1);
            return Err(ReadError::TooLarge {
                file,
                place: place.clone(),
                limit,
                unit: "material files",
                found,
            });
        }
        let why = match context.resolver.read(name) {
            Ok(bytes) => self.library.read(&bytes, name, context).map(|()| None)?,
            Err(error) => Some(reason(error)),
        };
        self.known.insert(name.to_owned(), why.clone());
        Ok(why)
    }

    /// The materials of these names, the default one for `None`, and their textures.
    pub(super) fn build(
        self,
        names: &[Option<String>],
        context: &mut Context<'_>,
    ) -> Result<(Vec<Material>, Vec<Texture>), ReadError> {
        self.library.build(names, context)
    }
}
