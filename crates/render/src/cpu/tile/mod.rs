//! One tile: visibility, shading, and what comes of it in the picture.

pub(crate) mod draw;
pub(crate) mod multi_sample;
pub(crate) mod single_sample;
pub(crate) mod target;
pub(crate) mod transparency;
