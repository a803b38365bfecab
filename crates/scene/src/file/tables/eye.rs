//! The eye that looks, and how.

use std::borrow::Cow;
use std::fmt;

use glanz_eye::{LEVELS, Lens, RodColor, level_cd_m2};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer};

use super::values::{
    Age, At, Density, FieldSize, Fraction, IrisPigment, Luminance, Number, PigmentShift, PixelsPerDegree,
};

/// The eye that looks, in place of an observer. Not in mode rgb.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct EyeTable {
    /// Years; 32, those of the standard observers, by default. The lens is known for 20 to 80.
    pub age: Option<Age>,
    /// The field in degrees, 2 by default: pigments are denser at its middle.
    pub field_deg: Option<FieldSize>,
    /// What is amiss with the cones: "protan", "deutan" or "tritan" where a kind is missing, "protan:10" or "deutan:10" where its
    /// pigment is moved towards the other's by so many nm, "rods" for sight without cones.
    pub deficiency: Option<At<String>>,
    /// By which formula the lens yellows; "none" for an eye without one.
    pub lens: Option<Lens>,
    /// The density of the lens, in parts of what is usual at that age.
    pub lens_density: Option<Density>,
    /// The density of the macular pigment, in parts of what is usual for the field.
    pub macula_density: Option<Density>,
    /// The densities of the pigments of L, M and S, in parts of what is usual for the field.
    pub pigment_density: Option<[Density; 3]>,
    /// By how many nm the peaks of the pigments of L, M and S are moved.
    pub shift_nm: Option<[PigmentShift; 3]>,
    /// The pigment of the iris, by which light is scattered in the eye: 0 black, 0.5 brown (by default), 1.2 light blue.
    pub iris: Option<IrisPigment>,
    /// How bright white is where the scene has classic units, in cd/m² or by name; by day without one.
    pub level: Option<LevelValue>,
    /// How far the cones are adapted to the white as this eye sees it: 0 shows the yellow of an old lens, 1 (by default) shows
    /// white as white.
    pub adapted: Option<Fraction>,
    /// The luminance that rods and pupil are adapted to, in cd/m²; the mean of the picture by default.
    pub adaptation_cd_m2: Option<Luminance>,
    /// The colour of what rods see.
    pub rods: Option<RodColor>,
    /// Whether light is scattered in the eye.
    pub glare: bool,
    /// Whether light of the ends of the spectrum is out of focus, through the pupil that the eye has at this light.
    pub chromatic: bool,
    /// Which noise the photons have that are caught in a tenth of a second, as a whole number; their mean without one.
    pub noise: Option<NoiseSeed>,
    /// Whether details are lost that the eye does not resolve at this light.
    pub acuity: bool,
    /// The pixel that is looked at, from the top left; details are lost around it.
    pub gaze: Option<[Number; 2]>,
    /// Pixels per degree of sight; by default those of a perspective camera, else 40.
    pub px_per_deg: Option<PixelsPerDegree>,
    /// Whether rods are drawn where nothing says that it is dark: for scenes in photometric units, which know their luminance.
    pub night: bool,
}

/// Which noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NoiseSeed(pub u32);

impl<'de> Deserialize<'de> for NoiseSeed {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let found = i64::deserialize(deserializer)?;
        let message = || format!("expected a whole number from 0 to {}, found {found}", u32::MAX);
        u32::try_from(found).map(Self).map_err(|_| D::Error::custom(message()))
    }
}

impl JsonSchema for NoiseSeed {
    fn schema_name() -> Cow<'static, str> {
        "NoiseSeed".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 0, "maximum": u32::MAX })
    }
}

/// A light level, in cd/m² or by name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LevelValue(pub f64);

impl<'de> Deserialize<'de> for LevelValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Level;
        impl Visitor<'_> for Level {
            type Value = LevelValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the luminance of white in cd/m², or the name of a light level")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<LevelValue, E> {
                level_cd_m2(text).map(LevelValue).map_err(E::custom)
            }
            fn visit_f64<E: Error>(self, level: f64) -> Result<LevelValue, E> {
                self.visit_str(&level.to_string())
            }
            fn visit_i64<E: Error>(self, level: i64) -> Result<LevelValue, E> {
                self.visit_f64(level as f64)
            }
        }
        deserializer.deserialize_any(Level)
    }
}

impl JsonSchema for LevelValue {
    fn schema_name() -> Cow<'static, str> {
        "Level".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let luminance = generator.subschema_for::<Luminance>();
        json_schema!({ "anyOf": [{ "enum": LEVELS.map(|(name, _)| name) }, luminance] })
    }
}
