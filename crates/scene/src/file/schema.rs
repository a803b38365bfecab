//! The JSON Schema of scene files.

use schemars::generate::SchemaSettings;

use super::tables::scene::SceneTable;

/// The JSON Schema (draft 2020-12) of scene files, from the types that read them.
pub fn schema() -> serde_json::Value {
    let generator = SchemaSettings::draft2020_12().into_generator();
    generator.into_root_schema_for::<SceneTable>().to_value()
}
