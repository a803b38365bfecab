//! The shapes of BSDF lobes: reflection and transmission models, and the laws that they keep.
//!
//! A lobe is a **shape** times a **tint**. A shape is a function of two directions and knows no colour; this crate holds
//! the shapes. Every model is a folder of its own below [`models`], and the list in `models.rs` is the only place that names
//! them all: the enum [`Shape`], the names, the parameters for command line and user interface and the tests of
//! the [`laws`] come from it.
//!
//! ```
//! use glanz_bsdf::{DirectionPair, Shape, albedo};
//! use glanz_math::Vec3;
//!
//! let phong = Shape::named("phong-normalized", &[("shininess", 50.0)])?;
//! // Viewer and light 30° off the normal, in each other's mirror direction.
//! let angle = 30_f64.to_radians();
//! let (wo, wi) = (Vec3::from_angles(angle, 0.0), Vec3::from_angles(angle, std::f64::consts::PI));
//! let peak: f64 = phong.f_cos(&DirectionPair::new(wo, wi));
//! // (n+2)/(2π) cosθi.
//! assert!((peak - 52.0 / (2.0 * std::f64::consts::PI) * angle.cos()).abs() < 1e-9);
//! // All light comes back along the normal.
//! assert!((albedo(&phong, 1.0) - 1.0).abs() < 1e-4);
//! # Ok::<(), glanz_bsdf::ParamError>(())
//! ```
//!
//! Conventions: the local frame has z along the normal; `wo` points to the viewer, `wi` to the light, both of unit length
//! and away from the surface. [`Model::f_cos`] is the BSDF **times the incident cosine**, in 1/sr.

mod albedo;
#[cfg(test)]
mod cost;
mod custom;
mod direction_pair;
mod factor_table;
mod info;
mod lane_model;
pub mod laws;
mod layers;
pub mod microfacet;
pub mod models;
mod serial;
pub mod terms;
pub mod wgsl;

pub use albedo::{albedo, albedo_at, albedo_with};
pub use custom::CustomModel;
pub use direction_pair::DirectionPair;
pub use factor_table::{FactorTable, FactorTableError};
pub use glanz_math::Chebyshev;
pub use info::{LightTerm, ModelInfo, ParamError, ParamInfo, Side};
pub use lane_model::{LaneModel, ModelSource};
pub use laws::Law;
pub use layers::{Angle, CoatSurface, LayerWeight, coat_reflectance, coated_reflectance, layered_albedo};
pub use models::{MODELS, Shape, ShapeVisitor};

use glanz_math::{Real, Vec3};

/// A reflection or transmission model.
///
/// A model is a value: its parameters are read by [`Model::get`], and [`Model::with`] makes another model, so that numbers
/// derived from them always belong to them.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Model, models::phong_normalized::PhongNormalized};
///
/// let pair = DirectionPair::isotropic(1.0_f64, 1.0, 1.0);
/// let phong = PhongNormalized::with_params(&[("shininess", 50.0)])?;
/// // (n+2)/(2π) along the normal.
/// assert_eq!(phong.f_cos(&pair), 52.0 / (2.0 * std::f64::consts::PI));
/// let wide = phong.with("shininess", 6.0)?;
/// assert_eq!(wide.get("shininess"), Some(6.0));
/// assert_eq!(wide.f_cos(&pair), 8.0 / (2.0 * std::f64::consts::PI));
/// assert_eq!(PhongNormalized::INFO.name, "phong-normalized");
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
pub trait Model: Sized {
    /// Its name, parameters and laws.
    const INFO: ModelInfo;

    /// The model from its parameters, in the order of `INFO.params` and already checked against their ranges:
    /// [`Model::with_params`] checks them.
    fn from_params(values: &[f64]) -> Self;

    /// The parameter values, in the order of `INFO.params`.
    fn params(&self) -> Vec<f64>;

    /// The model with the parameters in `set` and the defaults for the others.
    ///
    /// # Errors
    ///
    /// [`ParamError`] where the model has no such parameter or a value is out of its range.
    fn with_params(set: &[(&str, f64)]) -> Result<Self, ParamError> {
        Ok(Self::from_params(&Self::INFO.values(set)?))
    }

    /// The parameter called `name`; none if the model has no such parameter.
    fn get(&self, name: &str) -> Option<f64> {
        let index = Self::INFO.params.iter().position(|param| param.name == name)?;
        self.params().get(index).copied()
    }

    /// The same model with another value of one parameter: what has been derived from the parameters is derived again.
    ///
    /// # Errors
    ///
    /// [`ParamError`] where the model has no such parameter or the value is out of its range.
    fn with(&self, name: &str, value: f64) -> Result<Self, ParamError> {
        let mut values = self.params();
        values[Self::INFO.place(name, value)?] = value;
        Ok(Self::from_params(&values))
    }

    /// The BSDF times the incident cosine, in 1/sr. Zero where the light is on the wrong side of the surface
    /// (see [`ModelInfo::side`]); the viewer is above it.
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R;

    /// The numbers that the model's twin in WGSL reads, in its order: those of which [`Model::f_cos`] makes constants by
    /// [`Real::lit`], rounded as it rounds them. See [`wgsl`]; without a twin nobody reads them.
    fn numbers(&self) -> Vec<f32> {
        Vec::new()
    }

    /// The index of refraction below the surface over that above it, for refraction: then the albedo of a lossless surface
    /// is 1/η², since radiance is proportional to the square of the index, and the law of reciprocity is
    /// f(wo, wi) / η_o² = f(wi, wo) / η_i².
    fn eta(&self) -> f64 {
        1.0
    }

    /// Whether this shape reads the tangent: an anisotropic model with equal widths does not.
    fn is_anisotropic(&self) -> bool {
        Self::INFO.anisotropic
    }

    /// The cosine, 0 … 1, at which Fresnel's law is evaluated: between the light and the normal of the facet that sends it
    /// to the viewer.
    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        pair.cos_view_half()
    }

    /// The distribution D of microfacet normals towards the unit vector `half`, in 1/sr, so that ∫ D cosθ dω over the
    /// hemisphere is 1. None for models that are not made of facets. For plots and laws, not for pictures.
    fn distribution(&self, _half: Vec3<f64>) -> Option<f64> {
        None
    }

    /// The masking and shadowing factor G. None for models without one.
    fn shadowing(&self, _pair: &DirectionPair<f64>) -> Option<f64> {
        None
    }
}

/// The examples of the README run as tests of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
