//! `glanz material list`.

use std::fmt::Write;

use clap::Args;
use glanz_scene::library::{Category, MaterialInfo, materials};
use schemars::JsonSchema;
use serde::Serialize;

use super::categories::categories;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz material list
  glanz material list --category metal --format json";

/// Options of `glanz material list`.
#[derive(Args, Debug)]
pub(crate) struct ListArgs {
    /// Only materials of this category; may be repeated
    #[arg(long, value_name = "CATEGORY", value_parser = categories())]
    category: Vec<Category>,

    #[command(flatten)]
    format: FormatArgs,
}

impl ListArgs {
    /// Prints the list.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let listed: Vec<&'static MaterialInfo> = materials().iter().filter(|info| self.lists(info)).collect();
        match self.format.is_json() {
            true => print::json(&Document { materials: listed.into_iter().map(MaterialFacts::of).collect() }),
            false => print::text(&table(&listed)),
        }
    }

    fn lists(&self, info: &MaterialInfo) -> bool {
        self.category.is_empty() || self.category.contains(&info.category)
    }
}

/// Materials of the library.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    materials: Vec<MaterialFacts>,
}

/// What is known of a material.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MaterialFacts {
    name: &'static str,
    title: &'static str,
    category: &'static str,
    source: &'static str,
}

impl MaterialFacts {
    /// That of this material.
    pub(crate) fn of(info: &'static MaterialInfo) -> Self {
        let MaterialInfo { name, title, category, source, .. } = info;
        Self { name, title, category: category.name(), source }
    }
}

fn table(listed: &[&MaterialInfo]) -> String {
    let widest = |of: fn(&MaterialInfo) -> &str, heading: &str| {
        let widths = listed.iter().map(|info| of(info).chars().count());
        widths.max().unwrap_or(0).max(heading.len())
    };
    let name = widest(|info| &info.name, "name");
    let category = widest(|info| info.category.name(), "category");
    let mut text = format!("{:<name$}  {:<category$}  title\n", "name", "category");
    for info in listed {
        writeln!(text, "{:<name$}  {:<category$}  {}", info.name, info.category.name(), info.title)
            .expect("a string takes everything");
    }
    text
}
