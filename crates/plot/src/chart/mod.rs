//! What charts are made of: axes, curves, legends, the band of spectral colours; and the two charts of curves,
//! [`LineChart`] and [`WavelengthChart`].

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
pub use curve::{Curve, csv};
pub use line_chart::{LineChart, LineMark, SideBySide};
pub use sample::sampled;
pub use wavelength_chart::{Marked, WavelengthChart};

pub(crate) use color_scale::bar;
pub(crate) use curve::extent;
pub(crate) use heading::heading;
pub(crate) use wavelength_chart::{draw, names};
