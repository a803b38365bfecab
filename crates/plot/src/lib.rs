//! Plots: curves, lobes, the chromaticity diagram, re-radiation matrices, as SVG or PNG.
//!
//! A plot is a [`Picture`]: a list of shapes in points, which knows no file format. One file per plot
//! makes it; [`save`] paints it with the crate `plotters`.

mod axes;
mod band;
mod chromaticity;
mod cones;
mod curves;
mod efficiency;
mod legend;
mod letters;
mod lines;
mod lobe3d;
mod matrix;
mod meyer;
mod paint;
mod picture;
mod png;
mod polar;
mod save;
mod scale;
mod slices;
mod spectra;
mod style;
mod svg;

pub use axes::Axis;
pub use chromaticity::{Mark, chromaticity};
pub use cones::cones;
pub use curves::Curve;
pub use efficiency::{Efficiency, Line, efficiency};
pub use lines::{Lines, Mark as LineMark, side_by_side};
pub use lobe3d::{Lobe3d, Surface};
pub use matrix::{matrix, reradiation};
pub use meyer::meyer;
pub use picture::Picture;
pub use polar::{Polar, Ray};
pub use save::{PlotFile, plot_file};
pub use slices::{CELLS, Slice, Slices};
pub use spectra::{NamedCurve, spectra};
pub use style::{Rgb8, curve as color_of_curve, dash as dash_of_curve, dash_of};
