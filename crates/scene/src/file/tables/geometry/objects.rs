//! Objects: what they are made of.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::StringDeserializer;
use serde::de::{
    DeserializeSeed, EnumAccess, Error, IntoDeserializer, MapAccess, SeqAccess, VariantAccess, Visitor,
};
use serde::{Deserialize, Deserializer};

use crate::builtin::Builtin;
use crate::file::tables::values::{At, Color, HalfTurn};
use crate::names::names;
use crate::{Interpolation, Shading};

/// An object: a mesh put into the scene.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ObjectTable {
    /// A name for people and for overrides.
    #[serde(default)]
    pub name: String,
    /// What it is made of: a built-in mesh, or a file.
    pub mesh: At<MeshValue>,
    /// The name of a material. Without it objects from files keep their own, others are grey.
    pub material: Option<At<String>>,
    /// Where its origin is moved to, after scaling and rotating.
    pub translate: Option<At<crate::file::tables::values::Vector>>,
    /// One rotation or several, done in their order, after scaling.
    pub rotate_deg: Option<At<super::place::Rotations>>,
    /// One factor or three; negative ones mirror.
    pub scale: Option<At<super::place::Scale>>,
    /// Instead of the three above: the rows of a matrix of 3 or 4 rows and 4 columns.
    pub matrix: Option<At<super::place::Matrix>>,
    /// Where the illumination model is evaluated, if not as the scene says.
    pub shading: Option<Shading>,
    /// How values between vertices are found, if not as the scene says.
    pub interpolation: Option<Interpolation>,
    /// Where its normals come from; as the mesh has them by default.
    pub normals: Option<At<NormalsName>>,
    /// With smooth normals: facets that meet at a greater angle keep their edge.
    pub crease_deg: Option<At<HalfTurn>>,
    /// How often the mesh is subdivided by Loop's scheme.
    pub subdivide: Option<At<Levels>>,
    /// Vertex colours, multiplying the textured terms of the material: a list with a colour per
    /// vertex, "mesh" for those of the mesh, or "none". By default those of the mesh, but none on a
    /// built-in mesh that is given a material.
    pub colors: Option<At<ColorsValue>>,
    /// Shaders that draw it in place of its material.
    #[serde(default, deserialize_with = "crate::file::tables::table::optional")]
    pub program: Option<At<crate::file::tables::program::ProgramTable>>,
    /// Whether the lights of a glTF file come along; they do not by default.
    pub lights: Option<At<bool>>,
    /// The variant of a glTF file whose materials it has, in place of the file's own.
    pub variant: Option<At<String>>,
}

/// Vertex colours.
#[derive(Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum ColorsValue {
    /// A word.
    Name(ColorsName),
    /// A colour per vertex.
    List(Vec<Color>),
}

names! {
    /// Vertex colours that need no list.
    pub(crate) ColorsName {
        /// Those of the mesh.
        Mesh = "mesh",
        /// None.
        None = "none",
        /// Linear red, green and blue are x, y and z, from 0 to 1 across the mesh.
        Position = "position",
    } default Mesh
}

impl<'de> Deserialize<'de> for ColorsValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Colors;
        impl<'de> Visitor<'de> for Colors {
            type Value = ColorsValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of colours, \"mesh\", \"position\" or \"none\"")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<ColorsValue, E> {
                let name: serde::de::value::StrDeserializer<'_, E> = name.into_deserializer();
                ColorsName::deserialize(name).map(ColorsValue::Name)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<ColorsValue, A::Error> {
                let mut colors = Vec::new();
                while let Some(color) = seq.next_element()? {
                    colors.push(color);
                }
                Ok(ColorsValue::List(colors))
            }
        }
        deserializer.deserialize_any(Colors)
    }
}

names! {
    /// Where normals come from.
    pub(crate) NormalsName {
        /// As the mesh has them; smooth where it has none.
        Given = "given",
        /// Each facet its own.
        Facet = "facet",
        /// The angle-weighted mean over the facets around a point.
        Smooth = "smooth",
    } default Given
}

/// The most levels of subdivision; each multiplies the triangles by four.
const MAX_LEVELS: u32 = 10;

/// A number of subdivisions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Levels(pub u32);

