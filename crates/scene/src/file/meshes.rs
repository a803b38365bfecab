//! Meshes of a scene file that are given by their vertices.

use std::ops::Range;

use glam::{Vec2, Vec3, Vec4};
use schemars::JsonSchema;
use serde::Deserialize;

use super::build::Builder;
use super::error::Problem;
use super::objects::MeshValue;
use super::values::{At, Number};
use crate::Mesh;
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
        /// Four floats.
        Tangents = "tangents",
        /// Four floats.
        Colors = "colors",
    } default Normals
}

impl AttributeName {
    /// Floats of a vertex.
    pub fn floats(self) -> usize {
        match self {
            Self::Normals => 3,
            Self::Uvs => 2,
            Self::Tangents | Self::Colors => 4,
        }
    }
}

fn vec3(list: &Option<Vec<[Number; 3]>>) -> Vec<Vec3> {
    list.iter().flatten().map(|v| Vec3::from_array(v.map(|n| n.0 as f32))).collect()
}

fn vec4(list: &Option<Vec<[Number; 4]>>) -> Vec<Vec4> {
    list.iter().flatten().map(|v| Vec4::from_array(v.map(|n| n.0 as f32))).collect()
}

impl MeshTable {
    /// The mesh; `key` is the name of its table, and `span` where that stands.
    pub fn build(&self, key: &str, span: &Range<usize>, builder: &mut Builder) -> Result<Mesh, Problem> {
        let inline = self.positions.is_some();
        let mut mesh = match (&self.mesh, inline, &self.data) {
            (Some(mesh), false, None) => match &mesh.value {
                MeshValue::Builtin(builtin) => {
                    builder.check_budget(builtin.triangle_count(), &mesh.span)?;
                    builtin.mesh().map_err(|error| Problem::at(&mesh.span, error.to_string()))?
                }
                _ => return Err(Problem::at(&mesh.span, "expected a built-in mesh")),
            },
            (None, true, None) => self.inline(),
            (None, false, Some(data)) => data.read(builder)?,
            _ => {
                let message = format!("[meshes.{key}] needs one of 'mesh', 'positions' and 'data'");
                return Err(Problem::at(span, message));
            }
        };
        mesh.name = self.name.clone().unwrap_or_else(|| key.to_owned());
        mesh.validate().map_err(|error| Problem::at(span, format!("mesh '{key}': {error}")))?;
        Ok(mesh)
    }

    fn inline(&self) -> Mesh {
        let mut mesh = Mesh {
            positions: vec3(&self.positions),
            normals: vec3(&self.normals),
            uvs: self.uvs.iter().flatten().map(|v| Vec2::from_array(v.map(|n| n.0 as f32))).collect(),
            tangents: vec4(&self.tangents),
            colors: vec4(&self.colors),
            corners: self.triangles.iter().flatten().flatten().copied().collect(),
            ..Mesh::default()
        };
        if let Some(faces) = &self.faces {
            mesh.corners = faces.iter().flatten().copied().collect();
            let mut end = 0;
            let ends = faces.iter().map(|face| {
                end += face.len() as u32;
                end
            });
            mesh.face_starts = std::iter::once(0).chain(ends).collect();
        }
        mesh
    }
}

impl MeshDataTable {
    fn read(&self, builder: &mut Builder) -> Result<Mesh, Problem> {
        let bytes = builder.read_beside(&self.file)?;
        let floats = 3 + self.attributes.iter().map(|name| name.floats()).sum::<usize>();
        let numbers =
            u64::from(self.vertices) * floats as u64 + u64::from(self.corners) + u64::from(self.face_starts);
        if bytes.len() as u64 != 4 * numbers {
            let found = bytes.len();
            let message = format!("expected {} bytes in '{}', found {found}", 4 * numbers, self.file.value);
            return Err(Problem::at(&self.file.span, message));
        }
        let mut words = bytes.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word));
        let mut take = |count: usize| words.by_ref().take(count).collect::<Vec<u32>>();
        let vertices = self.vertices as usize;
        let mut mesh = Mesh { positions: vectors(&take(3 * vertices), Vec3::from_array), ..Mesh::default() };
        for name in &self.attributes {
            let words = take(name.floats() * vertices);
            match name {
                AttributeName::Normals => mesh.normals = vectors(&words, Vec3::from_array),
                AttributeName::Uvs => mesh.uvs = vectors(&words, Vec2::from_array),
                AttributeName::Tangents => mesh.tangents = vectors(&words, Vec4::from_array),
                AttributeName::Colors => mesh.colors = vectors(&words, Vec4::from_array),
            }
        }
        mesh.corners = take(self.corners as usize);
        mesh.face_starts = take(self.face_starts as usize);
        Ok(mesh)
    }
}

fn vectors<T, const N: usize>(words: &[u32], vector: impl Fn([f32; N]) -> T) -> Vec<T> {
    words.as_chunks::<N>().0.iter().map(|words| vector(words.map(f32::from_bits))).collect()
}
