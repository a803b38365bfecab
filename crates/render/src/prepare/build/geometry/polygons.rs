//! What scanline interpolation needs: whole polygons.

use glam::Vec3;
use glanz_scene::Mesh;

use super::facets::uv;
use super::placed::Placed;
use crate::prepare::data::Polygons;

/// Those of a mesh in the world.
pub(crate) fn polygons(mesh: &Mesh, placed: &Placed) -> Polygons {
    let mut polygons = Polygons { starts: vec![0], ..Polygons::default() };
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
