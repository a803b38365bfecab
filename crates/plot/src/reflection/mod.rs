//! Plots of lobes and of Fresnel reflectance.
//!
//! ```
//! use glanz_plot::Figure;
//! use glanz_plot::reflection::{FresnelPlot, Lobe, LobePlot, Medium};
//!
//! let plot = LobePlot::new(vec![Lobe::named("ggx", &[("alpha", 0.2)])?]);
//! assert!(plot.albedo()?.csv().lines().count() > 10);
//! // What glass reflects along the normal: ((1.5 - 1) / (1.5 + 1))².
//! let glass = Medium::named("1.5", 550.0)?;
//! assert!((glass.reflectance(1.0) - 0.04).abs() < 1e-12);
//! assert!(FresnelPlot::new(vec![glass], 550.0).chart()?.csv().contains("1.5"));
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```

mod albedo;
mod body;
mod factor;
mod fresnel;
mod lobe;
mod medium;
mod plane;
mod plot;
mod slice;
mod terms;

pub use factor::Factor;
pub use fresnel::FresnelPlot;
pub use lobe::{Lobe, label};
pub use medium::Medium;
pub use plot::{DEFAULT_NM, LobePlot, Quantity, Unit, lobe};
