//! What is known about a material.

use super::Category;
use crate::Material;

/// What is known about a material of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialInfo {
    /// The name as [`material`](super::material()) and scene files know it: small letters, figures and hyphens.
    pub name: String,
    /// What it is, in a few words.
    pub title: String,
    /// What kind of thing it is.
    pub category: Category,
    /// Where its figures come from.
    pub source: String,
    /// The keys of its table `[materials.NAME]` in a scene file, in TOML.
    pub toml: String,
}

impl MaterialInfo {
    /// The material.
    pub fn material(&self) -> Material {
        crate::file::parse_material(&self.name, &self.toml)
            .expect("a test reads every material of the library")
    }
}
