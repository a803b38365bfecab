//! How an environment is turned.

use std::fmt;

use glam::{DMat3, DVec3};
use schemars::JsonSchema;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::place::Rotations;
use crate::file::tables::values::Number;

/// Degrees about +Y, or rotations.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "the variants tell the schema what the turn is read from")]
enum TurnForm {
    About(Number),
    Rotations(Rotations),
}

/// How an environment is turned: by degrees about +Y, or by rotations in the order in which they are done.
#[derive(Clone, Copy, Debug, JsonSchema)]
pub(crate) struct Turn(#[schemars(with = "TurnForm")] pub DMat3);

impl<'de> Deserialize<'de> for Turn {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = DMat3;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("degrees about +Y, a rotation such as { axis = [1, 0, 0], angle = 20 }, or a list of those")
            }
            fn visit_f64<E: Error>(self, degrees: f64) -> Result<DMat3, E> {
                let Number(degrees) = Number::deserialize(serde::de::value::F64Deserializer::new(degrees))?;
                // Whole turns are taken off in degrees, where that is exact.
                Ok(DMat3::from_axis_angle(DVec3::Y, (degrees % 360.0).to_radians()))
            }
            fn visit_i64<E: Error>(self, degrees: i64) -> Result<DMat3, E> {
                self.visit_f64(degrees as f64)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<DMat3, A::Error> {
                Rotations::deserialize(MapAccessDeserializer::new(map)).map(|r| r.matrix())
            }
            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<DMat3, A::Error> {
                Rotations::deserialize(SeqAccessDeserializer::new(seq)).map(|r| r.matrix())
            }
        }
        deserializer.deserialize_any(Form).map(Self)
    }
}
