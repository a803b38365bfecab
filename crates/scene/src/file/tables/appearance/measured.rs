//! Measured reflectance.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer};

use crate::file::tables::values::At;
use crate::names::names;

/// A file of measured reflectance, and how it is drawn.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeasuredTable {
    /// A file of readings or a table, as `glanz measure info` tells it: CSV, MERL, RGL and others.
    pub file: At<String>,
    /// How many channels are kept apart, of which the others are mixtures: 1 to 8; `auto` for as few as look the same.
    pub ranks: Option<At<RanksValue>>,
    /// Whether tables are smoothed as readings always are, rather than taken at their word; false by default.
    #[serde(default)]
    pub smooth: bool,
    /// How many readings stand for a direction between them, 1 to 1000; as many as tell readings best by default.
    pub neighbours: Option<At<NeighboursValue>>,
    /// What the file's numbers are, whatever it says itself.
    pub quantity: Option<At<QuantityName>>,
}

names! {
    /// What the numbers of a file of measured reflectance are.
    pub(crate) QuantityName {
        /// The BRDF, in 1/sr.
        Brdf = "brdf",
        /// The BRDF times the cosine of the detector's angle.
        BrdfCos = "brdf_cos",
        /// π times the BRDF.
        ReflectanceFactor = "reflectance_factor",
    } default Brdf
}

/// How many readings are neighbours: a number that is rounded, so that films can run through it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "f64")]
pub(crate) struct NeighboursValue(pub usize);

impl TryFrom<f64> for NeighboursValue {
    type Error = String;
    fn try_from(count: f64) -> Result<Self, String> {
        match count {
            1.0..=1000.0 => Ok(Self(libm::round(count) as usize)),
            _ => Err(format!("expected a number from 1 to 1000, found {count}")),
        }
    }
}

impl JsonSchema for NeighboursValue {
    fn schema_name() -> Cow<'static, str> {
        "Neighbours".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "number", "minimum": 1, "maximum": 1000 })
    }
}

/// A number of ranks; none for `auto`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RanksValue(pub Option<usize>);

impl<'de> Deserialize<'de> for RanksValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl Visitor<'_> for Form {
            type Value = RanksValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"auto\", or a number from 1 to 8")
            }
            fn visit_str<E: Error>(self, word: &str) -> Result<RanksValue, E> {
                match word {
                    "auto" => Ok(RanksValue(None)),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)),
                }
            }
            fn visit_i64<E: Error>(self, ranks: i64) -> Result<RanksValue, E> {
                match ranks {
                    1..=8 => Ok(RanksValue(Some(ranks as usize))),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Signed(ranks), &self)),
                }
            }
        }
        deserializer.deserialize_any(Form)
    }
}

impl JsonSchema for RanksValue {
    fn schema_name() -> Cow<'static, str> {
        "Ranks".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "const": "auto" }, { "type": "integer", "minimum": 1, "maximum": 8 }] })
    }
}
