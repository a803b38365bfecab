//! Differences between drawn frames of one scene, over the pixels that show a surface.
//!
//! [`Difference`] is the error of linear light and of display codes, [`DeltaE`] the colour difference ΔE00 per
//! pixel. Unlike a [`Pair`](super::Pair) of picture files, frames know where a surface is: the background counts
//! for nothing.

mod delta;
mod difference;

pub use delta::DeltaE;
pub use difference::{Developed, Difference};
