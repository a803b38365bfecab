//! The picture and how to draw it.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer};

use super::sampled::ObserverValue;
use super::values::{At, Color, Stops};
use crate::{
    COLOR_MODES, ColorMode, DebugView, Encoding, Interpolation, Lighting, Mistake, Shading, ToneMap, White,
};

/// The picture to be made.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct ImageTable {
    /// Width in pixels.
    pub width: Side,
    /// Height in pixels.
    pub height: Side,
    /// Samples per pixel for anti-aliasing.
    pub samples: Samples,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// The background: a colour, "transparent", or "environment", the first light of that kind.
    pub background: Option<At<BackgroundValue>>,
}

impl Default for ImageTable {
    fn default() -> Self {
        let image = crate::Image::default();
        Self {
            width: Side(image.width),
            height: Side(image.height),
            samples: Samples(image.samples),
            supersample: image.supersample,
            background: None,
        }
    }
}

/// How to draw.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct RenderTable {
    /// Where the illumination model is evaluated, and what is interpolated.
    pub shading: Shading,
    /// How values between vertices are found.
    pub interpolation: Interpolation,
    /// What the picture shows.
    pub show: DebugView,
    /// How light is compressed to the display's range.
    pub tone_map: ToneMap,
    /// Exposure in stops.
    pub ev: Option<Stops>,
    /// How light becomes codes: by the transfer function of sRGB, or raw, as a shader's output in a framebuffer of
    /// OpenGL.
    pub encoding: Encoding,
    /// How colour is treated.
    pub mode: ModeValue,
    /// The white that becomes the white of the screen.
    pub white: WhiteValue,
    /// Who looks: the name of an observer, an eye such as "age:70" or "deutan:10", or a file with the curves of a sensor
    /// (CSV); the standard observer of 1931 by default. Not in mode rgb.
    pub observer: Option<At<ObserverValue>>,
    /// Whether light is in photometric units, 1 being 1 cd/m² on a white matte surface, also where no unit is
    /// written; by default where a light or an emission is given in such units.
    pub photometric: Option<At<bool>>,
    /// Whether surfaces stand in each other's light; not by default, as the classic models have it.
    pub shadows: bool,
    /// How light from areas and environments is found: by what is prepared, or by points, which is slow and exact.
    pub lighting: Lighting,
    /// Points of each area and environment at each pixel with lighting "exact"; 1024 by default.
    pub light_samples: Option<LightSamples>,
    /// A mistake to be drawn on purpose, for teaching; none by default.
    pub mistake: Option<Mistake>,
}

/// A colour mode by its name.
#[derive(Debug, Default)]
pub(crate) struct ModeValue(pub ColorMode);

impl<'de> Deserialize<'de> for ModeValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map(Self).map_err(D::Error::custom)
    }
}

impl JsonSchema for ModeValue {
    fn schema_name() -> Cow<'static, str> {
        "ColorMode".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let fixed: Vec<&str> =
            COLOR_MODES.map(|(name, _)| name).into_iter().filter(|n| !n.contains(':')).collect();
        json_schema!({ "anyOf": [{ "enum": fixed }, { "type": "string", "pattern": "^sampled:[1-9][0-9]?$" }] })
    }
}

/// A white by its name.
#[derive(Debug, Default)]
pub(crate) struct WhiteValue(pub White);

impl<'de> Deserialize<'de> for WhiteValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map(Self).map_err(D::Error::custom)
    }
}

impl JsonSchema for WhiteValue {
    fn schema_name() -> Cow<'static, str> {
        "White".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "enum": White::ALL.map(|(_, name, _)| name) })
    }
}

/// A side of a picture in pixels.
#[derive(Debug)]
pub(crate) struct Side(pub u32);

/// The longest side of a picture, in pixels.
const MAX_SIDE: u32 = 16_384;

impl<'de> Deserialize<'de> for Side {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let pixels = i64::deserialize(deserializer)?;
        u32::try_from(pixels).ok().filter(|p| (1..=MAX_SIDE).contains(p)).map(Self).ok_or_else(|| {
            D::Error::custom(format!("expected between 1 and {MAX_SIDE} pixels, found {pixels}"))
        })
    }
}

impl JsonSchema for Side {
    fn schema_name() -> Cow<'static, str> {
        "Side".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 1, "maximum": MAX_SIDE })
    }
}

/// Samples per pixel.
#[derive(Debug)]
pub(crate) struct Samples(pub u32);

impl<'de> Deserialize<'de> for Samples {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match i64::deserialize(deserializer)? {
            samples @ (1 | 2 | 4 | 8 | 16) => Ok(Self(samples as u32)),
            found => Err(D::Error::custom(format!("expected 1, 2, 4, 8 or 16 samples, found {found}"))),
        }
    }
}

impl JsonSchema for Samples {
    fn schema_name() -> Cow<'static, str> {
        "Samples".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "enum": [1, 2, 4, 8, 16] })
    }
}

/// Points of a light at a pixel.
#[derive(Debug)]
pub(crate) struct LightSamples(pub u32);

/// The most points of a light at a pixel.
const MOST_LIGHT_SAMPLES: u32 = 1 << 20;

impl<'de> Deserialize<'de> for LightSamples {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let points = i64::deserialize(deserializer)?;
        let fits = u32::try_from(points).ok().filter(|points| (2..=MOST_LIGHT_SAMPLES).contains(points));
        fits.map(Self).ok_or_else(|| {
            D::Error::custom(format!("expected between 2 and {MOST_LIGHT_SAMPLES} points, found {points}"))
        })
    }
}

impl JsonSchema for LightSamples {
    fn schema_name() -> Cow<'static, str> {
        "LightSamples".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 2, "maximum": MOST_LIGHT_SAMPLES })
    }
}

/// The background of the picture.
#[derive(Debug)]
pub(crate) struct BackgroundValue(pub crate::Background);

impl<'de> Deserialize<'de> for BackgroundValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Background;
        impl<'de> Visitor<'de> for Background {
            type Value = BackgroundValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "a colour such as [0.0, 0.0, 0.2], 0.5, \"#rrggbb\", \"transparent\" or \"environment\"",
                )
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<BackgroundValue, E> {
                match text {
                    "transparent" => return Ok(BackgroundValue(crate::Background::Transparent)),
                    "environment" => return Ok(BackgroundValue(crate::Background::Environment)),
                    _ => {}
                }
                let color = Color::parse_hex(text);
                color.map(|c| BackgroundValue(crate::Background::Color(c.0))).ok_or_else(|| {
                    let found = text.chars().take(40).collect::<String>();
                    E::custom(format!(
                        "expected a colour, \"transparent\" or \"environment\", found \"{found}\""
                    ))
                })
            }
            fn visit_f64<E: Error>(self, gray: f64) -> Result<BackgroundValue, E> {
                let de = serde::de::value::F64Deserializer::new(gray);
                Color::deserialize(de).map(|c| BackgroundValue(crate::Background::Color(c.0)))
            }
            fn visit_i64<E: Error>(self, gray: i64) -> Result<BackgroundValue, E> {
                self.visit_f64(gray as f64)
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<BackgroundValue, A::Error> {
                let de = serde::de::value::SeqAccessDeserializer::new(seq);
                Color::deserialize(de).map(|c| BackgroundValue(crate::Background::Color(c.0)))
            }
        }
        deserializer.deserialize_any(Background)
    }
}

impl JsonSchema for BackgroundValue {
    fn schema_name() -> Cow<'static, str> {
        "Background".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let color = generator.subschema_for::<Color>();
        json_schema!({ "anyOf": [{ "enum": ["transparent", "environment"] }, color] })
    }
}
