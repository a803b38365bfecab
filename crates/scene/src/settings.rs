//! What a scene says about its picture: size, shading, view, exposure and tone mapping.
//!
//! ```
//! use glanz_scene::{DebugView, Interpolation, Shading};
//!
//! assert_eq!("gouraud".parse::<Shading>()?, Shading::Gouraud);
//! assert_eq!(Shading::default().name(), "phong");
//! assert_eq!(Interpolation::ALL.len(), 3);
//! assert!("fong".parse::<Shading>().unwrap_err().starts_with("expected one of flat, gouraud, phong"));
//! # Ok::<(), String>(())
//! ```

use glanz_color::Rgb;
pub use glanz_color::{Encoding, ToneMap};
use serde::{Deserialize, Serialize};

use crate::names::names;
use crate::{ColorMode, Mistake, White};

names! {
    /// Where the illumination model is evaluated, and what is interpolated.
    pub Shading {
        /// Once per facet: at its centroid, with its own normal.
        Flat = "flat",
        /// At the vertices; values are interpolated.
        Gouraud = "gouraud",
        /// At each pixel, with the interpolated normal.
        Phong = "phong",
    } default Phong
}

names! {
    /// How values between vertices are found.
    pub Interpolation {
        /// Linear on the surface in space: right under perspective.
        Perspective = "perspective",
        /// Linear on the screen, over triangles.
        ScreenLinear = "screen-linear",
        /// The scheme of 1971: along the edges of the whole polygon, then along the scanline.
        Scanline = "scanline",
    } default Perspective
}

names! {
    /// How light from areas and environments is found.
    pub Lighting {
        /// By what is prepared for each lobe: fast, with the errors that are stated.
        Fast = "fast",
        /// By points in the lights and in the lobes: slow, as exact as there are points.
        Exact = "exact",
    } default Fast
}

names! {
    /// What a picture shows.
    pub DebugView {
        /// Light on surfaces.
        Shaded = "shaded",
        /// Shading normals in the world, −1 … 1 as 0 … 1.
        Normals = "normals",
        /// Distance, near is bright.
        Depth = "depth",
        /// A colour per object.
        Ids = "ids",
        /// A colour per facet.
        Facets = "facets",
        /// The edges of the facets over the shaded picture.
        Wireframe = "wireframe",
        /// The ambient and emitted terms alone.
        Ambient = "ambient",
        /// The diffuse terms alone.
        Diffuse = "diffuse",
        /// The specular terms alone.
        Specular = "specular",
        /// Texture coordinates as red and green.
        Uv = "uv",
        /// White where any light reaches the front of the surface.
        Lit = "lit",
    } default Shaded
}

impl DebugView {
    /// Whether the view shows light, in the channels of the observer; the others show red, green and blue.
    pub const fn is_light(self) -> bool {
        matches!(self, Self::Shaded | Self::Ambient | Self::Diffuse | Self::Specular | Self::Wireframe)
    }
}

/// The background of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Background {
    /// A linear colour.
    Color(Rgb),
    /// Transparent: alpha 0.
    Transparent,
    /// The first light of the scene that is an environment.
    Environment,
}

/// The picture to be made.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Image {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Coverage samples per pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// What is shown beside the objects.
    pub background: Background,
}

impl Default for Image {
    fn default() -> Self {
        Self {
            width: 800,
            height: 600,
            samples: 4,
            supersample: false,
            background: Background::Color(Rgb([0.05, 0.05, 0.08])),
        }
    }
}

/// How to draw what does not say otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RenderSettings {
    /// For objects that name none.
    pub shading: Shading,
    /// For objects that name none.
    pub interpolation: Interpolation,
    /// What the picture shows.
    pub show: DebugView,
    /// How light is compressed to the display's range.
    pub tone_map: ToneMap,
    /// Exposure in stops.
    pub ev: f64,
    /// How light becomes the codes of a picture.
    #[serde(default, skip_serializing_if = "is_default")]
    pub encoding: Encoding,
    /// How colour is treated.
    pub mode: ColorMode,
    /// The white that becomes the screen's.
    pub white: White,
    /// Whether surfaces stand in each other's light. The classic models know no shadows.
    pub shadows: bool,
    /// How light from areas and environments is found.
    #[serde(default, skip_serializing_if = "is_default")]
    pub lighting: Lighting,
    /// Points of each such light, of each lobe and of the hemisphere at each pixel, if it is found by points; 1024 where
    /// nothing is said.
    #[serde(default, skip_serializing_if = "is_default")]
    pub light_samples: Option<u32>,
    /// A mistake to be drawn on purpose.
    #[serde(default, skip_serializing_if = "is_default")]
    pub mistake: Option<Mistake>,
}

/// For settings that scenes mostly do not have: they leave the hash of others as it is.
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
