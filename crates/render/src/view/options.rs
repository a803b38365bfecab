//! What a frame shows, and how.

use glanz_scene::Background;

/// What a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DebugView {
    /// Light on surfaces.
    #[default]
    Shaded,
    /// Shading normals in the world, −1 … 1 as 0 … 1.
    Normals,
    /// Distance, near is bright.
    Depth,
    /// A colour per object.
    Ids,
    /// A colour per facet.
    Facets,
    /// The edges of the facets over the shaded picture.
    Wireframe,
    /// The ambient and emitted terms alone.
    Ambient,
    /// The diffuse terms alone.
    Diffuse,
    /// The specular terms alone.
    Specular,
    /// Texture coordinates as red and green.
    Uv,
    /// White where any light reaches the front of the surface.
    Lit,
}

impl DebugView {
    /// Whether the view shows light, in the channels of the observer; the others show red, green and blue.
    pub fn is_light(self) -> bool {
        matches!(self, Self::Shaded | Self::Ambient | Self::Diffuse | Self::Specular | Self::Wireframe)
    }
}

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
