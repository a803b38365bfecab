//! `glanz material show`.

use clap::Args;
use glanz_scene::library::{self, MaterialInfo};
use schemars::JsonSchema;
use serde::Serialize;

use super::list::MaterialFacts;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz material show gold
  glanz material show car-paint-red >> scene.toml

What is printed is the table of the material in a scene file. There, library = \"NAME\" in a table, or material = \"NAME\"
in an object, is short for it.";

/// Options of `glanz material show`.
#[derive(Args, Debug)]
pub(crate) struct ShowArgs {
    /// The material's name, from `glanz material list`
    #[arg(value_name = "NAME")]
    name: String,

    #[command(flatten)]
    format: FormatArgs,
}

impl ShowArgs {
    /// Prints the material.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let info = library::info(&self.name).map_err(|error| Failure::Usage(error.to_string()))?;
        if !self.format.is_json() {
            return print::text(&snippet(info));
        }
        print::json(&Document { material: MaterialFacts::of(info), toml: &info.toml })
    }
}

/// A material of the library.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    #[serde(flatten)]
    material: MaterialFacts,
    /// The table of the material in a scene file
    toml: &'static str,
}

/// The table of the material, with what is known of it as comments.
fn snippet(info: &MaterialInfo) -> String {
    let MaterialInfo { name, title, category, source, toml } = info;
    format!("# {title}\n# category: {}\n# source: {source}\n[materials.{name}]\n{toml}", category.name())
}
