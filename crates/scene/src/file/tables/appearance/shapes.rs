//! The shape of a lobe: the name of a model, or a user's BRDF.

use std::fmt;

use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};

use crate::file::tables::values::{At, Number};
use crate::names::names;

names! {
    /// Which of a light's colours a BRDF answers to.
    pub(crate) TermName {
        /// That of highlights.
        Specular = "specular",
        /// That of matte surfaces, whose tint textures multiply.
        Diffuse = "diffuse",
    } default Specular
}

/// `"ggx"`, or `{ file = "my.brdf", n = 20 }`.
#[derive(Debug)]
pub(crate) enum ShapeTable {
    Named(String),
    Brdf(BrdfTable),
}

/// A user's BRDF, and its parameters.
#[derive(Debug)]
#[cfg_attr(not(feature = "shader"), expect(dead_code, reason = "without the feature no BRDF is compiled"))]
pub(crate) struct BrdfTable {
    pub text: BrdfText,
    /// The model's name, where it is not the file's.
    pub name: Option<String>,
    pub term: TermName,
    pub params: Vec<(At<String>, At<Number>)>,
}

/// Where the text of a BRDF stands.
#[derive(Debug)]
pub(crate) enum BrdfText {
    File(At<String>),
    /// In the scene file: a function or an expression.
    Function(At<String>),
}

impl<'de> Deserialize<'de> for ShapeTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ShapeVisitor)
    }
}

struct ShapeVisitor;

impl<'de> Visitor<'de> for ShapeVisitor {
    type Value = ShapeTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a shape, or a BRDF such as { file = \"my.brdf\", n = 20 }")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<ShapeTable, E> {
        Ok(ShapeTable::Named(name.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<ShapeTable, A::Error> {
        let (mut file, mut function, mut name) = (None, None, None);
        let (mut term, mut params) = (TermName::default(), Vec::new());
        while let Some(key) = map.next_key::<At<String>>()? {
            match key.as_str() {
                "file" => file = Some(map.next_value()?),
                "function" => function = Some(map.next_value()?),
                "name" => name = Some(map.next_value()?),
                "term" => term = map.next_value()?,
                _ => params.push((key, map.next_value()?)),
            }
        }
        let text = match (file, function) {
            (Some(file), None) => BrdfText::File(file),
            (None, Some(function)) => BrdfText::Function(function),
            (Some(_), Some(_)) => {
                return Err(A::Error::custom("a BRDF is from a 'file' or a 'function', not both"));
            }
            (None, None) => return Err(A::Error::custom("a BRDF needs its 'file', or its 'function'")),
        };
        Ok(ShapeTable::Brdf(BrdfTable { text, name, term, params }))
    }
}

/// What the key `shape` may be beside the name of a model.
pub(super) fn brdf_schema() -> Value {
    let with = |own: &str, words: &str| {
        json!({
            "type": "object",
            "required": [own],
            "properties": {
                own: { "type": "string", "description": words },
                "name": { "type": "string", "description": "The model's name, where it is not the file's." },
                "term": {
                    "enum": ["specular", "diffuse"], "default": "specular",
                    "description": "Which of a light's colours it answers to; textures multiply the tint of a diffuse one.",
                },
            },
            "additionalProperties": { "type": "number", "description": "A parameter of the BRDF." },
        })
    };
    json!({
        "description": "A BRDF of one's own, with its parameters.",
        "oneOf": [
            with("file", "A .brdf file of BRDF Explorer, or one function in GLSL or WGSL, beside the scene file."),
            with("function", "A function in GLSL, or an expression: n = 20; pow(max(dot(N, H), 0), n)"),
        ],
    })
}
