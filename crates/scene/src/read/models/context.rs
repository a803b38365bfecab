//! What the readers of models share.

use glanz_color::read::{Place, ReadError};
use glanz_math::MemoryBudget;

use crate::Texture;
use crate::read::notes::Notes;
use crate::read::{ReadOptions, ResolveError, Resolver, jpeg, texture};

/// What all readers share while they read one file.
pub(super) struct Context<'a> {
    /// The file's name, for messages.
    pub(super) file: &'a str,
    pub(super) options: &'a ReadOptions,
    pub(super) resolver: &'a dyn Resolver,
    pub(super) notes: Notes,
}

impl Context<'_> {
    /// The bytes of the first of these references that is there, or of a file of the last one's name beside the model.
    /// `None` with a remark, which `place` is the place of, where there is none.
    pub(super) fn find_picture(&mut self, references: &[String], place: &Place) -> Option<Vec<u8>> {
        let reference = references.last()?;
        let mut why = "is missing".to_owned();
        for reference in references {
            match self.resolver.read(reference) {
                Ok(bytes) => return Some(bytes),
                Err(ResolveError::Missing) => {}
                Err(error) => why = reason(error),
            }
        }
        let name = reference.rsplit(['/', '\\']).next().unwrap_or(reference);
        let beside =
            (name != *reference && !name.is_empty()).then(|| self.resolver.read(name).ok()).flatten();
        let what = match &beside {
            Some(_) => format!("the picture '{reference}' {why}: '{name}' beside the model is taken"),
            None => format!("the picture '{reference}' {why}: it is left out"),
        };
        self.notes.add_at(&what, place.clone());
        beside
    }

    /// The picture of these bytes, or `None` with a remark where they are none that can be read.
    ///
    /// # Errors
    /// If the picture takes more memory than is left.
    pub(super) fn decode_picture(
        &mut self,
        bytes: &[u8],
        name: &str,
        place: &Place,
        memory: &mut MemoryBudget,
    ) -> Result<Option<Texture>, ReadError> {
        let why = match texture::decode(bytes, name, place.clone(), self.options, memory) {
            Ok(texture) => {
                if jpeg::is_cut(bytes) {
                    self.notes.add_at(&format!("the picture '{name}' {}", jpeg::CUT), place.clone());
                }
                return Ok(Some(texture));
            }
            Err(error @ (ReadError::TooLarge { .. } | ReadError::Memory { .. })) => return Err(error),
            Err(ReadError::Unsupported { .. }) if is_lfs_pointer(bytes) => format!("is {LFS_POINTER}"),
            Err(ReadError::Unsupported { expected, found, .. }) => {
                format!("is not {expected}, but begins with {found}")
            }
            Err(ReadError::Malformed { found, .. }) => format!("cannot be decoded ({found})"),
            Err(error) => format!("cannot be read ({error})"),
        };
        self.notes.add_at(&format!("the picture '{name}' {why}: it is left out"), place.clone());
        Ok(None)
    }
}

/// What a file is that Git LFS keeps elsewhere.
pub(super) const LFS_POINTER: &str = "the pointer of Git LFS to a file that was not fetched (git lfs pull)";

/// Whether the bytes are what Git LFS puts in the place of a file.
pub(super) fn is_lfs_pointer(bytes: &[u8]) -> bool {
    bytes.starts_with(b"version https://git-lfs.github.com/spec/")
}

/// Why a file that another one names is not there.
pub(super) fn reason(error: ResolveError) -> String {
    match error {
        ResolveError::Missing => "is missing".to_owned(),
        ResolveError::Outside(root) => {
            format!("lies outside of the folder '{root}', which --allow-outside permits")
        }
        ResolveError::TooLarge { limit, found } => format!("has {found} bytes, more than {limit}"),
        ResolveError::Io(error) => format!("cannot be read ({error})"),
    }
}
