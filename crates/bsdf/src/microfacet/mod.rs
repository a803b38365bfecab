//! Microfacet lobes with Smith's masking and shadowing, written once over the distribution of their normals.
//!
//! [`Smith`] is the reflection with multiple-scattering compensation, [`SmithMultiple`] the compensation as a lobe of its
//! own, [`SmithTransmission`] rough refraction. A [`Distribution`] is a type without size, [`BeckmannDistribution`] or
//! [`GgxDistribution`]; the models of the list are aliases, such as [`Ggx`](crate::models::ggx::Ggx), and hold the
//! description.
//!
//! ```
//! use glanz_bsdf::microfacet::{GgxDistribution, Smith};
//! use glanz_bsdf::{DirectionPair, Model};
//!
//! // alpha = 0.3, alpha_y = 0 (as alpha), multiscatter = 0 (single reflections only).
//! let ggx = Smith::<GgxDistribution>::from_params(&[0.3, 0.0, 0.0]);
//! // Along the normal D is 1/(π α²) and G2 is 1, so that f_cos is 1/(4π α²).
//! let value: f64 = ggx.f_cos(&DirectionPair::isotropic(1.0, 1.0, 1.0));
//! assert!((value * 4.0 * std::f64::consts::PI * 0.09 - 1.0).abs() < 1e-12);
//! ```

mod albedo;
mod compensation;
mod distribution;
mod factors;
mod half_vector;
mod multiple;
mod reflection;
mod refracted_half_vector;
#[cfg(test)]
mod tests;
mod transmission;

pub use albedo::{smith_albedo, smith_albedo_average};
pub use distribution::{BeckmannDistribution, Distribution, GgxDistribution};
pub use half_vector::HalfVector;
pub use multiple::SmithMultiple;
pub use reflection::Smith;
pub use refracted_half_vector::RefractedHalfVector;
pub use transmission::SmithTransmission;

pub(crate) use factors::{both_above, d_above};

use crate::ParamInfo;

/// The least width: its square must stay well above 6e-8, to which `f32` rounds cosines.
pub const LEAST_ALPHA: f64 = 0.001;

/// The width of a distribution of slopes.
pub const ALPHA: ParamInfo = ParamInfo {
    name: "alpha",
    symbol: "α",
    doc: "width of the distribution of slopes, along the tangent: greater is rougher",
    min: LEAST_ALPHA,
    max: 1.0,
    default: 0.2,
};

/// The width along the bitangent.
pub const ALPHA_Y: ParamInfo = ParamInfo {
    name: "alpha_y",
    symbol: "αy",
    doc: "width along the bitangent; 0 means as alpha",
    min: 0.0,
    max: 1.0,
    default: 0.0,
};

/// The weight of the multiple-scattering compensation.
pub const MULTISCATTER: ParamInfo = ParamInfo {
    name: "multiscatter",
    symbol: "w",
    doc: "weight of the energy of further reflections: 1 loses nothing, 0 is the single reflection alone",
    min: 0.0,
    max: 1.0,
    default: 1.0,
};

/// Both widths, as `alpha_y` is meant.
pub(crate) fn widths(alpha: f64, alpha_y: f64) -> (f64, f64) {
    (alpha, if alpha_y == 0.0 { alpha } else { alpha_y.max(LEAST_ALPHA) })
}
