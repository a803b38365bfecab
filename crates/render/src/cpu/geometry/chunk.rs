//! What the first pass makes of a run of clusters.

use crate::cpu::geometry::bins::Bins;
use crate::cpu::geometry::clip::ClippedTriangle;
use crate::cpu::geometry::micro_triangles::MicroSample;

/// What a run of clusters becomes. Kept between frames, for its memory.
#[derive(Debug, Default)]
pub(crate) struct ChunkOutput {
    /// Opaque and masked triangles.
    pub solid: Bins<u32>,
    /// Samples that tiny opaque triangles cover, where there is one sample per pixel.
    pub points: Bins<MicroSample>,
    /// Blended triangles.
    pub blended: Bins<u32>,
    /// Triangles that clipping made.
    pub clipped_triangles: Vec<ClippedTriangle>,
}

/// Fixed-point positions of a cluster's vertices, and which of them need clipping.
pub(crate) struct Local {
    pub at: [[i32; 2]; 256],
    /// One bit for each, sixteen to a row.
    pub outside: [u16; 16],
    /// Places in clip space, where a program says where vertices are.
    pub clip: Vec<[f32; 4]>,
}
