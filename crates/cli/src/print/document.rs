//! Documents for programs: JSON objects with a version, and their schemas.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// The version of all documents. It grows when a key goes or changes its meaning, not when one is added.
const VERSION: u32 = 1;

/// The document as JSON, with its version.
pub(crate) fn versioned(document: &impl Serialize) -> Value {
    let value = serde_json::to_value(document).expect("documents have string keys and no failing parts");
    let Value::Object(keys) = value else { unreachable!("a document is an object: {value}") };
    Value::Object(Map::from_iter([("version".to_owned(), json!(VERSION))]).into_iter().chain(keys).collect())
}

/// The JSON Schema (draft 2020-12) of a document, from the type that it is made of.
pub(crate) fn schema<T: JsonSchema>() -> Value {
    // What is printed, not what could be read: a key that is always written is required.
    let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let mut schema: Schema = generator.into_root_schema_for::<T>();
    let version = json!({ "description": "The version of the document", "const": VERSION });
    let keys = schema.ensure_object();
    let entry = |keys: &mut Map<String, Value>, key: &str, empty: Value| {
        keys.entry(key).or_insert(empty);
    };
    entry(keys, "properties", json!({}));
    entry(keys, "required", json!([]));
    if let Some(properties) = keys["properties"].as_object_mut() {
        properties.insert("version".to_owned(), version);
    }
    if let Some(required) = keys["required"].as_array_mut() {
        required.insert(0, json!("version"));
    }
    schema.to_value()
}
