//! Textures, and how materials apply them.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use crate::file::tables::table;
use crate::file::tables::values::{Amount, At, Fraction, Number};
use crate::{TextureChannel, TextureFilter, Wrap};

/// A picture on a surface.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextureTable {
    /// A PNG, JPEG or WebP file, relative to the scene file.
    pub file: Option<String>,
    /// In place of a file, the name of one of the scene's `textures`.
    pub texture: Option<String>,
    /// What happens outside 0 to 1.
    pub wrap: Option<At<WrapValue>>,
    /// How texels become values.
    pub filter: Option<At<TextureFilter>>,
    /// Repetitions along u and v.
    pub repeat: Option<At<[Number; 2]>>,
    /// In place of `repeat`, the two rows of an affine map of the texture coordinates.
    pub transform: Option<At<[[Number; 3]; 2]>>,
    /// Scale of the x and y of normals; 1 by default.
    pub scale: Option<Amount>,
    /// By which set of texture coordinates it lies: 0, the mesh's `uvs`, or 1, its `uvs2`.
    #[serde(default)]
    pub uv_set: UvSet,
}

/// A set of texture coordinates: 0 or 1.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(try_from = "u32")]
pub(crate) struct UvSet(#[schemars(range(max = 1))] pub u32);

impl TryFrom<u32> for UvSet {
    type Error = String;
    fn try_from(number: u32) -> Result<Self, String> {
        match number {
            0 | 1 => Ok(Self(number)),
            _ => Err(format!("expected 0 or 1, the number of a set of texture coordinates, found {number}")),
        }
    }
}

/// A texture that materials call by its name.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NamedTextureTable {
    /// A name for people; that of the table by default.
    pub name: Option<String>,
    /// A PNG, JPEG or WebP file, relative to the scene file.
    pub file: At<String>,
    /// Whether its colours are sRGB codes; plain numbers if not, as in pictures of normals. They are by default.
    #[serde(default = "table::yes")]
    pub srgb: bool,
    /// What happens outside 0 to 1.
    #[serde(default)]
    pub wrap: WrapValue,
    /// How texels become values.
    #[serde(default)]
    pub filter: TextureFilter,
}

/// A number that a picture says at each place: a channel, and how the numbers 0 and 1 count.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaskTable {
    /// The picture.
    pub picture: At<TextureValue>,
    /// The channel that says it.
    #[serde(default)]
    pub channel: TextureChannel,
    /// What counts where the channel is 0.
    pub from: Option<At<Fraction>>,
    /// What counts where the channel is 1.
    pub to: Option<At<Fraction>>,
}

/// What says how rough a lobe is.
#[derive(Debug)]
pub(crate) enum RoughValue {
    /// `false`: it is as rough everywhere, whatever the material's picture says.
    Never,
    /// By a picture of its own.
    Own(Box<TextureChannelTable>),
}

impl<'de> Deserialize<'de> for RoughValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Rough;
        impl<'de> Visitor<'de> for Rough {
            type Value = RoughValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("false, or a picture: { picture = \"rough.png\", channel = \"green\" }")
            }
            fn visit_bool<E: serde::de::Error>(self, value: bool) -> Result<RoughValue, E> {
                match value {
                    false => Ok(RoughValue::Never),
                    true => Err(E::invalid_value(serde::de::Unexpected::Bool(true), &self)),
                }
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RoughValue, A::Error> {
                let table = TextureChannelTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(RoughValue::Own(Box::new(table)))
            }
        }
        deserializer.deserialize_any(Rough)
    }
}

impl JsonSchema for RoughValue {
    fn schema_name() -> Cow<'static, str> {
        "Roughness".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<TextureChannelTable>();
        json_schema!({
            "description": "What scales how rough it is: the channel of a picture; false, nothing.",
            "anyOf": [{ "const": false }, table],
        })
    }
}

/// A channel of a picture.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextureChannelTable {
    /// The picture.
    pub picture: At<TextureValue>,
    /// The channel that says it.
    #[serde(default)]
    pub channel: TextureChannel,
}

/// What happens outside 0 to 1: the same along u and v, or one for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct WrapValue(pub [Wrap; 2]);

impl<'de> Deserialize<'de> for WrapValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Form;
        impl<'de> Visitor<'de> for Form {
            type Value = WrapValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"repeat\", \"mirror\" or \"clamp\", or two of them")
            }
            fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<WrapValue, E> {
                let wrap = Wrap::deserialize(serde::de::value::StrDeserializer::new(name))?;
                Ok(WrapValue([wrap; 2]))
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<WrapValue, A::Error> {
                let list = serde::de::value::SeqAccessDeserializer::new(seq);
                <[Wrap; 2]>::deserialize(list).map(WrapValue)
            }
        }
        deserializer.deserialize_any(Form)
    }
}

impl JsonSchema for WrapValue {
    fn schema_name() -> Cow<'static, str> {
        "WrapValue".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<Wrap>();
        let two = generator.subschema_for::<[Wrap; 2]>();
        json_schema!({ "anyOf": [one, two] })
    }
}

/// A picture file, with or without how it is applied.
#[derive(Debug)]
pub(crate) struct TextureValue(pub TextureTable);

impl<'de> Deserialize<'de> for TextureValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Texture;
        impl<'de> Visitor<'de> for Texture {
            type Value = TextureTable;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a picture file, or a table such as { file = \"wood.png\" }")
            }
            fn visit_str<E>(self, file: &str) -> Result<TextureTable, E> {
                Ok(TextureTable { file: Some(file.to_owned()), ..TextureTable::default() })
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TextureTable, A::Error> {
                TextureTable::deserialize(MapAccessDeserializer::new(map))
            }
        }
        deserializer.deserialize_any(Texture).map(Self)
    }
}

impl JsonSchema for TextureValue {
    fn schema_name() -> Cow<'static, str> {
        "Texture".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let table = generator.subschema_for::<TextureTable>();
        json_schema!({ "anyOf": [{ "type": "string", "description": "A PNG, JPEG or WebP file." }, table] })
    }
}
