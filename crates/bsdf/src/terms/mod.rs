//! Terms that several models, and tints, share.

mod falloff;
mod fresnel;
pub(crate) mod ward;

pub(crate) use falloff::exp2_or_zero;
pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_schlick};
pub(crate) use ward::{ALPHA, ALPHA_Y, Widths, above, height_squared};
