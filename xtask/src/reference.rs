//! Whether `docs/SCENE.md` names everything that a scene file can say.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// Compares the page with the schema that `glanz schema` prints.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let glanz = workspace.glanz(Profile::Dev)?;
    let schema = run_quietly(workspace.command(glanz).arg("schema"))?;
    let schema: Value = serde_json::from_slice(&schema).map_err(Failure::during("glanz schema"))?;
    let page = workspace.path("docs/SCENE.md");
    let text = std::fs::read_to_string(&page).map_err(Failure::during(page.display()))?;
    let words = words(&schema);
    let missing = missing(&words, &text);
    match missing.is_empty() {
        true => {
            println!("docs/SCENE.md names all {} keys and names of the schema", words.len());
            Ok(())
        }
        false => Err(Failure::new(format!("docs/SCENE.md does not name {}", missing.join(", ")))),
    }
}

/// All keys of objects and all strings that a value may be.
fn words(schema: &Value) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    collect(schema, &mut words);
    words
}

fn collect(schema: &Value, words: &mut BTreeSet<String>) {
    match schema {
        Value::Array(list) => list.iter().for_each(|value| collect(value, words)),
        Value::Object(object) => {
            for (key, value) in object {
                match (key.as_str(), value) {
                    ("properties", Value::Object(properties)) => {
                        words.extend(properties.keys().cloned());
                        properties.values().for_each(|value| collect(value, words));
                    }
                    ("const", Value::String(name)) => {
                        words.insert(name.clone());
                    }
                    ("enum", Value::Array(names)) => {
                        words.extend(names.iter().filter_map(|name| Some(name.as_str()?.to_owned())));
                    }
                    (_, value) => collect(value, words),
                }
            }
        }
        _ => {}
    }
}

/// Those that the page does not show as code, in quotes, in brackets, or within a path.
fn missing(words: &BTreeSet<String>, page: &str) -> Vec<String> {
    let shown: BTreeSet<&str> = page
        .split('`')
        .skip(1)
        .step_by(2)
        .flat_map(|code| code.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '-')))
        .collect();
    words.iter().filter(|word| !shown.contains(word.as_str())).map(|word| format!("'{word}'")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_and_every_name_counts() {
        let schema = serde_json::json!({
            "properties": { "shading": { "enum": ["flat", "phong"] }, "lights": { "items": { "$ref": "#/$defs/Light" } } },
            "$defs": { "Light": { "properties": { "kind": { "oneOf": [{ "const": "point" }] } } } },
        });
        let words = words(&schema);
        assert_eq!(
            words.iter().map(String::as_str).collect::<Vec<_>>(),
            ["flat", "kind", "lights", "phong", "point", "shading"]
        );
        let page = "`[[lights]]` have a `kind`, `\"point\"`; `shading` is `\"flat\"`; phong is only a word";
        assert_eq!(missing(&words, page), ["'phong'"]);
    }
}
