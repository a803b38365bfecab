//! Fits of models to readings.
//!
//! Only the widths of the lobes are searched; the tints follow from them in closed form, as least squares that are not
//! negative, all channels at once. So the search has one number per lobe, whatever the number of channels. Schlick's form of
//! Fresnel's law is linear as well, in the reflectances at normal and at grazing incidence: it costs no search.
//!
//! A grid with a few thousand of the readings and the simplex find where to begin ([`search`]), Levenberg and Marquardt's
//! steps with all readings the last digits ([`refine`]). At each point the tints are found by Gauss and Newton's way
//! ([`solve`]), so that they are those of the metric, not of the numbers themselves. Differences of colour are of all channels
//! together: their steps take widths and tints at once ([`rendered`]). Standard errors are those of the curvature there, or of the differences as they are
//! ([`errors`]).

mod blocks;
mod dense;
mod errors;
mod fitting;
mod lobe;
mod metric;
mod problem;
mod refine;
mod rendered;
mod rendered_slopes;
mod samples;
mod search;
mod slices;
mod solve;
mod tints;

pub use errors::ErrorEstimate;
pub use fitting::{Fit, FitError, FitOptions, fit, fit_lobes, fit_observed};
pub use lobe::{FitLobe, FittedLobe, FittedParameter};
pub use metric::Metric;
pub use slices::{FitSlice, SlicePoint};
