//! What there is to be seen: meshes, materials, lights, cameras, and the files that they come from.
//!
//! A [`Scene`] is plain data without caches. Everything that a drawing back end needs is computed
//! from it by `glanz-render`'s `prepare`.

pub mod builtin;
mod camera;
mod coat;
mod color_mode;
mod default_lights;
mod environment;
pub mod file;
pub mod library;
mod light;
mod luminaire;
mod material;
mod mesh;
mod normals;
pub mod read;
mod scene;
mod sheet;
mod subdivide;
mod tangents;
mod texture;
mod tint;
mod topology;

pub use builtin::{Builtin, BuiltinError};
pub use camera::{Camera, Projection};
pub use coat::Coat;
pub use color_mode::{COLOR_MODES, ColorMode, White};
pub use default_lights::add_default_lights;
pub use environment::EnvironmentMap;
pub use light::{AreaShape, Attenuation, Light, LightColors, LightKind, Space};
pub use luminaire::{Luminaire, Profile};
pub use material::{AlphaMode, ClassicMaterial, Lobe, Material, Metalness, TextureUse};
pub use mesh::{Bounds, Mesh, MeshError};
pub use normals::Normals;
pub use scene::{Background, Image, Interpolation, Object, RenderSettings, Scene, Shading};
pub use sheet::{Absorption, Film, Pane, Transmittance};
pub use subdivide::SubdivideError;
pub use texture::{Texture, TextureFilter, Wrap};
pub use tint::{LightColor, Polarization, Tint};
