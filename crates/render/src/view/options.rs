//! What a frame shows, and how.

use glanz_scene::Background;
pub use glanz_scene::DebugView;

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawOptions {
    /// Coverage samples per pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// What the picture shows.
    pub show: DebugView,
    /// What is behind all surfaces.
    pub background: Background,
    /// Planes beside colour and alpha.
    pub aovs: Aovs,
}

impl DrawOptions {
    /// One sample, shaded, on this background.
    pub fn new(background: Background) -> Self {
        Self { samples: 1, supersample: false, show: DebugView::Shaded, background, aovs: Aovs::default() }
    }
}
