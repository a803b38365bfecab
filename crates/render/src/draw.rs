//! Drawing: from prepared arrays and a view to a frame.

use glanz_math::simd_level;
use glanz_scene::Background;
pub use glanz_scene::DebugView;

use crate::cpu::Renderer;
use crate::{Develop, Frame, Prepared, View};

/// Which planes a frame has beside colour and alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Aovs {
    /// Distance from the eye plane.
    pub depth: bool,
    /// Shading normals.
    pub normal: bool,
    /// Object numbers.
    pub object: bool,
}

/// How to draw.
#[derive(Clone, Copy, Debug)]
pub struct DrawOptions {
    /// Coverage samples per pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// What the picture shows.
    pub show: DebugView,
    /// Where nothing is.
    pub background: Background,
    /// Planes beside colour and alpha.
    pub aovs: Aovs,
    /// SIMD instructions to use, from [`glanz_math::simd_level`]. The picture does not depend on it.
    pub level: fearless_simd::Level,
}

impl DrawOptions {
    /// One sample, shaded, on this background, with the machine's best instructions.
    pub fn new(background: Background) -> Self {
        Self {
            samples: 1,
            supersample: false,
            show: DebugView::Shaded,
            background,
            aovs: Aovs::default(),
            level: simd_level(None).expect("the machine's own level exists"),
        }
    }
}

/// Draws into a frame of linear channels. Runs in the current rayon pool.
pub fn draw(prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
    Renderer::new().draw(prepared, view, options)
}

/// Draws and develops tile by tile, straight into 8-bit RGBA (`4·width·height` bytes, rows from the
/// top). The result is that of [`draw`] followed by [`develop()`](crate::develop()), without the
/// memory of a frame.
///
/// # Panics
/// If `out` has another length.
pub fn draw_rgba8(
    prepared: &Prepared,
    view: &View,
    options: &DrawOptions,
    develop: &Develop,
    out: &mut [u8],
) {
    Renderer::new().draw_rgba8(prepared, view, options, develop, out);
}
