//! What charts are made of: axes, curves, legends, the band of spectral colours; and the two charts of curves,
//! [`LineChart`] and [`WavelengthChart`].
//!
//! ```
//! use glanz_plot::chart::{Axis, magma, wavelength_color};
//!
//! // Round numbers that hold the data, and where a value lies between both ends.
//! let axis = Axis::round("angle in degrees", (2.0, 87.0), 5);
//! assert!(axis.part(87.0) <= 1.0 && axis.part(2.0) >= 0.0);
//! // Green light is drawn green; on a page small values are bright and great ones dark.
//! assert!(wavelength_color(530.0)[1] > 150);
//! assert!(magma(0.0)[1] > magma(1.0)[1]);
//! ```

mod axes;
pub(crate) mod band;
mod color_scale;
mod curve;
mod heading;
pub(crate) mod legend;
mod line_chart;
mod sample;
mod wavelength_chart;

pub use axes::{Axes, Axis};
pub use band::color as wavelength_color;
pub use color_scale::magma;
pub use curve::{Curve, panel};
pub use line_chart::{LineChart, LineMark, SideBySide};
pub use sample::sampled;
pub use wavelength_chart::{Marked, WavelengthChart};

pub(crate) use color_scale::bar;
pub(crate) use curve::extent;
pub(crate) use heading::heading;
pub(crate) use line_chart::runs;
pub(crate) use wavelength_chart::{draw, names};
