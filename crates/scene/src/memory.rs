//! What scenes take of memory, counted before it is taken.
//!
//! The figures hold for what is alive at the same time once the scene is drawn: the scene itself and what drawing makes of it.
//! docs/SCENE.md has the measurements.

use glanz_math::MemoryBudget;

use crate::builtin::MAX_TRIANGLES;

/// The least that a triangle takes: three numbers of vertices in the mesh and in its cluster, with its facet, and half a vertex in both.
/// Triangles that share no vertices take five times as much, which [`prepare`](../../glanz_render/prepare/index.html) counts.
pub const LEAST_TRIANGLE_BYTES: u64 = 48;

/// Refuses more triangles than can be drawn, or than there is memory for at the least; says why.
pub(crate) fn check_triangles(triangles: u64, memory: MemoryBudget) -> Result<(), String> {
    if triangles > MAX_TRIANGLES {
        let found = counted(triangles);
        return Err(format!(
            "expected at most {MAX_TRIANGLES} triangles in a scene, found {found} up to here"
        ));
    }
    let bytes = triangles * LEAST_TRIANGLE_BYTES;
    memory.check(format_args!("{triangles} triangles"), bytes).map_err(|over| over.to_string())
}

/// A number of triangles, where the greatest stands for all that cannot be counted.
pub(crate) fn counted(triangles: u64) -> String {
    if triangles == u64::MAX { "more than can be counted".to_owned() } else { triangles.to_string() }
}

/// What a decoded texture takes: four bytes for each texel, and four more for each texel of all its mip levels.
pub fn texture_bytes(width: u32, height: u32) -> u64 {
    let texels = u64::from(width) * u64::from(height);
    texels.saturating_mul(28).div_ceil(3)
}

/// What an environment takes: three floats for each pixel in the scene, as many where it is drawn, and a third of it for its coarser levels.
pub fn environment_bytes(width: usize, height: usize) -> u64 {
    (width as u64).saturating_mul(height as u64).saturating_mul(28)
}
