//! The rasteriser: deferred tiles, sixteen pixels at a time.
//!
//! A frame goes through two passes, each parallel:
//!
//! 1. `geometry`: clusters are culled and their vertices projected; `sort`: triangles are culled sixteen
//!    at a time and put into the bins of the tiles that they touch (`bins`; `clip` for those that reach
//!    behind the eye; `points` for those of a few samples, of which only the samples go on).
//! 2. `tile`: visibility first (`visible`, `raster`: which triangle is nearest at each sample), then the
//!    visible triangles are set up for interpolation (`records`; `dust` where there are many), and blocks
//!    of sixteen pixels are interpolated, shaded (`group`, `reflect`) and developed while they are in
//!    registers (`solid`), or added up from several samples (`layered`) and blended surfaces (`blend`).
//!
//! Nothing depends on the number of threads or the order of triangles: of two surfaces at the same
//! depth the one with the smaller number is seen.

mod background;
mod bins;
mod block;
mod camera;
mod clip;
mod coverage_layers;
mod debug_view;
mod frame;
mod general;
mod geometry;
mod gouraud;
mod lights;
mod micro_triangles;
mod multi_sample;
mod polygons;
mod raster;
mod reflect;
mod renderer;
mod samples;
mod shade_block;
mod single_sample;
mod sort;
mod target;
mod texturing;
mod tile;
mod transparency;
mod triangle_batch;
mod triangle_setup;
mod visible;

pub(crate) use reflect::is_evaluated_in_place;
pub use renderer::Renderer;

/// The closure itself: a place where `#[inline(always)]` may stand on a closure that has a name.
///
/// Code below a SIMD dispatch must be inlined into it, closures too, or it runs without the level's
/// instructions; the language allows the attribute on arguments but not on the value of a `let`.
#[inline(always)]
fn inlined<F>(closure: F) -> F {
    closure
}

/// `values.map(f)`, surely inlined: the standard `map` is a call below a SIMD dispatch.
#[inline(always)]
fn three<T, U>([a, b, c]: [T; 3], f: impl Fn(T) -> U) -> [U; 3] {
    [f(a), f(b), f(c)]
}

/// Nine values, surely inlined and unrolled.
#[inline(always)]
fn nine<T>(f: impl Fn(usize) -> T) -> [T; 9] {
    [f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7), f(8)]
}
