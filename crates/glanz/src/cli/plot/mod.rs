//! Plots: curves, the chromaticity diagram, re-radiation matrices, as SVG or PNG.
//!
//! A plot is a [`Picture`]: a list of shapes in points, which knows no file format. One file per plot
//! makes it; [`save`] paints it with the crate `plotters`.

mod axes;
mod band;
mod chromaticity;
mod cones;
mod curves;
mod efficiency;
mod letters;
mod matrix;
mod meyer;
mod paint;
mod picture;
mod png;
mod save;
mod spectra;
mod style;
mod svg;

pub use chromaticity::{Mark, chromaticity};
pub use cones::cones;
pub use efficiency::{Efficiency, Line, efficiency};
pub use matrix::{matrix, reradiation};
pub use meyer::meyer;
pub use picture::Picture;
pub use save::{PlotFile, plot_file};
pub use spectra::{NamedCurve, spectra};
