//! Materials by name, each with its source.
//!
//! A material of the library is written in the words of a scene file, so that what `glanz material show` prints,
//! put into a scene, is the same material; [`MaterialInfo::toml`] holds the keys, [`material`] reads them.
//!
//! Figures are those of papers and tables where there are some; others are chosen, and the source says so.
//!
//! ```
//! use glanz_scene::library;
//!
//! let gold = library::info("gold")?;
//! println!("{}: {}", gold.title, gold.source);
//! assert_eq!(gold.material(), library::material("gold")?);
//! assert!(library::material("gould").unwrap_err().to_string().contains("did you mean 'gold'"));
//! # Ok::<(), library::UnknownMaterial>(())
//! ```

mod categories;
mod category;
mod entry;
mod info;

#[cfg(test)]
mod tests;

use std::sync::LazyLock;

use thiserror::Error;

pub use category::Category;
pub use info::MaterialInfo;

use crate::Material;
use crate::file::near::did_you_mean;

/// No material of the library goes by that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no material '{name}' in the library{}", did_you_mean(name, names()))]
pub struct UnknownMaterial {
    /// The name as given.
    pub name: String,
}

/// All materials of the library, by categories.
pub fn materials() -> &'static [MaterialInfo] {
    static LIST: LazyLock<Vec<MaterialInfo>> = LazyLock::new(categories::infos);
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
