//! The profile of a luminaire.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::{Amount, Number};

/// The profile of a luminaire: the name of its file, or its numbers.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum ProfileValue {
    /// An LM-63 (`.ies`) or EULUMDAT (`.ldt`) file.
    File(String),
    /// The numbers themselves.
    Table(ProfileTable),
}

/// Luminous intensity over the directions of a luminaire.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProfileTable {
    /// The half planes C in degrees, increasing, from 0 to 360; a single 0 for the same all around.
    pub c_deg: Vec<Number>,
    /// The angles γ in degrees, increasing, within 0 to 180.
    pub gamma_deg: Vec<Number>,
    /// Intensity in cd: for each half plane a list over the angles γ.
    pub candela: Vec<Vec<Amount>>,
}

impl<'de> Deserialize<'de> for ProfileValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = ProfileValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "the name of an LM-63 or EULUMDAT file, or a table of c_deg, gamma_deg and candela",
                )
            }
            fn visit_str<E>(self, name: &str) -> Result<ProfileValue, E> {
                Ok(ProfileValue::File(name.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ProfileValue, A::Error> {
                ProfileTable::deserialize(MapAccessDeserializer::new(map)).map(ProfileValue::Table)
            }
        }
        deserializer.deserialize_any(Form)
    }
}
