//! The camera.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::{At, FieldOfView, Positive, Vector};
use crate::names::names;

/// The camera.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CameraTable {
    /// Position of the eye.
    pub eye: At<Vector>,
    /// The point in the middle of the picture; the origin by default.
    pub target: Option<At<Vector>>,
    /// The direction that appears upright; +Y by default.
    pub up: Option<super::values::Direction>,
    /// Perspective or parallel.
    #[serde(default)]
    pub projection: ProjectionName,
    /// Vertical field of view of a perspective camera, in degrees; 40 by default.
    pub fov_deg: Option<At<FieldOfView>>,
    /// The same in radians, where degrees cannot say it exactly.
    pub fov_rad: Option<At<Positive>>,
    /// What height an orthographic camera shows, in metres.
    pub height: Option<At<Positive>>,
}

/// A camera, or the name of one.
#[derive(Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum CameraRef {
    /// A camera.
    Table(CameraTable),
    /// The name of a camera of a glTF file that an object is from, or its number among all of them, from 0.
    Name(String),
}

impl<'de> Deserialize<'de> for CameraRef {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Camera;
        impl<'de> Visitor<'de> for Camera {
            type Value = CameraRef;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a camera's table, or the name of a camera of a glTF file")
            }
            fn visit_str<E>(self, name: &str) -> Result<CameraRef, E> {
                Ok(CameraRef::Name(name.to_owned()))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<CameraRef, A::Error> {
                CameraTable::deserialize(MapAccessDeserializer::new(map)).map(CameraRef::Table)
            }
        }
        deserializer.deserialize_any(Camera)
    }
}

names! {
    /// How the scene is projected.
    pub(crate) ProjectionName {
        /// A pinhole.
        Perspective = "perspective",
        /// Parallel rays.
        Orthographic = "orthographic",
    } default Perspective
}
