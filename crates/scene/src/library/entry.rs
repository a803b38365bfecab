//! Materials whose keys are written out.

use super::{Category, MaterialInfo};

/// Said of figures that nobody measured.
pub(super) const CHOSEN: &str = "figures chosen to look the part, not measured";

/// A material as the files of the library write it down.
pub(super) struct Entry {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub title: &'static str,
    /// Where its figures come from.
    pub source: &'static str,
    /// Its keys in a scene file.
    pub toml: &'static str,
}

/// The entries as materials of one category.
pub(super) fn infos(category: Category, entries: &[Entry]) -> Vec<MaterialInfo> {
    entries.iter().map(|entry| entry.info(category)).collect()
}

impl Entry {
    fn info(&self, category: Category) -> MaterialInfo {
        MaterialInfo {
            name: self.name.to_owned(),
            title: self.title.to_owned(),
            category,
            source: self.source.to_owned(),
            toml: format!("{}\n", self.toml.trim()),
        }
    }
}
