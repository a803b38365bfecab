//! Shaders in place of a material, and values for them.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::At;

/// Shaders of one's own. One of the two is enough: positions are then projected as always, or the vertex shader's
/// colour is shown.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProgramTable {
    /// A vertex shader: a file, relative to the scene file, in GLSL, or in WGSL if its name ends in .wgsl.
    pub vertex: Option<At<String>>,
    /// A fragment shader: such a file.
    pub fragment: Option<At<String>>,
    /// What uniforms are set to, by their names: a number, true or false, a list of numbers (a matrix column by column),
    /// or a picture: the name of a texture of the scene, or of a file. A samplerCube takes one in equirectangular projection,
    /// a list of six faces in OpenGL's order, or a pattern of their names such as "sky_*.png".
    #[serde(default)]
    pub uniforms: BTreeMap<String, At<UniformEntry>>,
}

/// What a uniform is set to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum UniformEntry {
    Numbers(Vec<f64>),
    Picture(String),
    /// Six faces.
    Cube(Box<[String; 6]>),
}

impl<'de> Deserialize<'de> for UniformEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(EntryVisitor)
    }
}

struct EntryVisitor;

impl<'de> Visitor<'de> for EntryVisitor {
    type Value = UniformEntry;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a list of numbers, true, false, the name of a picture, or those of six faces")
    }
    fn visit_bool<E: Error>(self, value: bool) -> Result<UniformEntry, E> {
        Ok(UniformEntry::Numbers(vec![f64::from(u8::from(value))]))
    }
    fn visit_i64<E: Error>(self, value: i64) -> Result<UniformEntry, E> {
        self.visit_f64(value as f64)
    }
    fn visit_u64<E: Error>(self, value: u64) -> Result<UniformEntry, E> {
        self.visit_f64(value as f64)
    }
    fn visit_f64<E: Error>(self, value: f64) -> Result<UniformEntry, E> {
        match value.is_finite() && value.abs() <= f64::from(f32::MAX) {
            true => Ok(UniformEntry::Numbers(vec![value])),
            false => Err(E::custom(format!("expected a finite number of single precision, found {value}"))),
        }
    }
    fn visit_str<E: Error>(self, name: &str) -> Result<UniformEntry, E> {
        Ok(UniformEntry::Picture(name.to_owned()))
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<UniformEntry, A::Error> {
        let (mut numbers, mut faces) = (Vec::new(), Vec::new());
        // A list of lists is a matrix or an array of vectors.
        while let Some(entry) = seq.next_element::<UniformEntry>()? {
            match entry {
                UniformEntry::Numbers(some) => numbers.extend(some),
                UniformEntry::Picture(name) if numbers.is_empty() => faces.push(name),
                UniformEntry::Picture(name) => {
                    return Err(A::Error::custom(format!("expected a number, found \"{name}\"")));
                }
                UniformEntry::Cube(_) => return Err(A::Error::custom("expected a picture, found a list")),
            }
        }
        if faces.is_empty() {
            return Ok(UniformEntry::Numbers(numbers));
        }
        if !numbers.is_empty() {
            return Err(A::Error::custom("expected a picture, found a number"));
        }
        let found = faces.len();
        let wrong =
            |_| A::Error::custom(format!("expected the six faces of a cube map, found {found} pictures"));
        Ok(UniformEntry::Cube(Box::new(faces.try_into().map_err(wrong)?)))
    }
}

impl JsonSchema for UniformEntry {
    fn schema_name() -> Cow<'static, str> {
        "UniformValue".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let numbers = json_schema!({ "type": "array", "items": { "type": ["number", "array", "string"] } });
        json_schema!({ "anyOf": [{ "type": ["number", "boolean", "string"] }, numbers] })
    }
}
