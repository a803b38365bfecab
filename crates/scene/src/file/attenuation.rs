//! How light fades, in a scene file.

use std::fmt;
use std::ops::Range;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::error::Problem;
use super::values::Amount;
use crate::Attenuation;
use crate::names::names;

/// How light fades with the distance d: 1 / (constant + linear d + quadratic d²).
#[derive(Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum AttenuationValue {
    /// A law with a name.
    Name(AttenuationName),
    /// The three factors; those that are missing are 0.
    Table(AttenuationTable),
}

names! {
    /// The laws that have a name.
    pub(crate) AttenuationName {
        /// No fading.
        None = "none",
        /// The inverse square law: 0, 0, 1.
        Physical = "physical",
    } default None
}

/// The factors of 1 / (constant + linear d + quadratic d²). Those that are missing are 0, but not
/// all of them may be.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AttenuationTable {
    /// The part that does not depend on distance.
    pub constant: Option<Amount>,
    /// The factor of d, in 1/m.
    pub linear: Option<Amount>,
    /// The factor of d², in 1/m².
    pub quadratic: Option<Amount>,
}

impl<'de> Deserialize<'de> for AttenuationValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value;
        impl<'de> Visitor<'de> for Value {
            type Value = AttenuationValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"physical\", \"none\", or a table of constant, linear and quadratic")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<AttenuationValue, E> {
                let name = serde::de::value::StrDeserializer::new(name);
                AttenuationName::deserialize(name).map(AttenuationValue::Name)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<AttenuationValue, A::Error> {
                AttenuationTable::deserialize(MapAccessDeserializer::new(map)).map(AttenuationValue::Table)
            }
        }
        deserializer.deserialize_any(Value)
    }
}

impl AttenuationValue {
    /// The law; `span` is where the value stands.
    pub fn build(&self, span: &Range<usize>) -> Result<Attenuation, Problem> {
        match self {
            Self::Name(AttenuationName::None) => Ok(Attenuation::NONE),
            Self::Name(AttenuationName::Physical) => Ok(Attenuation::PHYSICAL),
            Self::Table(table) => {
                let factor = |amount: Option<Amount>| amount.map_or(0.0, |a| a.0);
                let attenuation = Attenuation {
                    constant: factor(table.constant),
                    linear: factor(table.linear),
                    quadratic: factor(table.quadratic),
                };
                let sum = attenuation.constant + attenuation.linear + attenuation.quadratic;
                match sum > 0.0 {
                    true => Ok(attenuation),
                    false => {
                        let message = "constant, linear and quadratic are all 0, which divides by 0";
                        Err(Problem::at(span, message).help("keys missing in a given table are 0"))
                    }
                }
            }
        }
    }
}
