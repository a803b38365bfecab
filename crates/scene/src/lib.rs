//! Scenes: meshes, materials, lights, cameras and settings, and the files that they come from.
//!
//! A [`Scene`] is plain data without caches, and serialises both ways. [`mod@file`] reads and writes scene
//! files, [`read`] reads models and pictures, [`library`] holds known materials and [`stage`] scenes made in code.
//! Everything that a back end needs for drawing is computed from a scene by `glanz-render`'s `prepare`.
//!
//! ```
//! use glanz_scene::{Light, Mesh, Scene, library};
//!
//! let mut scene = Scene::new()
//!     .with_mesh(Mesh::builtin("teapot")?, library::material("glaze-celadon")?)
//!     .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0; 3]).named("sun"));
//! scene.light_mut("sun")?.set_spectrum(glanz_color::light("D65")?);
//! scene.object_mut("teapot")?.set_position([0.0, 1.0, 0.0]);
//! assert!(scene.bounds().min.y > -1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod another_scale;
pub mod builtin;
mod camera;
mod color_mode;
mod exposure;
pub mod file;
pub mod library;
mod light;
mod material;
pub mod memory;
mod mesh;
mod mistake;
mod names;
mod open;
mod program;
pub mod read;
mod scene;
pub mod settings;
pub mod stage;

pub use another_scale::AnotherScale;
pub use builtin::{Builtin, BuiltinError};
pub use camera::{Camera, Projection, camera_named};
pub use color_mode::{COLOR_MODES, ColorMode, White};
pub use glam;
pub use light::{
    AreaShape, Attenuation, DefaultLights, EnvironmentMap, Light, LightColors, LightError, LightKind,
    Luminaire, Profile, Space, add_default_lights,
};
pub use material::{
    Absorption, AlphaMode, Boundary, ChannelUse, ClassicMaterial, Coat, CoatedBoundary, Film, LightColor,
    Lobe, Mask, Material, Metalness, Pane, ParameterError, Polarization, RoughnessMap, Texture,
    TextureChannel, TextureFilter, TextureUse, Tint, Transmittance, Wrap,
};
pub use mesh::{Bounds, Mesh, MeshError, Normals, SubdivideError};
pub use mistake::{Mistake, NoEffect};
pub use open::{OpenError, Opened, is_scene_file, open, open_str};
pub use program::{Program, ProgramText, UniformValue, cube_face_files};
pub use scene::{Key, LookupError, Object, Scene};
pub use settings::{
    Background, DebugView, Encoding, Image, Interpolation, Lighting, RenderSettings, Shading, ToneMap,
};
