//! Rough refraction: microfacets that each refract by Snell's law.

use core::marker::PhantomData;

use glanz_math::{Real, Vec3};

use super::refracted_half_vector::{RefractedHalfVector, effective_eta, refracted_cosine};
use super::{Distribution, factors};
use crate::{DirectionPair, Model, ModelInfo};

/// f_cos = D · G1(wo) G1(wi) |wo·h| |wi·h| / (cosθo (wo·h + η wi·h)²), over a distribution D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmithTransmission<D> {
    /// The width of the distribution.
    alpha: f64,
    /// The index of refraction below over the index above.
    eta: f64,
    /// The index that is computed with.
    effective_eta: f64,
    /// α².
    square: f64,
    /// The constant factor, [`Distribution::transmission_scale`].
    scale: f64,
    distribution: PhantomData<D>,
}

impl<D> SmithTransmission<D> {
    /// The width α.
    #[inline(always)]
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// α².
    #[inline(always)]
    pub fn square(&self) -> f64 {
        self.square
    }

    /// The constant factor, [`Distribution::transmission_scale`] of α².
    #[inline(always)]
    pub fn scale(&self) -> f64 {
        self.scale
    }
}

impl<D: Distribution> Model for SmithTransmission<D> {
    const INFO: ModelInfo = D::TRANSMISSION;

    fn from_params(values: &[f64]) -> Self {
        let (alpha, eta) = (values[0], values[1]);
        let square = alpha * alpha;
        Self {
            alpha,
            eta,
            effective_eta: effective_eta(eta),
            square,
            scale: D::transmission_scale(square),
            distribution: PhantomData,
        }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.alpha, self.eta]
    }

    fn eta(&self) -> f64 {
        effective_eta(self.eta)
    }

    #[inline(always)]
    fn tint_cosine<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        refracted_cosine(pair, self.effective_eta)
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let half = RefractedHalfVector::new(pair, self.effective_eta);
        D::transmitted(self, &half, pair).select(half.lit, pair.cos_o.zero())
    }

    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Some(factors::d_above::<D>(half, (self.alpha, self.alpha)))
    }

    fn shadowing(&self, pair: &DirectionPair<f64>) -> Option<f64> {
        Some(factors::g1_both_sides::<D>(pair, (self.alpha, self.alpha)))
    }
}
