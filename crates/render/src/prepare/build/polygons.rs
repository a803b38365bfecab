//! What scanline interpolation needs: whole polygons.

use glam::Vec3;
use glanz_scene::Mesh;

use crate::prepare::build::facets::uv;
use crate::prepare::build::geometry::Placed;

/// The corners of an object's facets, in order.
#[derive(Clone, Debug, Default)]
pub struct Polygons {
    /// Where each facet's corners begin, with a last entry for the end.
    pub starts: Vec<u32>,
    /// Positions relative to the object's anchor.
    pub positions: Vec<[f32; 3]>,
    /// Normals in the world, not normalised.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates.
    pub uvs: Vec<[f32; 2]>,
    /// Vertex colours.
    pub colors: Vec<[f32; 4]>,
}

impl Polygons {
    pub(crate) fn new(mesh: &Mesh, placed: &Placed) -> Self {
        let mut polygons = Self { starts: vec![0], ..Self::default() };
        for face in mesh.faces() {
            for &corner in face {
                let vertex = corner as usize;
                let normal = mesh.normals.get(vertex).copied().unwrap_or(Vec3::ZERO);
                polygons.positions.push(placed.position(mesh.positions[vertex]).as_vec3().to_array());
                polygons.normals.push(placed.normal(normal).as_vec3().to_array());
                polygons.uvs.push(uv(mesh, corner).to_array());
                polygons.colors.push(mesh.colors.get(vertex).map_or([1.0; 4], |c| c.to_array()));
            }
            polygons.starts.push(polygons.positions.len() as u32);
        }
        polygons
    }

    /// The corners of a facet.
    pub fn corners(&self, facet: u32) -> core::ops::Range<usize> {
        self.starts[facet as usize] as usize..self.starts[facet as usize + 1] as usize
    }
}
