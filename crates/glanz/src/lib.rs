//! How does this material look, under this light, to this eye?
//!
//! Glanz draws surfaces by every local model of illumination, in linear RGB or in full spectra with fluorescence. A
//! [`Scene`] is what there is, a [`Shot`] one picture of it, a [`Session`] many of a scene that changes:
//!
//! ```standalone_crate
//! # let folder = std::env::temp_dir().join("glanz-doc-first");
//! # std::fs::create_dir_all(&folder)?;
//! # let text = std::fs::read_to_string("../../examples/ball.toml")?;
//! # let text = text.replace("materials.ball]", "materials.red]").replace("material = \"ball\"", "material = \"red\"");
//! # std::env::set_current_dir(&folder)?;
//! # std::fs::write("ball.toml", text)?;
//! use glanz::{Shot, color};
//!
//! let mut scene = glanz::load("ball.toml")?;
//! scene.material_mut("red")?.set("shininess", 64.0)?;
//! scene.light_mut(0)?.set_spectrum(color::light("A")?);
//! Shot::new(&scene)?.save("x.png")?;
//! # assert!(std::fs::read("x.png")?.starts_with(b"\x89PNG"));
//! # std::env::set_current_dir("..")?;
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), glanz::Error>(())
//! ```
//!
//! The picture is that of `glanz render`: mode, observer, white, samples and exposure are the scene's. Without a file:
//!
//! ```
//! use glanz::{Camera, Light, Mesh, Scene, Shot, scene::library};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, library::material("gold")?)
//!     .with_light(Light::directional([-1.0, -1.0, -1.0], [1.0, 0.9, 0.8]))
//!     .with_light(Light::environment([0.3, 0.3, 0.3]))
//!     .with_camera(Camera::new([0.0, 0.0, 5.0], [0.0, 0.0, 0.0]).with_fov_deg(30.0))
//!     .with_size(64, 64);
//! let frame = Shot::new(&scene)?.frame()?;
//! let [r, g, b, _] = frame.pixel(32, 32);
//! assert!(r > g && g > b);
//! # Ok::<(), glanz::Error>(())
//! ```
//!
//! Debug builds of a program draw many times faster with this in its `Cargo.toml`, by which Cargo optimises what the
//! program depends on:
//!
//! ```toml
//! [profile.dev.package."*"]
//! opt-level = 1
//! ```
//!
//! The crate re-exports the others under short names, and what most programs need at the top. The command `glanz` is the
//! package `glanz-cli`.
//!
//! | name | holds |
//! |---|---|
//! | [`math`] | numbers that run as f64, f32 and 16 lanes; vectors; quadrature |
//! | [`color`] | spectra, light sources, observers, surfaces, colour models and their differences |
//! | [`bsdf`] | the shapes of reflection lobes, from one list of models |
//! | [`picture`] | linear frames, development, picture files, comparison |
#![cfg_attr(
    feature = "plot",
    doc = "| [`plot`] | plots of lobes, spectra and colours, contact sheets: SVG, PNG, CSV |"
)]
//! | [`scene`] | meshes, materials, lights, cameras, scene files and readers of other formats |
//! | [`render`] | from a scene to linear channels: prepare, view, back ends |
//! | [`eye`] | eyes by age, field and deficiency; glare, dusk, acuity; their formulas |
//! | [`measure`] | measured reflectance: files, smoothing, fits, numbers of appearance |
//! | [`shader`] | GLSL and WGSL of users: programs, machines, traces, warnings |
#![cfg_attr(feature = "gpu", doc = "| [`gpu`] | a back end for programs on GPUs, and what GPUs there are |")]
//!
//! # Features
//!
//! | feature | adds |
//! |---|---|
//! | `rayon`, by default | threads |
//! | `exr` | OpenEXR: environment maps, spectral files, pictures of linear light and of spectra |
//! | `gif` | films as GIF; PNG and APNG need no feature |
//! | `plot` | the module `plot` |
//! | `gpu` | the module `gpu` |
//!
//! What needs a feature that is off ends in an error that names it.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod load;

pub use error::Error;
pub use load::{load, load_with_remarks, parse};

pub use glanz_bsdf as bsdf;
pub use glanz_color as color;
pub use glanz_eye as eye;
#[cfg(feature = "gpu")]
pub use glanz_gpu as gpu;
pub use glanz_math as math;
pub use glanz_measure as measure;
pub use glanz_picture as picture;
#[cfg(feature = "plot")]
pub use glanz_plot as plot;
pub use glanz_render as render;
pub use glanz_scene as scene;
pub use glanz_shader as shader;

pub use glanz_bsdf::Shape;
pub use glanz_color::{Observer, Rgb, Spectrum};
pub use glanz_picture::Frame;
pub use glanz_render::{Session, Shot, ShotOptions};
pub use glanz_scene::{Camera, ColorMode, Light, Lobe, Material, Mesh, Object, Scene, Tint, glam};

/// The example of the README is compiled as a test of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
