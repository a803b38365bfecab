//! Figures: plain data that draws itself on a [`Page`](crate::Page).
//!
//! ```
//! use glanz_plot::Figure;
//! use glanz_plot::figure::{NamedSpectrum, spectra};
//!
//! let lamp = NamedSpectrum { name: "A".to_owned(), spectrum: glanz_color::light("A")? };
//! let svg = spectra("A lamp", "300 to 780 nm", "relative power", &[lamp]).page().svg()?;
//! assert!(svg.starts_with("<svg"));
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod chromaticity;
mod color_vectors;
mod comparison;
mod cones;
mod efficiency;
mod eye;
mod lobe3d;
mod matrix;
mod meyer;
mod polar;
mod projection;
mod regression;
mod slices;
mod spectra;
mod vectors;
mod ward;

pub use chromaticity::{ChromaticityDiagram, Mark};
pub use color_vectors::ColorVectors;
pub use comparison::{ComparisonSheet, PictureRow};
pub use cones::cones;
pub use efficiency::{EfficiencyChart, EfficiencyLine, EfficiencyPanel};
pub use eye::EyePlot;
pub use lobe3d::{LobeBodies, LobeBody};
pub use matrix::ReradiationMap;
pub use meyer::meyer;
pub use polar::{PolarChart, Ray};
pub use regression::RegressionChart;
pub use slices::{CELLS, Slice, SliceMaps};
pub use spectra::{NamedSpectrum, spectra};
pub use vectors::{Arc, Arrow, VectorDrawing};
pub use ward::ward;
