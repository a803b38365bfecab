//! One tile: visibility, shading, and what comes of it in the picture.

pub(crate) mod block_pair;
pub(crate) mod draw;
pub(crate) mod multi_sample;
pub(crate) mod single_sample;
pub(crate) mod state;
pub(crate) mod target;
pub(crate) mod transparency;
