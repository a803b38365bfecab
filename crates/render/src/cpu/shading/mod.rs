//! From visible triangles to colours: setup, interpolation, textures, vertex lighting, debug views.

pub(crate) mod background;
pub(crate) mod debug_view;
pub(crate) mod gouraud;
pub(crate) mod polygons;
pub(crate) mod shade;
pub(crate) mod shade_block;
pub(crate) mod surface;
pub(crate) mod texturing;
pub(crate) mod triangle_batch;
pub(crate) mod triangle_setup;
