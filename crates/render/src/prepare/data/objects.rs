//! Objects: which clusters, which material, and what flat shading and scanline interpolation need.

use std::sync::Arc;

use glanz_scene::{Interpolation, Shading};

/// Which attributes the vertices of an object have beside position and normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// Texture coordinates.
    pub uv: bool,
    /// A second set of them.
    pub uv2: bool,
    /// Colours.
    pub color: bool,
    /// Tangents.
    pub tangent: bool,
}

/// An object of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct PreparedObject {
    /// Index in [`Prepared::materials`](super::Prepared::materials).
    pub material: usize,
    /// Where the illumination model is evaluated.
    pub shading: Shading,
    /// How values between vertices are found.
    pub interpolation: Interpolation,
    /// Index in [`Prepared::programs`](super::Prepared::programs) of what draws it in place of its material.
    pub program: Option<usize>,
    /// From the mesh to the world, column by column.
    pub placement: [[f64; 4]; 4],
    /// The point of the world that vertex positions are relative to.
    pub anchor: [f64; 3],
    /// Corners of the box around the vertices, relative to the anchor.
    pub bounds: [[f64; 3]; 2],
    /// Whether the mesh is a closed surface seen from outside, so that back faces are never seen
    /// while the eye is outside its box.
    pub closed: bool,
    /// Range of [`Geometry::clusters`](super::Geometry::clusters).
    pub clusters: core::ops::Range<usize>,
    /// Which attributes its vertices have.
    pub attributes: Attributes,
    /// Number of the object's first facet among all facets.
    pub first_facet: u32,
    /// Facet centroids and normals, where shading is flat.
    pub facets: Option<Arc<Facets>>,
    /// Whole polygons, where interpolation follows scanlines.
    pub polygons: Option<Arc<Polygons>>,
}

/// Centroids, normals and attribute means of an object's facets.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facets {
    /// Area centroids, relative to the object's anchor.
    pub centroids: Vec<[f32; 3]>,
    /// Unit normals in the world; null for facets without area.
    pub normals: Vec<[f32; 3]>,
    /// Vertex colours at the centroid; empty if the mesh has none.
    pub colors: Vec<[f32; 4]>,
}

/// The corners of an object's facets, in order.
#[derive(Clone, Debug, Default, PartialEq)]
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
    /// The corners of a facet.
    pub fn corners(&self, facet: u32) -> core::ops::Range<usize> {
        self.starts[facet as usize] as usize..self.starts[facet as usize + 1] as usize
    }
}
