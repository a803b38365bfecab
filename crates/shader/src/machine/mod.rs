//! The machine: straight instructions over rows of 16 lanes, with neither `unsafe` nor bounds checks in its loop.
//!
//! A register holds one scalar of 16·G fragments; constants, uniforms and what follows from them alone lie in the same
//! file and are computed once per draw, by the same loop. Control flow is masks, which are values like all others, and
//! jumps where no lane goes a way. All numbers are `glanz_math`'s, so every SIMD level gives the same bits.

mod cube;
mod file;
mod numbers;
mod op;
mod run;
mod textures;

pub use cube::{CubePlace, panorama_place, turned};
pub use file::Row;
pub(crate) use file::{ROWS, RegisterFile};
pub(crate) use op::{Code, Op};
pub(crate) use run::{Host, OutOfFuel, Recorder, Silent, execute};
pub use textures::{Lod, NoTextures, TextureQuery, Textures, compared};
pub(crate) use textures::{Look, LookLod};
