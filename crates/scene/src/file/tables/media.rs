//! Media: metals and glasses by name, by numbers, or from files.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::{At, Fraction, Number};

/// A metal or glass by name, an index of refraction, or n and k.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum IorValue {
    /// The name of a medium, or n and k as in "1.5+3i".
    Name(String),
    /// The index of refraction of a medium that does not absorb.
    Index(f64),
    /// n and k in numbers or from files.
    Table(Box<IorTable>),
}

impl<'de> Deserialize<'de> for IorValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = IorValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "the name of a metal or glass such as \"Au\", an index of refraction such as 1.5, or a table such as { file = \"Au.yml\" } or { n = 0.2, k = 3.0 }",
                )
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<IorValue, E> {
                Ok(IorValue::Name(name.to_owned()))
            }
            fn visit_f64<E: Error>(self, index: f64) -> Result<IorValue, E> {
                // The series of the tint table holds 1e-4 between these.
                match (1.05..=20.0).contains(&index) {
                    true => Ok(IorValue::Index(index)),
                    false => Err(E::custom(format!(
                        "expected an index of refraction between 1.05 and 20, found {index}"
                    ))),
                }
            }
            fn visit_i64<E: Error>(self, index: i64) -> Result<IorValue, E> {
                self.visit_f64(index as f64)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<IorValue, A::Error> {
                let table = IorTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(IorValue::Table(Box::new(table)))
            }
        }
        deserializer.deserialize_any(Form)
    }
}

/// n and k: from a file, or in numbers.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct IorTable {
    /// A name for people.
    pub name: Option<String>,
    /// A file of n and k: a text table, a record (YAML) of refractiveindex.info, or the n of a pair of `.spd` files.
    pub file: Option<At<String>>,
    /// The wavelengths in nm of lists `n` and `k`, increasing.
    pub nm: Option<At<Vec<Number>>>,
    /// The real part.
    #[serde(alias = "eta")]
    pub n: Option<At<IorPart>>,
    /// The extinction coefficient; 0 by default.
    pub k: Option<At<IorPart>>,
    /// Where the numbers come from.
    #[serde(default)]
    pub source: String,
}

/// n or k.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected a number, a list of them, or { file = \"Au.eta.spd\" }")]
pub(crate) enum IorPart {
    /// The same at all wavelengths.
    Number(Number),
    /// At each wavelength of `nm`, or without it the 97 values at 300, 305 … 780 nm.
    Values(Vec<Number>),
    /// A file of this part alone.
    File(IorFile),
}

/// A file of n alone, or of k.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct IorFile {
    /// Its name, relative to the scene file.
    pub file: String,
}

/// A coat through which light meets a boundary.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CoatAbove {
    /// Its index of refraction.
    pub ior: IorValue,
    /// The width of its highlight.
    pub alpha: Fraction,
}
