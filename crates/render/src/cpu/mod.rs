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
//!
//! ```
//! use glanz_math::SimdLevel;
//! use glanz_render::cpu::Renderer;
//! use glanz_render::{Backend, DrawOptions, PrepareOptions, View, prepare};
//! use glanz_scene::{Background, Camera, Light, Material, Mesh, Scene};
//!
//! let scene = Scene::new()
//!     .with_mesh(Mesh::builtin("sphere")?, Material::default_gray())
//!     .with_light(Light::directional([0.0, 0.0, -1.0], [1.0; 3]));
//! let prepared = prepare(&scene, &PrepareOptions::default())?;
//! let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 32, 32)?;
//! let options = DrawOptions::new(Background::Transparent);
//! // The same bits with the narrowest vectors and with the best.
//! let [narrow, wide] = [SimdLevel::narrowest(), SimdLevel::best()]
//!     .map(|level| Renderer::with_level(level).draw(&prepared, &view, &options));
//! assert!(narrow.rgb == wide.rgb && narrow.alpha[16 * 32 + 16] == 1.0);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod block;
mod frame;
mod geometry;
mod lighting;
pub(crate) mod probe;
mod program;
pub(crate) use program::inspect;
pub(crate) use renderer::inspect_colors;
mod renderer;
mod shading;
mod threads;
mod tile;
mod visibility;

pub use renderer::Renderer;
