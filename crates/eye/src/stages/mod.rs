//! What happens to a picture in the eye, stage after stage.

pub(crate) mod acuity;
mod blur;
pub(crate) mod chromatic;
pub(crate) mod deficiency;
pub(crate) mod dusk;
pub(crate) mod field;
pub(crate) mod glare;
pub(crate) mod photons;
pub(crate) mod plane;
pub(crate) mod pyramid;
mod see;

pub use acuity::Angles;
pub use deficiency::Defect;
pub use dusk::LUMINANCE;
pub use see::{Seeing, Seen};
