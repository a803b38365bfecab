//! Precomputed integrals of each lobe for area and environment lights.

use std::sync::Arc;

use glanz_math::Chebyshev;

use super::{EnvironmentMap, LtcTable};

/// How a lobe is integrated over area lights.
#[derive(Clone, Debug, PartialEq)]
pub enum AreaIntegral {
    /// It is the clamped cosine: the form factor of the outline is the integral.
    Cosine,
    /// By linearly transformed cosines.
    Ltc(Arc<LtcTable>),
    /// By a sum over points of the light: anisotropic lobes, and lobes of scenes without areas.
    Points,
    /// It sends light into one direction, which meets the light or not.
    Mirror,
}

/// What a lobe makes of area and environment lights.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeIntegrals {
    /// Its albedo over the cosine of the view angle, layers included.
    pub albedo: Chebyshev,
    /// Its mean direction, away from the viewer: the sine of its angle from the normal over that of the view angle,
    /// and its cosine, both over the cosine of the view angle.
    pub middle: [Chebyshev; 2],
    /// How it is integrated over area lights.
    pub area: AreaIntegral,
    /// The environment maps of the scene as the lobe blurs them, in the order of the lights; none of uniform
    /// environments, and of lobes that take the irradiance.
    pub prefiltered: Vec<Option<Arc<EnvironmentMap>>>,
}

impl LobeIntegrals {
    /// That of the clamped cosine, in scenes of so many lights.
    pub fn of_cosine(lights: usize) -> Self {
        let constant = || Chebyshev::interpolate(1, |_| 1.0);
        let (albedo, middle) = (constant(), [constant(), constant()]);
        Self { albedo, middle, area: AreaIntegral::Cosine, prefiltered: vec![None; lights] }
    }
}
