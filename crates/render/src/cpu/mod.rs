//! The rasteriser: deferred tiles, sixteen pixels at a time.
//!
//! A frame goes through two passes, each parallel:
//!
//! 1. `geometry`: clusters are culled, their vertices projected, triangles culled sixteen at a time
//!    and put into the bins of the tiles that they touch (`bins`; `clip` for those that reach behind
//!    the eye).
//! 2. `tile`: visibility first (`raster`: which triangle is nearest at each sample), then the visible
//!    triangles are set up for interpolation (`records`), and sixteen neighbouring pixels at a time are
//!    interpolated and shaded (`group`, `reflect`), blended (`blend`) and developed.
//!
//! Nothing depends on the number of threads or the order of triangles: of two surfaces at the same
//! depth the one with the smaller number is seen.

mod bins;
mod blend;
mod clip;
mod eye;
mod frame;
mod geometry;
mod gouraud;
mod group;
mod polygons;
mod raster;
mod records;
mod reflect;
mod renderer;
mod runs;
mod samples;
mod show;
mod target;
mod texturing;
mod tile;

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
