//! What the readers of models share.

use crate::read::notes::Notes;
use crate::read::{ReadOptions, Resolver};

/// What all readers share while they read one file.
pub(super) struct Context<'a> {
    /// The file's name, for messages.
    pub(super) file: &'a str,
    pub(super) options: &'a ReadOptions,
    pub(super) resolver: &'a dyn Resolver,
    pub(super) notes: Notes,
}
