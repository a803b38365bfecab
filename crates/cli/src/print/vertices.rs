//! The vertices and facets of a mesh as tables, as they go into vertex buffers.

use std::fmt::Write;

use glanz_math::names::shown;
use glanz_plot::number;
use glanz_scene::{Mesh, Normals};
use schemars::JsonSchema;
use serde::Serialize;

/// The most rows that are printed for people; JSON has all.
const MOST_ROWS: usize = 200;

/// The vertices and facets of a mesh.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct VertexTables {
    vertices: Vec<VertexFacts>,
    facets: Vec<FacetFacts>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct VertexFacts {
    position: [f32; 3],
    /// As it is drawn: the mesh's own, or the mean over the facets around it
    normal: [f32; 3],
    /// Linear red, green, blue and alpha; null where the mesh has no colours
    color: Option<[f32; 4]>,
    /// null where the mesh has no texture coordinates
    uv: Option<[f32; 2]>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct FacetFacts {
    /// Numbers in vertices, from 0, counter-clockwise seen from the front
    vertices: Vec<u32>,
    /// By the cross product of its edges
    normal: [f64; 3],
}

impl VertexTables {
    /// Those of a mesh.
    pub(super) fn of(mesh: &Mesh) -> Self {
        let drawn = match mesh.normals.is_empty() {
            true => mesh.clone().with_normals(Normals::Given),
            false => mesh.clone(),
        };
        let vertex = |i: usize| VertexFacts {
            position: drawn.positions[i].to_array(),
            normal: drawn.normals[i].to_array(),
            color: drawn.colors.get(i).map(|color| color.to_array()),
            uv: drawn.uvs.get(i).map(|uv| uv.to_array()),
        };
        let facet = |face: usize| FacetFacts {
            vertices: drawn.face(face).to_vec(),
            normal: drawn.face_normal(face).to_array(),
        };
        Self {
            vertices: (0..drawn.positions.len()).map(vertex).collect(),
            facets: (0..drawn.face_count()).map(facet).collect(),
        }
    }
}

/// The two tables of a mesh for people.
pub(super) fn tables(mesh: &Mesh) -> String {
    let tables = VertexTables::of(mesh);
    let name = if mesh.name.is_empty() { "(unnamed)" } else { &*shown(&mesh.name) };
    let vertices = tables.vertices.iter().map(|vertex| {
        let color = vertex.color.map(|color| format!("  color {}", list(&color))).unwrap_or_default();
        let uv = vertex.uv.map(|uv| format!("  uv {}", list(&uv))).unwrap_or_default();
        format!("{:<28} normal {:<28}{color}{uv}", list(&vertex.position), list(&vertex.normal))
    });
    let facets = tables.facets.iter().map(|facet| {
        let corners = facet.vertices.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
        format!("{corners:<28} normal ({})", facet.normal.map(number).join(", "))
    });
    table(&format!("vertices of {name}"), vertices) + &table(&format!("facets of {name}"), facets)
}

/// A title and numbered rows.
fn table(title: &str, rows: impl ExactSizeIterator<Item = String>) -> String {
    let count = rows.len();
    let mut text = format!("  {title}: {count}\n");
    for (i, row) in rows.enumerate().take(MOST_ROWS) {
        writeln!(text, "    {i:>3}  {}", row.trim_end()).expect("a string takes everything");
    }
    if count > MOST_ROWS {
        writeln!(text, "    and {} more; --format json lists all", count - MOST_ROWS)
            .expect("a string takes everything");
    }
    text
}

fn list(values: &[f32]) -> String {
    format!("({})", values.iter().map(|value| number(f64::from(*value))).collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normals_of_facets_are_those_of_the_cross_product() {
        let kite = Mesh::builtin("kite").unwrap();
        let tables = VertexTables::of(&kite);
        assert_eq!((tables.vertices.len(), tables.facets.len()), (kite.positions.len(), 2));
        for facet in &tables.facets {
            let [a, b, c] = [0, 1, 2].map(|i| kite.positions[facet.vertices[i] as usize].as_dvec3());
            let cross = (b - a).cross(c - a).normalize();
            assert!((cross - glam::DVec3::from_array(facet.normal)).length() < 1e-12);
        }
        assert!(tables.vertices.iter().all(|vertex| vertex.color.is_some()));
        let long = Mesh::builtin("sphere").unwrap();
        assert!(super::tables(&long).contains("more; --format json lists all"));
    }
}
