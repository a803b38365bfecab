//! The vertices and triangles of an object on the device.

use glanz_render::prepare::{Geometry, PreparedObject};
use glanz_render::view::program::MeshAttributes;
use glanz_shader::Port;
use glanz_shader::gpu::GpuAttribute;

use crate::device::Device;

/// An object's mesh, as the vertex shader of its program takes it.
pub(crate) struct Mesh {
    pub(crate) vertices: wgpu::Buffer,
    pub(crate) indices: wgpu::Buffer,
    pub(crate) count: u32,
}

impl Mesh {
    pub(crate) fn new(
        device: &Device,
        geometry: &Geometry,
        object: &PreparedObject,
        attributes: &[GpuAttribute],
        inputs: &[Port],
    ) -> Self {
        let clusters = &geometry.clusters[object.clusters.clone()];
        let first = clusters.first().map_or(0, |cluster| cluster.first_vertex);
        let end = clusters.last().map_or(0, |cluster| cluster.first_vertex + cluster.vertices);
        let mesh = MeshAttributes::new(object);
        let mut vertices = Vec::new();
        for vertex in first as usize..end as usize {
            for attribute in attributes {
                let rows = attribute.ty.rows;
                for component in attribute.column * rows..(attribute.column + 1) * rows {
                    let value = mesh.of(&inputs[attribute.input], component, geometry, vertex);
                    vertices.extend(value.to_bits().to_le_bytes());
                }
            }
        }
        let mut indices = Vec::new();
        for cluster in clusters {
            let triangles =
                cluster.first_triangle as usize..(cluster.first_triangle + cluster.triangles) as usize;
            for [a, b, c] in &geometry.triangles[triangles] {
                // What is flat is that of the last vertex on the CPU and in OpenGL, that of the first one elsewhere.
                let corners = if device.info.api == "opengl" { [a, b, c] } else { [c, a, b] };
                for corner in corners {
                    let index = cluster.first_vertex - first + u32::from(*corner);
                    indices.extend(index.to_le_bytes());
                }
            }
        }
        Self {
            count: (indices.len() / 4) as u32,
            vertices: device.buffer("vertices", wgpu::BufferUsages::VERTEX, &vertices),
            indices: device.buffer("triangles", wgpu::BufferUsages::INDEX, &indices),
        }
    }
}
