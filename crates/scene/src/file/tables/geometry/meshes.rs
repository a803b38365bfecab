//! Meshes that are given by their vertices.

use schemars::JsonSchema;
use serde::Deserialize;

use super::objects::MeshValue;
use crate::file::tables::values::{At, Number};
use crate::names::names;

/// A mesh that objects call by its name: a built-in one, or vertices and faces, here or in a file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshTable {
    /// A name for people; that of the table by default.
    pub name: Option<String>,
    /// A built-in mesh.
    pub mesh: Option<At<MeshValue>>,
    /// Positions of the vertices.
    pub positions: Option<Vec<[Number; 3]>>,
    /// Unit normals of the vertices.
    pub normals: Option<Vec<[Number; 3]>>,
    /// Texture coordinates of the vertices, v downwards.
    pub uvs: Option<Vec<[Number; 2]>>,
    /// A second set of texture coordinates, for textures with `uv_set = 1`.
    pub uvs2: Option<Vec<[Number; 2]>>,
    /// Unit tangents along +u; the fourth number is the sign of the bitangent.
    pub tangents: Option<Vec<[Number; 4]>>,
    /// Linear RGB and alpha of the vertices.
    pub colors: Option<Vec<[Number; 4]>>,
    /// The triangles: numbers of their vertices from 0, counter-clockwise seen from outside.
    pub triangles: Option<Vec<[u32; 3]>>,
    /// Polygons in place of triangles.
    pub faces: Option<Vec<Vec<u32>>>,
    /// Vertices and faces in a binary file, in place of all of these.
    pub data: Option<At<MeshDataTable>>,
}

/// A file of little-endian 32-bit numbers, one array after the other: positions, the `attributes` in their order,
/// the vertices of all corners of the faces, and where the faces begin.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshDataTable {
    /// The file, relative to the scene file.
    pub file: At<String>,
    /// How many vertices there are.
    pub vertices: u32,
    /// How many corners the faces have in all.
    pub corners: u32,
    /// How many numbers tell where faces begin, with a last one for the end; 0 for triangles.
    #[serde(default)]
    pub face_starts: u32,
    /// What the vertices have beside positions.
    #[serde(default)]
    pub attributes: Vec<AttributeName>,
}

names! {
    /// What vertices have beside positions.
    pub(crate) AttributeName {
        /// Three floats.
        Normals = "normals",
        /// Two floats.
        Uvs = "uvs",
        /// Two floats.
        Uvs2 = "uvs2",
        /// Four floats.
        Tangents = "tangents",
        /// Four floats.
        Colors = "colors",
    } default Normals
}

impl AttributeName {
    /// Floats of a vertex.
    pub(crate) fn floats(self) -> usize {
        match self {
            Self::Normals => 3,
            Self::Uvs | Self::Uvs2 => 2,
            Self::Tangents | Self::Colors => 4,
        }
    }
}
