//! What the vertices of a mesh give a program.

use glanz_shader::{Port, Role};

use crate::prepare::{Geometry, PreparedObject};

/// The way from an object's vertices, as they are prepared, to the attributes of its mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshAttributes {
    /// Rows: from vertices relative to the anchor to the mesh's own places.
    to_mesh: [[f32; 4]; 3],
    /// The transpose of the linear part of the placement: from normals in the world to those of the mesh.
    normal_to_mesh: [[f32; 3]; 3],
}

impl MeshAttributes {
    /// Those of an object.
    pub fn new(object: &PreparedObject) -> Self {
        let placement = glam::DMat4::from_cols_array_2d(&object.placement);
        let anchor = glam::DMat4::from_translation(glam::DVec3::from_array(object.anchor));
        let to_mesh = (placement.inverse() * anchor).transpose();
        Self {
            to_mesh: [to_mesh.x_axis, to_mesh.y_axis, to_mesh.z_axis].map(|row| row.as_vec4().to_array()),
            // The columns are the rows of the transpose.
            normal_to_mesh: glam::DMat3::from_mat4(placement).as_mat3().to_cols_array_2d(),
        }
    }

    /// A component of an input of a vertex shader, by [`Port::role`]; 0 for inputs that stand for nothing. Whole numbers
    /// are the bits of the float.
    pub fn of(&self, port: &Port, component: usize, geometry: &Geometry, vertex: usize) -> f32 {
        if port.builtin {
            let source = geometry.sources.get(vertex).copied().unwrap_or(0);
            return if port.name == "gl_VertexID" { f32::from_bits(source) } else { 0.0 };
        }
        let of_three = |v: [f32; 3], fourth: f32| if component < 3 { v[component] } else { fourth };
        let normal = || geometry.normals[vertex];
        let tangent = || geometry.tangents.get(vertex).copied().unwrap_or_default();
        match port.role {
            Some(Role::Position) => {
                let at = geometry.position.each_ref().map(|axis| axis[vertex]);
                let own = self.to_mesh.map(|row| row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3]);
                of_three(own, 1.0)
            }
            Some(Role::Normal) => {
                let [nx, ny, nz] = normal();
                let own = self.normal_to_mesh.map(|column| column[0] * nx + column[1] * ny + column[2] * nz);
                of_three(own, 0.0)
            }
            Some(Role::TexCoord) => {
                let [u, v] = geometry.uvs.get(vertex).copied().unwrap_or_default();
                [u, v, 0.0, 1.0][component.min(3)]
            }
            Some(Role::Color) => geometry.colors.get(vertex).copied().unwrap_or([1.0; 4])[component.min(3)],
            Some(Role::Tangent) => {
                let [x, y, z, sign] = tangent();
                of_three([x, y, z], sign)
            }
            Some(Role::Bitangent) => {
                let [x, y, z, sign] = tangent();
                let (normal, tangent) = (glam::Vec3::from(normal()), glam::Vec3::new(x, y, z));
                of_three((normal.cross(tangent).normalize_or_zero() * sign).to_array(), 0.0)
            }
            _ => 0.0,
        }
    }
}
