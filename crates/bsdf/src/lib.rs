//! The shapes of reflection lobes.
//!
//! A lobe is a **shape** times a **tint**. A shape is a function of two directions and knows no
//! colour; this crate holds the shapes. Every model is a room of its own below `models`, and
//! the list in `models.rs` is the only place that names them all: the enum [`Shape`], the names, the
//! parameters for command line and user interface and the conformance tests come from it.
//!
//! Conventions: the local frame has z along the normal; `wo` points to the viewer, `wi` to the light,
//! both of unit length and away from the surface. [`Model::f_cos`] is the BSDF **times the incident
//! cosine**, in 1/sr.

mod albedo;
pub mod certificate;
#[cfg(test)]
mod conformance;
mod direction_pair;
mod info;
mod layers;
pub mod models;
mod serial;
pub mod terms;

pub use albedo::{albedo, albedo_at, albedo_with};
pub use direction_pair::DirectionPair;
pub use glanz_math::Chebyshev;
pub use info::{Law, LightTerm, ModelInfo, ParamError, ParamInfo, Side};
pub use layers::{Angle, CoatSurface, LayerWeight, layered_albedo};
pub use models::{MODELS, Shape};

use glanz_math::{Real, Vec3};

/// One reflection model.
pub trait Model: Sized {
    /// Its name, parameters and laws.
    const INFO: ModelInfo;

    /// Whether the pixel loop should hold its code in place rather than call it: for models so cheap that
    /// a call would cost more.
    const IN_PLACE: bool = false;

    /// The model from its parameters, in the order of `INFO.params` and already checked against
    /// their ranges.
    fn from_params(values: &[f64]) -> Self;

    /// The parameter values, in the order of `INFO.params`.
    fn params(&self) -> Vec<f64>;

    /// The BSDF times the incident cosine, in 1/sr. Zero where the light is on the wrong side of the surface
    /// (see [`ModelInfo::side`]); the viewer is above it.
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R;

    /// The index of refraction below the surface over that above it, where light is bent on its way through: then
    /// the albedo of a lossless surface is 1/η², since radiance is spread or squeezed, and the law of reciprocity
    /// is f(wo, wi) / η_o² = f(wi, wo) / η_i².
    fn eta(&self) -> f64 {
        1.0
    }

    /// Whether this very shape asks where the tangent is: an anisotropic model with equal widths does not.
    fn is_anisotropic(&self) -> bool {
        Self::INFO.anisotropic
    }

    /// The cosine, 0 … 1, that a tint by Fresnel's law takes: that of the angle at which light meets the facet
    /// that sends it to the viewer.
    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_view_half()
    }

    /// The distribution D of facet normals towards the unit vector `half`, in 1/sr, so that ∫ D cosθ dω over the
    /// hemisphere is 1. None for models that are not made of facets. For plots and certificates, not for
    /// pictures.
    fn distribution(&self, _half: Vec3<f64>) -> Option<f64> {
        None
    }

    /// The share G of facets that both directions see. None for models without such a factor.
    fn shadowing(&self, _pair: &DirectionPair<f64>) -> Option<f64> {
        None
    }
}
