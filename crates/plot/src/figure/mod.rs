//! Figures: plain data that draws itself on a [`Page`](crate::Page).

mod chromaticity;
mod cones;
mod efficiency;
mod lobe3d;
mod matrix;
mod meyer;
mod polar;
mod slices;
mod spectra;

pub use chromaticity::{ChromaticityDiagram, Mark};
pub use cones::cones;
pub use efficiency::{EfficiencyChart, EfficiencyLine, EfficiencyPanel};
pub use lobe3d::{LobeBodies, LobeBody};
pub use matrix::ReradiationMap;
pub use meyer::meyer;
pub use polar::{PolarChart, Ray};
pub use slices::{CELLS, Slice, SliceMaps};
pub use spectra::{NamedSpectrum, spectra};
