//! `KHR_materials_variants`: other materials for the same primitives, one of which is drawn.

use glanz_color::read::{Place, ReadError, excerpt};
use serde::Deserialize;

use super::json::Root;
use crate::read::models::context::Context;

/// The variants of a file.
#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Variants {
    pub variants: Vec<Variant>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Variant {
    pub name: String,
}

/// Which material a primitive has in which variant.
#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Mappings {
    pub mappings: Vec<Mapping>,
}

#[derive(Deserialize)]
pub(super) struct Mapping {
    pub material: usize,
    #[serde(default)]
    pub variants: Vec<usize>,
}

/// The most names that are listed.
const LISTED: usize = 20;

/// Gives primitives the materials of the variant that is asked for; without one a remark names those that there are.
pub(super) fn choose(root: &mut Root, context: &mut Context<'_>) -> Result<(), ReadError> {
    let names: Vec<&str> = root.extensions.variants.variants.iter().map(|own| own.name.as_str()).collect();
    let Some(wanted) = &context.options.variant else {
        if !names.is_empty() {
            let names = list(&names);
            context.notes.add(&format!(
                "glTF: the file's own materials are drawn; it has the variants {names} ('variant', --variant)"
            ));
        }
        return Ok(());
    };
    let Some(number) = names.iter().position(|name| name == wanted) else {
        let expected = if names.is_empty() {
            "variants (KHR_materials_variants), of which the file has none".to_owned()
        } else {
            format!("one of the variants {}", list(&names))
        };
        return Err(ReadError::unsupported(context.file, Place::File, expected, excerpt(wanted)));
    };
    for primitive in root.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
        let mut mappings = primitive.extensions.variants.mappings.iter();
        if let Some(mapping) = mappings.find(|mapping| mapping.variants.contains(&number)) {
            primitive.material = Some(mapping.material);
        }
    }
    Ok(())
}

fn list(names: &[&str]) -> String {
    let mut list: Vec<String> = names.iter().copied().take(LISTED).map(excerpt).collect();
    if names.len() > LISTED {
        list.push(format!("and {} more", names.len() - LISTED));
    }
    list.join(", ")
}
