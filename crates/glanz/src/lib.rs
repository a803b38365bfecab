//! How does this material look, under this light, to this eye?
//!
//! This crate is the library Glanz: it re-exports the others under short names. The command `glanz` is the
//! package `glanz-cli`.
//!
//! | name | holds |
//! |---|---|
//! | [`math`] | numbers that run as f64, f32 and 16 lanes; vectors; quadrature |
//! | [`color`] | spectra, light sources, observers, surfaces, colour models and their differences |
//! | [`bsdf`] | the shapes of reflection lobes, from one list of models |
//! | [`picture`] | linear frames, development, picture files, comparison |
//! | [`plot`] | plots of lobes, spectra and colours, contact sheets: SVG, PNG, CSV |
//! | [`scene`] | meshes, materials, lights, cameras, scene files and readers of other formats |
//! | [`render`] | from a scene to linear channels: prepare, view, back ends |

pub use glanz_bsdf as bsdf;
pub use glanz_color as color;
pub use glanz_math as math;
pub use glanz_picture as picture;
pub use glanz_plot as plot;
pub use glanz_render as render;
pub use glanz_scene as scene;
