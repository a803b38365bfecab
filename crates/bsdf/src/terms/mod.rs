//! Terms that several models, and tints, share.

mod distribution;
mod falloff;
mod film;
mod fresnel;
mod masking;
pub(crate) mod ward;

pub use distribution::{d_beckmann, d_charlie, d_gaussian, d_ggx, gaussian_scale};
pub use film::{fresnel_film, fresnel_slab};
pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_polarized, fresnel_schlick};
pub use masking::{g_v_cavity, lambda_beckmann, lambda_ggx, smith_g1, smith_g2};

pub(crate) use distribution::exp_of_minus;
pub(crate) use falloff::exp2_or_zero;
pub(crate) use ward::{ALPHA, ALPHA_Y, Widths, above, height_squared};