impl<'de> Deserialize<'de> for Levels {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let levels = i64::deserialize(deserializer)?;
        u32::try_from(levels).ok().filter(|l| *l <= MAX_LEVELS).map(Self).ok_or_else(|| {
            D::Error::custom(format!("expected between 0 and {MAX_LEVELS} subdivisions, found {levels}"))
        })
    }
}

impl JsonSchema for Levels {
    fn schema_name() -> Cow<'static, str> {
        "Levels".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 0, "maximum": MAX_LEVELS })
    }
}

/// What an object is made of.
#[derive(Debug)]
pub(crate) enum MeshValue {
    /// A mesh that needs no file.
    Builtin(Builtin),
    /// The name of one of the scene's meshes.
    Named(String),
    /// A file, relative to the scene file.
    File(At<String>),
}

impl<'de> Deserialize<'de> for MeshValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(MeshVisitor)
    }
}

struct MeshVisitor;

impl<'de> Visitor<'de> for MeshVisitor {
    type Value = MeshValue;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "a mesh: a name such as \"sphere\", a table such as { sphere = { radius = 1.0 } }, \
             or { file = \"model.glb\" }",
        )
    }
    fn visit_str<E>(self, name: &str) -> Result<MeshValue, E> {
        let builtin = Builtin::named(name).map(MeshValue::Builtin);
        Ok(builtin.unwrap_or_else(|| MeshValue::Named(name.to_owned())))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<MeshValue, A::Error> {
        let Some(name) = map.next_key::<String>()? else {
            return Err(A::Error::custom("expected a mesh, found an empty table"));
        };
        let mesh = match name.as_str() {
            "file" => MeshValue::File(map.next_value()?),
            _ => MeshValue::Builtin(Builtin::deserialize(BuiltinEntry { name, map: &mut map })?),
        };
        match map.next_key::<String>()? {
            Some(other) => Err(A::Error::custom(format!("expected one mesh, found '{other}' as well"))),
            None => Ok(mesh),
        }
    }
}

/// An entry of a map as serde's representation of an enum: the key is the variant.
struct BuiltinEntry<'a, A> {
    name: String,
    map: &'a mut A,
}

impl<'de, A: MapAccess<'de>> Deserializer<'de> for BuiltinEntry<'_, A> {
    type Error = A::Error;
    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, A::Error> {
        visitor.visit_enum(self)
    }
    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

impl<'de, A: MapAccess<'de>> EnumAccess<'de> for BuiltinEntry<'_, A> {
    type Error = A::Error;
    type Variant = Self;
    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), A::Error> {
        let name: StringDeserializer<A::Error> = self.name.clone().into_deserializer();
        Ok((seed.deserialize(name)?, self))
    }
}

impl<'de, A: MapAccess<'de>> VariantAccess<'de> for BuiltinEntry<'_, A> {
    type Error = A::Error;
    fn unit_variant(self) -> Result<(), A::Error> {
        // A mesh without parameters: only the empty table says the same as its name.
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Empty {}
        self.map.next_value::<Empty>().map(|_| ())
    }
    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, A::Error> {
        self.map.next_value_seed(seed)
    }
    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(VisitTable(visitor))
    }
    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, A::Error> {
        self.map.next_value_seed(VisitTable(visitor))
    }
}

/// Lets a visitor see a value, whatever it is.
struct VisitTable<V>(V);

impl<'de, V: Visitor<'de>> DeserializeSeed<'de> for VisitTable<V> {
    type Value = V::Value;
    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        deserializer.deserialize_map(self.0)
    }
}

impl JsonSchema for MeshValue {
    fn schema_name() -> Cow<'static, str> {
        "Mesh".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let builtin = generator.subschema_for::<Builtin>();
        json_schema!({
            "description": "A built-in mesh by its name, or with parameters, or a file.",
            "anyOf": [
                { "enum": Builtin::NAMES },
                { "type": "string", "description": "The name of one of the scene's meshes." },
                builtin,
                {
                    "type": "object", "required": ["file"], "additionalProperties": false,
                    "properties": { "file": {
                        "type": "string",
                        "description": "A glTF, GLB, OBJ, PLY or STL file, relative to the scene file.",
                    } },
                },
            ]
        })
    }
}
