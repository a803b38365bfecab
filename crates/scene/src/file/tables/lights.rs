//! Lights, and how they fade with distance.

use std::fmt;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::colors::{ColorValue, SpectrumValue};
use super::geometry::turn::Turn;
use super::profile::ProfileValue;
use super::values::{Amount, At, Direction, Exponent, HalfTurn, Number, Positive, Vector};
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

/// A light.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightTable {
    /// A name for people.
    #[serde(default)]
    pub name: String,
    /// What kind of light it is.
    pub kind: KindName,
    /// Where a point or spot light is; the centre of a rectangle, disk or sphere.
    pub position: Option<At<Vector>>,
    /// The way that the light of a directional or spot light travels; the way that a rectangle or disk
    /// faces; the axis of a point light's `profile`, down by default.
    pub direction: Option<At<Direction>>,
    /// The point that a spot, rectangle, disk or profile is directed at, in place of `direction`.
    pub target: Option<At<Vector>>,
    /// What it sends to diffuse and specular terms that have no colour of their own below, or to ambient terms if it is
    /// ambient light; white by default. 1 on a white matte surface that faces the light gives 1. Of a rectangle, disk, sphere or
    /// environment it is the radiance: 1 is that of such a surface.
    pub color: Option<At<ColorValue>>,
    /// Its spectrum, in place of `color`: the name of a light source, or a table.
    pub spectrum: Option<At<SpectrumValue>>,
    /// What it sends to ambient terms; `color` of ambient light, else nothing by default, as in OpenGL.
    pub ambient: Option<At<ColorValue>>,
    /// What it sends to diffuse terms; `color` by default.
    pub diffuse: Option<At<ColorValue>>,
    /// What it sends to specular terms; `color` by default.
    pub specular: Option<At<ColorValue>>,
    /// Multiplies all its colours; 1 by default.
    pub intensity: Option<At<Amount>>,
    /// What a directional light gives on a surface that faces it, in lx, in place of `intensity`. A scene
    /// with one light in physical units must have all its lights in such.
    pub illuminance_lx: Option<At<Amount>>,
    /// What a point or spot light sends along its axis, or where its `profile` is greatest, in cd; it
    /// fades by the inverse square law.
    pub luminous_intensity_cd: Option<At<Amount>>,
    /// The same in W/sr between 300 and 780 nm.
    pub radiant_intensity_w_sr: Option<At<Amount>>,
    /// How bright the environment is that ambient light comes from, or an environment where its picture
    /// is 1, or a rectangle, disk or sphere, in cd/m².
    pub luminance_cd_m2: Option<At<Amount>>,
    /// What a rectangle, disk or sphere sends in all, from both sides if it has two, in lm.
    pub luminous_flux_lm: Option<At<Amount>>,
    /// How a point or spot light fades with distance; not at all by default.
    pub attenuation: Option<At<AttenuationValue>>,
    /// Half the opening angle of a spot's cone in degrees, 180 for all directions; 45 by default.
    pub cutoff_deg: Option<At<HalfTurn>>,
    /// The same in radians, where degrees cannot say it exactly.
    pub cutoff_rad: Option<At<Amount>>,
    /// Cosines of the angles between which a spot fades from full to nothing, in place of `exponent`, as in glTF.
    pub smooth_edge: Option<At<[Number; 2]>>,
    /// Power of the cosine from a spot's axis by which its light falls off; 0 by default.
    pub exponent: Option<At<Exponent>>,
    /// A luminaire's profile for a point or spot light: an LM-63 (`.ies`) or EULUMDAT (`.ldt`) file,
    /// relative to the scene file. With `intensity` or `luminous_intensity_cd` it is relative to its
    /// maximum; without, the light has the file's candela.
    pub profile: Option<At<ProfileValue>>,
    /// Where the half plane C 0° of the profile points; +X by default, +Y of a light along X.
    pub profile_c0: Option<At<Direction>>,
    /// Factor of the profile's candela; 1 by default.
    pub dimming: Option<At<Amount>>,
    /// Across a rectangle, in m.
    pub width: Option<At<Positive>>,
    /// Along the `up` of a rectangle, in m.
    pub height: Option<At<Positive>>,
    /// Width and height of a rectangle, in m, in place of the two.
    pub size: Option<At<[Positive; 2]>>,
    /// Of a disk or sphere, in m.
    pub radius: Option<At<Positive>>,
    /// Where the height of a rectangle points; +Y by default, -Z of one that faces up or down.
    pub up: Option<At<Direction>>,
    /// Whether a rectangle or disk shines on its back, too; not by default.
    pub two_sided: Option<At<bool>>,
    /// The picture of an environment: a Radiance HDR or OpenEXR file in equirectangular projection,
    /// relative to the scene file. Without it the same comes from all directions.
    pub file: Option<At<String>>,
    /// How an environment is turned: degrees about +Y, or rotations as those of objects.
    pub rotate_deg: Option<At<Turn>>,
    /// The same as the three rows of a matrix.
    pub rotation: Option<At<[[Number; 3]; 3]>>,
    /// What position and direction are relative to.
    pub attached_to: Option<At<AttachedTo>>,
}

names! {
    /// The kinds of light.
    pub(crate) KindName {
        /// From everywhere, on everything.
        Ambient = "ambient",
        /// Parallel light.
        Directional = "directional",
        /// From a point in all directions.
        Point = "point",
        /// From a point into a cone.
        Spot = "spot",
        /// From a rectangle that shines evenly.
        Rectangle = "rectangle",
        /// From a disk that shines evenly.
        Disk = "disk",
        /// From a sphere that shines evenly.
        Sphere = "sphere",
        /// From an environment at infinite distance.
        Environment = "environment",
    } default Ambient
}

names! {
    /// What a light moves with.
    pub(crate) AttachedTo {
        /// Nothing: it stands still.
        World = "world",
        /// The camera: x to the right, y up, -z along the view.
        Camera = "camera",
    } default World
}
