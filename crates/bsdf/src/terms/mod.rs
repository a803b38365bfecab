//! Terms that models and tints are made of: distributions of microfacet normals, masking and shadowing, Fresnel's
//! equations, thin films.
//!
//! ```
//! use glanz_bsdf::terms::{fresnel_dielectric, fresnel_schlick};
//!
//! // Glass along the normal reflects 4 %, and so does Schlick's approximation.
//! assert!((fresnel_dielectric(1.0_f64, 1.5) - 0.04).abs() < 1e-12);
//! assert_eq!(fresnel_schlick(1.0_f64, 0.04), 0.04);
//! ```

mod distribution;
mod exp2_or_zero;
mod fresnel;
mod masking;
mod thin_film;
pub(crate) mod ward;

pub use distribution::{d_beckmann, d_charlie, d_gaussian, d_ggx, gaussian_scale};
pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_polarized, fresnel_schlick};
pub use masking::{g_v_cavity, lambda_beckmann, lambda_ggx, smith_g1, smith_g2};
pub use thin_film::{fresnel_film, fresnel_slab};
pub use ward::{WardFactor, WardLobe, Widths};

pub(crate) use distribution::exp_of_minus;
pub(crate) use exp2_or_zero::exp2_or_zero;
pub(crate) use ward::{ALPHA, ALPHA_Y, above, height_squared};
