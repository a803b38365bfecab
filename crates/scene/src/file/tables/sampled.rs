//! Functions of wavelength given by their samples, exactly as the scene holds them.

use std::borrow::Cow;
use std::fmt;

use glanz_color::{Observer, ObserverKind, SAMPLES, Spectrum};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::Number;

/// A number for a constant, or the 97 values at 300, 305 … 780 nm.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sampled(pub Spectrum);

impl<'de> Deserialize<'de> for Sampled {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = Spectrum;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a number, or {SAMPLES} of them for 300, 305 … 780 nm")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Spectrum, E> {
                let number = Number::deserialize(serde::de::value::F64Deserializer::new(value))?;
                Ok(Spectrum::constant(number.0))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Spectrum, E> {
                self.visit_f64(value as f64)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Spectrum, A::Error> {
                let mut values = Vec::with_capacity(SAMPLES);
                while let Some(Number(value)) = seq.next_element()? {
                    values.push(value);
                }
                Spectrum::try_from(values).map_err(A::Error::custom)
            }
        }
        deserializer.deserialize_any(Form).map(Self)
    }
}

impl JsonSchema for Sampled {
    fn schema_name() -> Cow<'static, str> {
        "Samples".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let number = Number::json_schema(generator);
        json_schema!({
            "description": "A number for a constant, or the values at 300, 305 … 780 nm.",
            "anyOf": [number, { "type": "array", "items": number, "minItems": SAMPLES, "maxItems": SAMPLES }]
        })
    }
}

/// What a coat over a lobe absorbs.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AbsorptionTable {
    /// absorption · thickness at each wavelength.
    pub depth: Sampled,
    /// Index of refraction of the coat.
    pub eta: Number,
}

/// An observer by its curves.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ObserverTable {
    /// Its name.
    pub name: String,
    /// What it is, in a few words.
    #[serde(default)]
    pub title: String,
    /// What the channels are.
    pub kind: ObserverKind,
    /// The channels in their order.
    pub channels: Vec<ChannelTable>,
}

/// One channel of an observer.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChannelTable {
    /// Its name, such as `x` or `L`.
    pub name: String,
    /// Its response to a unit of light at each wavelength.
    pub sensitivity: Sampled,
}

impl ObserverTable {
    /// The observer.
    pub(crate) fn observer(&self) -> Observer {
        let channel = |table: &ChannelTable| glanz_color::Channel {
            name: table.name.clone(),
            sensitivity: table.sensitivity.0,
        };
        Observer {
            name: self.name.clone(),
            title: self.title.clone(),
            channels: self.channels.iter().map(channel).collect(),
            kind: self.kind,
            reference: None,
        }
    }
}

/// An observer: the name of one or of a file, or its curves.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum ObserverValue {
    /// A name from `glanz color list observers`, or a CSV file with a curve for each channel of a sensor.
    Name(String),
    /// The curves themselves.
    Table(ObserverTable),
}

impl<'de> Deserialize<'de> for ObserverValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = ObserverValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of an observer, of a CSV file, or a table of channels")
            }
            fn visit_str<E>(self, name: &str) -> Result<ObserverValue, E> {
                Ok(ObserverValue::Name(name.to_owned()))
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<ObserverValue, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                ObserverTable::deserialize(map).map(ObserverValue::Table)
            }
        }
        deserializer.deserialize_any(Form)
    }
}
