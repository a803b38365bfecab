//! Measured reflectance: readings of goniometers and tables made of them, their files, and what they say of themselves.
//!
//! All formats are read into [`Measured`]. Values are BRDF, in 1/sr, without a cosine, whatever the file holds; the frame is
//! that of Glanz: the normal is z, the grain runs along x, azimuths count from x to y. Directions point away from the
//! surface, to the light (`wi`) and to the detector (`wo`).
//!
//! ```
//! use glanz_measure::Measured;
//!
//! // The reflectance factor of a white tile, for light at 45° and eight detectors in the plane.
//! let mut text = String::from("# quantity reflectance_factor\ntheta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,Y\n");
//! for theta in [-60, -40, -20, 0, 10, 20, 40, 60] {
//!     text += &format!("45,180,{},{},0.9\n", i32::abs(theta), if theta < 0 { 180 } else { 0 });
//! }
//! let measured = Measured::read(text.as_bytes(), "tile.csv", &Default::default())?;
//! let readings = measured.readings();
//! assert!((readings.values(3)[0] - 0.9 / std::f32::consts::PI).abs() < 1e-6);
//! # Ok::<(), glanz_measure::ReadError>(())
//! ```

mod appearance;
mod colors;
mod error;
mod factored;
mod facts;
mod fit;
mod format;
#[cfg(feature = "fuzz")]
#[doc(hidden)]
pub mod fuzz;
mod geometry;
mod goniometer;
mod linear;
mod plane;
mod published;
mod readings;
mod shape;
mod viewing;
mod ward;

pub use appearance::{
    Function, GlossMeter, HazeMeter, MultiAngle, SPHERE_DEG, flop_index, forty_five_zero, haze_of_gloss,
    log_haze, multi_angle, sphere,
};
pub use error::{ReadError, WriteError};
pub use factored::{FactorError, FactorFacts, FactorOptions, Factored, Smoothed};
pub use facts::{Albedo, Facts, Reciprocity};
pub use fit::{
    ErrorEstimate, Fit, FitError, FitLobe, FitOptions, FitSlice, FittedLobe, FittedParameter, Metric,
    SlicePoint, fit, fit_lobes, fit_observed,
};
pub use format::{
    Coordinates, Data, Format, Klems, Measured, Merl, ReadOptions, Rgl, Table, TensorTree, write_csv,
    write_klems, write_merl, write_rgl, write_zemax, zemax_nodes_deg,
};
pub use geometry::Geometry;
pub use goniometer::{Noise, spiral_about_mirror};
pub use plane::PlaneSlice;
pub use published::{PublishedError, PublishedFit, PublishedLobe, PublishedModel};
pub use readings::{Channels, Quantity, Readings};
pub use ward::{WardFit, WardPoint, fit_ward};
