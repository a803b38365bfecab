//! Lobes that a command line names: models with parameters, and what colours them.

mod cases;
mod medium;

pub use cases::{Case, SetArgs, model_names};
pub use medium::{Factor, FactorArgs, Medium, medium, wavelength};
