//! How far two pictures are apart: colour difference, error, structure, and what an eye sees.
//!
//! [`read_picture`] reads a PNG or an OpenEXR file into a [`Picture`] of linear light, a [`Pair`] holds two
//! of one size, [`Pair::measure`] gives a [`Measurement`]: numbers and a map with an error per pixel, which
//! [`heat_colors`] turns into colours. [`frames`] compares drawn frames instead of files.
//!
//! **Scales.** A picture from a PNG holds what a screen shows, one from an OpenEXR light without bounds. Two
//! of light are compared as light. A pair with a PNG in it is compared as a screen shows it: light is
//! clipped to 0 … 1 and encoded by the transfer of sRGB, not rounded ([`Scale`]).
//!
//! **Alpha.** Pictures are laid over black, in linear light: what shows nothing is black.
//!
//! **Memory.** A picture takes 12 bytes a pixel; what reading and metrics hold beside it is asked of a [`MemoryBudget`] first
//! ([`read_picture_within`], [`MetricOptions::memory`]).
//!
//! [`MemoryBudget`]: glanz_math::MemoryBudget
//!
//! Sums run in `f64` in the order of the rows, and all functions are those of `libm`, so numbers do not
//! depend on the machine or on the number of threads.
//!
//! ```
//! use glanz_picture::compare::{Metric, MetricOptions, Pair, Picture, Scale};
//!
//! let gray = |value: f32| {
//!     let rgb = [vec![value; 16], vec![value; 16], vec![value; 16]];
//!     Picture { width: 4, height: 4, rgb, scale: Scale::Light, notes: Vec::new() }
//! };
//! let pair = Pair::new(gray(0.2), gray(0.21), true)?;
//! let difference = pair.measure(Metric::De2000, &MetricOptions::default())?;
//! assert!((0.5..1.5).contains(&difference.value), "hardly seen: ΔE00 is about 1");
//! # Ok::<(), glanz_picture::compare::CompareError>(())
//! ```

mod bands;
mod error;
pub mod frames;
mod heat;
mod measure;
mod metric;
mod metrics;
mod pair;
mod picture;
mod read;
mod rows;
#[cfg(test)]
mod samples;
mod spread;
#[cfg(test)]
mod tests;

pub use error::CompareError;
pub use heat::{heat_color, heat_colors};
pub use measure::{Measurement, MetricOptions};
pub use metric::Metric;
pub use metrics::flip::{DEFAULT_PPD, Exposures, PPD_RANGE};
pub use pair::Pair;
pub use picture::{Picture, Scale};
pub use read::{
    MAX_PIXELS, MAX_SIDE, ReadError, decode_picture, decode_picture_within, read_picture, read_picture_within,
};
pub use spread::Spread;
