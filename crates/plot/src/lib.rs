//! Plots for Glanz: lobes, albedos, Fresnel reflectance, lights, spectra, colour diagrams and contact sheets, as SVG,
//! PNG and PDF, and their numbers as CSV and JSON.
//!
//! ```
//! use glanz_bsdf::Shape;
//! use glanz_plot::Figure;
//!
//! let shapes = [Shape::named("phong", &[("shininess", 32.0)])?, Shape::named("ggx", &[("alpha", 0.2)])?];
//! let mut plot = glanz_plot::lobe(&shapes);
//! plot.theta_deg = vec![20.0, 60.0];
//! let chart = plot.polar()?;
//! assert!(chart.svg()?.starts_with("<svg"));
//! assert!(chart.csv().starts_with("curve,angle of the light from the normal in °"));
//! # Ok::<_, glanz_plot::Error>(())
//! ```
//!
//! A figure is plain data ([`figure`], [`chart`]) that implements [`Figure`]: it draws itself on a [`Page`], a list
//! of shapes in points, which [`Figure::svg`], [`Figure::png`] and [`Figure::pdf`] write, and tells its numbers
//! ([`data`]). [`reflection`] makes figures of BSDF models and media, [`light`] of attenuation and cones. All their
//! [`words`] are there in English and French. [`contact_sheet`] puts drawn pictures beside each other.
//!
//! Pages, and so files, are the same bytes on every machine.

pub mod chart;
pub mod contact_sheet;
pub mod data;
mod error;
pub mod figure;
pub mod light;
mod number;
pub mod page;
pub mod reflection;
pub mod words;

pub use chart::{Axis, Curve, LineChart, WavelengthChart};
pub use contact_sheet::{Canvas, ContactSheet, Grid, Variation, heat_map_sheet};
pub use data::PlotData;
pub use error::Error;
pub use figure::{
    ChromaticityDiagram, EfficiencyChart, EyePlot, NamedSpectrum, PolarChart, RegressionChart,
    ReradiationMap, cones, meyer, spectra,
};
pub use light::{AttenuationPlot, SpotPlot};
pub use number::number;
pub use page::{Figure, Page, PlotFile, PlotFormat};
pub use reflection::{Factor, FresnelPlot, Lobe, LobePlot, Medium, Quantity, lobe};
pub use words::{Lang, Word};
