//! Lights of a scene file.

use std::fmt;
use std::ops::Range;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::error::Problem;
use super::types::names;
use super::values::{Amount, At, Color, Direction, Exponent, HalfTurn, Vector};
use crate::{Attenuation, Light, LightColors, LightKind, Space};

/// A light.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightTable {
    /// A name for people.
    #[serde(default)]
    pub name: String,
    /// What kind of light it is.
    pub kind: KindName,
    /// Where a point or spot light is.
    pub position: Option<At<Vector>>,
    /// The way that the light of a directional or spot light travels.
    pub direction: Option<At<Direction>>,
    /// What it sends to all terms of a material that have no colour of their own below; white by
    /// default. 1 on a white matte surface that faces the light gives 1.
    pub color: Option<Color>,
    /// What it sends to ambient terms; `color` by default.
    pub ambient: Option<Color>,
    /// What it sends to diffuse terms; `color` by default.
    pub diffuse: Option<At<Color>>,
    /// What it sends to specular terms; `color` by default.
    pub specular: Option<At<Color>>,
    /// Multiplies all its colours; 1 by default.
    pub intensity: Option<Amount>,
    /// How a point or spot light fades with distance; not at all by default.
    pub attenuation: Option<At<AttenuationValue>>,
    /// Half the opening angle of a spot's cone in degrees, 180 for all directions; 45 by default.
    pub cutoff_deg: Option<At<HalfTurn>>,
    /// Power of the cosine from a spot's axis by which its light falls off; 0 by default.
    pub exponent: Option<At<Exponent>>,
    /// What position and direction are relative to.
    pub attached_to: Option<At<AttachedTo>>,
}

names! {
    /// The kinds of light.
    pub(crate) KindName {
        /// From everywhere, on everything.
        #[default]
        Ambient = "ambient",
        /// Parallel light.
        Directional = "directional",
        /// From a point in all directions.
        Point = "point",
        /// From a point into a cone.
        Spot = "spot",
    }
}

names! {
    /// What a light moves with.
    pub(crate) AttachedTo {
        /// Nothing: it stands still.
        #[default]
        World = "world",
        /// The camera: x to the right, y up, -z along the view.
        Camera = "camera",
    }
}

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
        #[default]
        None = "none",
        /// The inverse square law: 0, 0, 1.
        Physical = "physical",
    }
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
    fn build(&self, span: &Range<usize>) -> Result<Attenuation, Problem> {
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

impl LightTable {
    /// The light; `span` is where the table stands.
    pub fn build(&self, span: &Range<usize>) -> Result<Light, Problem> {
        self.refuse_foreign_keys()?;
        let missing = |key: &str| {
            let kind = self.kind.name();
            Problem::at(span, format!("a {kind} light needs '{key}', which is missing"))
        };
        let position = || self.position.as_ref().map(|p| p.0).ok_or_else(|| missing("position"));
        let direction = || self.direction.as_ref().map(|d| d.0).ok_or_else(|| missing("direction"));
        let attenuation = match &self.attenuation {
            Some(value) => value.build(&value.span)?,
            None => Attenuation::NONE,
        };
        let kind = match self.kind {
            KindName::Ambient => LightKind::Ambient,
            KindName::Directional => LightKind::Directional { direction: direction()? },
            KindName::Point => LightKind::Point { position: position()?, attenuation },
            KindName::Spot => LightKind::Spot {
                position: position()?,
                direction: direction()?,
                cutoff: self.cutoff_deg.as_ref().map_or(45.0, |c| c.0).to_radians(),
                exponent: self.exponent.as_ref().map_or(0.0, |e| e.0),
                smooth_edge: None,
                attenuation,
            },
        };
        let space = match self.attached_to.as_ref().map(|a| a.value) {
            Some(AttachedTo::Camera) => Space::Camera,
            Some(AttachedTo::World) | None => Space::World,
        };
        Ok(Light { name: self.name.clone(), kind, colors: self.colors(), space })
    }

    fn colors(&self) -> LightColors {
        let all = self.color.unwrap_or(Color(glanz_color::Rgb::WHITE));
        let intensity = self.intensity.map_or(1.0, |i| i.0 as f32);
        let ambient = self.ambient.unwrap_or(all).0 * intensity;
        if self.kind == KindName::Ambient {
            return LightColors { ambient, ..LightColors::all(glanz_color::Rgb::BLACK) };
        }
        let part = |color: &Option<At<Color>>| color.as_ref().map_or(all, |c| c.value).0 * intensity;
        LightColors { ambient, diffuse: part(&self.diffuse), specular: part(&self.specular) }
    }

    /// Keys that lights of this kind do not have.
    fn refuse_foreign_keys(&self) -> Result<(), Problem> {
        fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
            value.as_ref().map(|v| &v.span)
        }
        use KindName::{Ambient, Directional, Point, Spot};
        let given: [(&str, _, &[KindName]); 8] = [
            ("position", place(&self.position), &[Point, Spot]),
            ("direction", place(&self.direction), &[Directional, Spot]),
            ("diffuse", place(&self.diffuse), &[Directional, Point, Spot]),
            ("specular", place(&self.specular), &[Directional, Point, Spot]),
            ("attenuation", place(&self.attenuation), &[Point, Spot]),
            ("cutoff_deg", place(&self.cutoff_deg), &[Spot]),
            ("exponent", place(&self.exponent), &[Spot]),
            ("attached_to", place(&self.attached_to), &[Directional, Point, Spot]),
        ];
        for (key, span, kinds) in given {
            if let Some(span) = span.filter(|_| !kinds.contains(&self.kind)) {
                let kinds = kinds.iter().map(|kind| kind.name()).collect::<Vec<_>>().join(", ");
                let kind = match self.kind {
                    Ambient => "an ambient",
                    Directional => "a directional",
                    Point => "a point",
                    Spot => "a spot",
                };
                let message = format!("{kind} light has no '{key}'");
                return Err(Problem::at(span, message).help(format!("'{key}' is for lights of kind {kinds}")));
            }
        }
        Ok(())
    }
}
