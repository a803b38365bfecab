//! Plots of lobes and of Fresnel reflectance.

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
pub use plot::{DEFAULT_NM, LobePlot, Quantity, lobe};
