//! Surroundings of a scene file.

use std::fmt;
use std::sync::Arc;

use glam::{DMat3, DVec3};
use schemars::JsonSchema;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::build::Builder;
use super::error::Problem;
use super::lights::LightTable;
use super::place::Rotations;
use super::types::BackgroundValue;
use super::values::{At, Number};
use crate::read::{ReadOptions, read_environment};
use crate::{Background, EnvironmentMap, LightKind};

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

impl LightTable {
    /// The surroundings.
    pub(super) fn environment(&self, builder: &mut Builder) -> Result<LightKind, Problem> {
        let map = self.file.as_ref().map(|file| builder.environment_map(file)).transpose()?;
        let rotation = match (&self.rotate_deg, &self.rotation) {
            (Some(_), Some(rows)) => return Err(Problem::at(&rows.span, "'rotation' beside 'rotate_deg'")),
            (None, Some(rows)) => {
                let rows_are = rows.value.map(|row| row.map(|number| number.0));
                let matrix = DMat3::from_cols_array_2d(&rows_are).transpose();
                if !(matrix.transpose() * matrix).abs_diff_eq(DMat3::IDENTITY, 1e-6) {
                    return Err(Problem::at(&rows.span, "the rows are not those of a rotation"));
                }
                matrix
            }
            (turn, None) => turn.as_ref().map_or(DMat3::IDENTITY, |turn| turn.0),
        };
        Ok(LightKind::Environment { map, rotation })
    }
}

impl Builder {
    /// The picture of a file, read once. All of a scene take at most the memory that its textures may.
    fn environment_map(&mut self, file: &At<String>) -> Result<Arc<EnvironmentMap>, Problem> {
        if let Some(map) = self.environments.get(&file.value) {
            return Ok(map.clone());
        }
        let bytes = self.read_beside(file)?;
        let taken: usize = self.environments.values().map(|map| size_of_val(&map.pixels[..])).sum();
        let max_texture_bytes = self.options.max_texture_bytes.saturating_sub(taken as u64);
        let options = ReadOptions { max_texture_bytes, ..self.options.clone() };
        let (map, notes) = read_environment(&bytes, file, &options)
            .map_err(|error| Problem::at(&file.span, error.to_string()))?;
        self.notes.extend(notes.iter().map(|note| format!("'{}': {note}", file.value)));
        let map = Arc::new(map);
        self.environments.insert(file.value.clone(), map.clone());
        Ok(map)
    }

    /// That there is an environment where the background is to be one.
    pub(super) fn check_background(&self, background: Option<&At<BackgroundValue>>) -> Result<(), Problem> {
        let is_environment = |light: &crate::Light| matches!(light.kind, LightKind::Environment { .. });
        match background {
            Some(At { value: BackgroundValue(Background::Environment), span })
                if !self.scene.lights.iter().any(is_environment) =>
            {
                Err(Problem::at(span, "the background is to be the environment, but there is none")
                    .help("give a light of kind = \"environment\""))
            }
            _ => Ok(()),
        }
    }
}
