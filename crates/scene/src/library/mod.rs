//! Materials by name, each with its source.
//!
//! A material of the library is written in the words of a scene file, so that what `glanz material show` prints,
//! put into a scene, is the same material; [`MaterialInfo::toml`] holds the keys, [`material`] reads them.
//!
//! Figures are those of papers and tables where there are some; others are chosen, and the source says so.

mod category;
mod cloth;
mod entry;
mod films;
mod glass;
mod metals;
mod minerals;
mod ngan;
mod opengl;
mod paints;
mod paper;
mod plants;
mod plastics;
mod ward;
mod wood;

#[cfg(test)]
mod tests;

use std::sync::LazyLock;

use thiserror::Error;

pub use category::Category;

use crate::Material;
use crate::file::near::did_you_mean;

/// What is known about a material of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialInfo {
    /// The name as [`material`] and scene files know it: small letters, figures and hyphens.
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

/// No material of the library goes by that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no material '{name}' in the library{}", did_you_mean(name, names()))]
pub struct UnknownMaterial {
    /// The name as given.
    pub name: String,
}

impl MaterialInfo {
    /// The material.
    pub fn material(&self) -> Material {
        crate::file::parse_material(&self.name, &self.toml)
            .expect("a test reads every material of the library")
    }
}

/// All materials of the library, by categories.
pub fn materials() -> &'static [MaterialInfo] {
    static LIST: LazyLock<Vec<MaterialInfo>> = LazyLock::new(|| {
        let parts = [
            metals::infos(),
            films::infos(),
            paints::infos(),
            plastics::infos(),
            cloth::infos(),
            paper::infos(),
            plants::infos(),
            wood::infos(),
            minerals::infos(),
            glass::infos(),
            ward::infos(),
            ngan::infos(),
            opengl::infos(),
        ];
        parts.into_iter().flatten().collect()
    });
    &LIST
}

/// What is known about the material of that name; [`materials`] lists all.
///
/// # Errors
///
/// [`UnknownMaterial`] suggests a near name.
pub fn info(name: &str) -> Result<&'static MaterialInfo, UnknownMaterial> {
    materials().iter().find(|info| info.name == name).ok_or_else(|| UnknownMaterial { name: name.to_owned() })
}

/// The material of that name; [`materials`] lists all.
///
/// # Errors
///
/// [`UnknownMaterial`] suggests a near name.
pub fn material(name: &str) -> Result<Material, UnknownMaterial> {
    info(name).map(MaterialInfo::material)
}

/// The names of all materials.
pub fn names() -> impl Iterator<Item = &'static str> {
    materials().iter().map(|info| info.name.as_str())
}
