//! The lobes of a general material.

use std::borrow::Cow;
use std::fmt;

use glanz_bsdf::{MODELS, ModelInfo};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value, json};

use super::layer_weights::{LayerTable, MetalnessTable};
use super::shapes::{ShapeTable, brdf_schema};
use super::textures::{MaskTable, RoughValue};
use crate::file::tables::colors::ColorValue;
use crate::file::tables::sampled::AbsorptionTable;
use crate::file::tables::values::{At, Fraction, Number};
use crate::names::names;

names! {
    /// How a tint depends on the angle.
    pub(crate) FresnelName {
        /// By Fresnel's law where an index of refraction is given, else not.
        Exact = "exact",
        /// In Schlick's form: the tint is the reflectance at normal incidence.
        Schlick = "schlick",
    } default Exact
}

/// The keys of all lobes.
pub(crate) const KEYS: [&str; 10] = [
    "shape",
    "tint",
    "textured",
    "weight",
    "fresnel",
    "layers",
    "absorption",
    "metalness",
    "masks",
    "rough_texture",
];

/// One term of a general material: `shape`, `tint`, `textured`, `weight`, `fresnel`, and the parameters of the
/// shape.
#[derive(Debug)]
pub(crate) struct LobeTable {
    pub shape: At<ShapeTable>,
    pub tint: Option<At<ColorValue>>,
    pub textured: Option<bool>,
    pub weight: Option<At<Fraction>>,
    pub fresnel: Option<At<FresnelName>>,
    pub layers: Option<At<Vec<LayerTable>>>,
    pub absorption: Option<AbsorptionTable>,
    pub metalness: Option<MetalnessTable>,
    pub masks: Vec<MaskTable>,
    pub rough_texture: Option<RoughValue>,
    pub params: Vec<(At<String>, At<Number>)>,
}

impl<'de> Deserialize<'de> for LobeTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct LobeVisitor;
        impl<'de> Visitor<'de> for LobeVisitor {
            type Value = LobeTable;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a lobe such as { shape = \"lambert\", tint = [0.7, 0.7, 0.2] }")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<LobeTable, A::Error> {
                let (mut shape, mut tint, mut textured) = (None, None, None);
                let (mut weight, mut fresnel, mut params) = (None, None, Vec::new());
                let (mut layers, mut absorption, mut metalness) = (None, None, None);
                let (mut masks, mut rough_texture) = (Vec::new(), None);
                while let Some(key) = map.next_key::<At<String>>()? {
                    match key.as_str() {
                        "shape" => shape = Some(map.next_value()?),
                        "tint" => tint = Some(map.next_value()?),
                        "textured" => textured = Some(map.next_value()?),
                        "weight" => weight = Some(map.next_value()?),
                        "fresnel" => fresnel = Some(map.next_value()?),
                        "layers" => layers = Some(map.next_value()?),
                        "absorption" => absorption = Some(map.next_value()?),
                        "metalness" => metalness = Some(map.next_value()?),
                        "masks" => masks = map.next_value()?,
                        "rough_texture" => rough_texture = Some(map.next_value()?),
                        _ => params.push((key, map.next_value()?)),
                    }
                }
                let shape = shape.ok_or_else(|| A::Error::missing_field("shape"))?;
                Ok(LobeTable {
                    shape,
                    tint,
                    textured,
                    weight,
                    fresnel,
                    layers,
                    absorption,
                    metalness,
                    masks,
                    rough_texture,
                    params,
                })
            }
        }
        deserializer.deserialize_any(LobeVisitor)
    }
}

impl JsonSchema for LobeTable {
    fn schema_name() -> Cow<'static, str> {
        "Lobe".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let keys = keys_of_every_model(generator);
        let mut variants: Vec<Value> = MODELS.iter().map(|info| variant(info, &keys)).collect();
        variants.push(brdf_variant(&keys));
        json_schema!({ "description": "A term of a material: a shape times a tint.", "oneOf": variants })
    }
}

/// The keys beside the shape and its parameters.
fn keys_of_every_model(generator: &mut SchemaGenerator) -> [(&'static str, Value); 9] {
    let color = generator.subschema_for::<ColorValue>();
    let layers = generator.subschema_for::<LayerTable>();
    let absorption = generator.subschema_for::<AbsorptionTable>();
    let metalness = generator.subschema_for::<MetalnessTable>();
    let masks = generator.subschema_for::<MaskTable>();
    let rough = generator.subschema_for::<RoughValue>();
    let textured =
        "Whether textures and vertex colours multiply the tint; for ambient and diffuse shapes by default.";
    let fresnel = "How the tint depends on the angle: exact for indices of refraction, or Schlick's form, in which any tint is the reflectance at normal incidence.";
    [
        ("tint", color.to_value()),
        ("textured", json!({ "type": "boolean", "description": textured })),
        (
            "weight",
            json!({ "type": "number", "minimum": 0, "maximum": 1, "default": 1,
                "description": "How much of the term there is." }),
        ),
        ("fresnel", json!({ "enum": ["exact", "schlick"], "default": "exact", "description": fresnel })),
        (
            "layers",
            json!({ "type": "array", "items": layers.to_value(),
                "description": "The weights of the layers over the term, from the inner to the outer." }),
        ),
        ("absorption", absorption.to_value()),
        ("metalness", metalness.to_value()),
        (
            "masks",
            json!({ "type": "array", "items": masks.to_value(),
                "description": "Factors that pictures say at each place." }),
        ),
        ("rough_texture", rough.to_value()),
    ]
}

/// A term whose shape is a user's BRDF.
fn brdf_variant(keys: &[(&'static str, Value)]) -> Value {
    let mut properties = Map::new();
    properties.insert("shape".into(), brdf_schema());
    properties.extend(keys.iter().map(|(key, schema)| ((*key).to_owned(), schema.clone())));
    json!({
        "type": "object", "title": "A BRDF of one's own", "required": ["shape"],
        "additionalProperties": false, "properties": properties,
    })
}

/// A term whose shape is this model.
fn variant(info: &ModelInfo, keys: &[(&'static str, Value)]) -> Value {
    let mut properties = Map::new();
    properties.insert("shape".into(), json!({ "const": info.name }));
    properties.extend(keys.iter().map(|(key, schema)| ((*key).to_owned(), schema.clone())));
    for param in info.params {
        let schema = json!({
            "type": "number", "description": param.doc, "default": param.default,
            "minimum": param.min, "maximum": param.max,
        });
        properties.insert(param.name.into(), schema);
    }
    json!({
        "type": "object", "title": info.title, "required": ["shape"],
        "additionalProperties": false, "properties": properties,
    })
}
