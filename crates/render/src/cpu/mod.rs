//! The CPU back end: deferred tiles, sixteen pixels at a time.
//!
//! A frame goes through two passes, each parallel:
//!
//! 1. `geometry`: clusters are culled and their vertices projected; triangles are culled sixteen at a time and put
//!    into the bins of the tiles that they touch. Those that reach behind the camera are clipped; of those of a few
//!    samples only the covered samples go on.
//! 2. `tile`: `visibility` first (which triangle is nearest at each sample), then the visible triangles are set up
//!    for interpolation and blocks of sixteen pixels are interpolated and shaded (`shading`), lit (`lighting`),
//!    and developed while they are in registers, or added up from several samples and blended surfaces.
//!
//! Nothing depends on the number of threads or the order of triangles: of two surfaces at the same depth the one
//! with the smaller number is seen.

mod block;
mod frame;
mod geometry;
mod lighting;
mod renderer;
mod shading;
mod threads;
mod tile;
mod visibility;

pub use renderer::Renderer;
