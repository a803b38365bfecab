//! Meshes that are given by their vertices.

use std::ops::Range;

use glam::{Vec2, Vec3, Vec4};

use crate::Mesh;
use crate::builtin::Builtin;
use crate::file::build::builder::{Builder, in_order};
use crate::file::error::Problem;
use crate::file::tables::geometry::meshes::{AttributeName, MeshDataTable, MeshTable};
use crate::file::tables::geometry::objects::MeshValue;
use crate::file::tables::scene::SceneTable;
use crate::file::tables::values::Number;

impl Builder {
    pub(in crate::file::build) fn named_meshes(&mut self, table: &SceneTable) -> Result<(), Problem> {
        for (name, mesh) in in_order(&table.meshes) {
            if Builtin::named(name).is_some() {
                let message = format!("'{name}' is the name of a built-in mesh: call this one otherwise");
                return Err(Problem::at(&mesh.span, message));
            }
            let built = mesh.build(name, &mesh.span, self)?;
            self.names.meshes.insert(name.clone(), self.scene.meshes.len());
            self.scene.meshes.push(built);
        }
        Ok(())
    }
}

fn vec2(values: &Option<Vec<[Number; 2]>>) -> Vec<Vec2> {
    values.iter().flatten().map(|v| Vec2::from_array(v.map(|n| n.0 as f32))).collect()
}

fn vec3(list: &Option<Vec<[Number; 3]>>) -> Vec<Vec3> {
    list.iter().flatten().map(|v| Vec3::from_array(v.map(|n| n.0 as f32))).collect()
}

fn vec4(list: &Option<Vec<[Number; 4]>>) -> Vec<Vec4> {
    list.iter().flatten().map(|v| Vec4::from_array(v.map(|n| n.0 as f32))).collect()
}

impl MeshTable {
    /// The mesh; `key` is the name of its table, and `span` where that stands.
    pub(crate) fn build(
        &self,
        key: &str,
        span: &Range<usize>,
        builder: &mut Builder,
    ) -> Result<Mesh, Problem> {
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
            uvs: vec2(&self.uvs),
            uvs2: vec2(&self.uvs2),
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
                AttributeName::Uvs2 => mesh.uvs2 = vectors(&words, Vec2::from_array),
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
