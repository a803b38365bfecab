//! What is looked at: a shape, or in tests something wilfully broken.

use glanz_math::Vec3;

use super::directional::albedo_by;
use crate::{DirectionPair, LightTerm, ModelInfo, Shape, Side};

/// Why lobes without a light's direction keep no laws.
pub(super) const NO_DIRECTION: &str = "it answers to no light from a direction";
/// Why perfect mirrors and refraction keep no laws of values.
pub(super) const SINGLE_DIRECTION: &str = "it sends light into a single direction";

/// Something that a certificate can be made of.
pub(super) trait Subject {
    /// What it tells about itself.
    fn info(&self) -> &'static ModelInfo;
    /// Its parameters, in the order of `info().params`.
    fn params(&self) -> Vec<f64>;
    /// The same model with other parameters.
    fn with(&self, params: &[f64]) -> Box<dyn Subject>;
    /// The BSDF times the incident cosine.
    fn long(&self, pair: &DirectionPair<f64>) -> f64;
    /// The same in single precision.
    fn short(&self, pair: &DirectionPair<f32>) -> f32;
    /// The index of refraction below the surface over that above it.
    fn eta(&self) -> f64;
    /// The distribution of facets, if it has one.
    fn distribution(&self, half: Vec3<f64>) -> Option<f64>;

    /// Why the laws of directional light do not apply, if they do not.
    fn excuse(&self) -> Option<&'static str> {
        let info = self.info();
        match info.term {
            LightTerm::Ambient | LightTerm::Emission => Some(NO_DIRECTION),
            _ if info.delta => Some(SINGLE_DIRECTION),
            _ => None,
        }
    }

    /// The same surface turned over: its parameter `eta` becomes the inverse. None where that is out of range.
    fn turned_over(&self) -> Option<Box<dyn Subject>> {
        let mut params = self.params();
        for (value, info) in params.iter_mut().zip(self.info().params).filter(|(_, info)| info.name == "eta")
        {
            *value = 1.0 / *value;
            if !(info.min..=info.max).contains(value) {
                return None;
            }
        }
        Some(self.with(&params))
    }

    /// ∫ f_cos dωi over the light's hemisphere, for the function given in place of its own.
    fn integral(&self, wo: Vec3<f64>, f_cos: &dyn Fn(&DirectionPair<f64>) -> f64) -> f64 {
        albedo_by(self.info(), self.eta(), wo, f_cos)
    }

    /// Whether light passes through.
    fn transmits(&self) -> bool {
        self.info().side == Side::Transmission
    }
}

impl Subject for Shape {
    fn info(&self) -> &'static ModelInfo {
        Self::info(self)
    }
    fn params(&self) -> Vec<f64> {
        Self::params(self)
    }
    fn with(&self, params: &[f64]) -> Box<dyn Subject> {
        let info = Self::info(self);
        let set: Vec<_> = info.params.iter().map(|param| param.name).zip(params.iter().copied()).collect();
        Box::new(Self::named(info.name, &set).expect("parameters within their ranges make a shape"))
    }
    fn long(&self, pair: &DirectionPair<f64>) -> f64 {
        self.f_cos(pair)
    }
    fn short(&self, pair: &DirectionPair<f32>) -> f32 {
        self.f_cos(pair)
    }
    fn eta(&self) -> f64 {
        Self::eta(self)
    }
    fn distribution(&self, half: Vec3<f64>) -> Option<f64> {
        Self::distribution(self, half)
    }
}
