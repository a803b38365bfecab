//! What flat shading needs: one point and one normal per facet.

use glam::{DVec3, Vec2, Vec4};
use glanz_scene::Mesh;

use super::placed::Placed;
use crate::prepare::data::Facets;

/// Those of a mesh in the world.
pub(crate) fn facets(mesh: &Mesh, placed: &Placed) -> Facets {
    let mut facets = Facets::default();
    for face in mesh.faces() {
        let facet = Facet::of(mesh, placed, face);
        let sign = if placed.mirrored { -1.0 } else { 1.0 };
        facets.centroids.push(facet.centroid.as_vec3().to_array());
        facets.normals.push((facet.area_normal * sign).normalize_or_zero().as_vec3().to_array());
        if !mesh.colors.is_empty() {
            facets.colors.push(facet.color.to_array());
        }
    }
    facets
}

struct Facet {
    centroid: DVec3,
    area_normal: DVec3,
    color: Vec4,
}

impl Facet {
    /// Means over the triangles of the fan, each weighted with its signed area.
    fn of(mesh: &Mesh, placed: &Placed, face: &[u32]) -> Self {
        let at = |corner: u32| placed.position(mesh.positions[corner as usize]);
        let color = |corner: u32| mesh.colors.get(corner as usize).copied().unwrap_or(Vec4::ONE);
        let fan = || (2..face.len()).map(|i| [face[0], face[i - 1], face[i]]);
        let area = |t: [u32; 3]| (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
        let area_normal: DVec3 = fan().map(area).sum();
        let direction = area_normal.normalize_or_zero();
        let total: f64 = fan().map(|t| area(t).dot(direction)).sum();
        if total <= 0.0 {
            let count = face.len().max(1) as f64;
            return Self {
                centroid: face.iter().map(|&c| at(c)).sum::<DVec3>() / count,
                area_normal: DVec3::ZERO,
                color: face.iter().map(|&c| color(c)).sum::<Vec4>() / count as f32,
            };
        }
        let weight = |t: [u32; 3]| area(t).dot(direction) / (3.0 * total);
        Self {
            centroid: fan().map(|t| t.iter().map(|&c| at(c)).sum::<DVec3>() * weight(t)).sum(),
            area_normal,
            color: fan().map(|t| t.iter().map(|&c| color(c)).sum::<Vec4>() * weight(t) as f32).sum(),
        }
    }
}

/// Texture coordinates of a vertex, or none.
pub(crate) fn uv(mesh: &Mesh, vertex: u32) -> Vec2 {
    mesh.uvs.get(vertex as usize).copied().unwrap_or(Vec2::ZERO)
}
