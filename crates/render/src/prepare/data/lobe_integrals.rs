//! Precomputed integrals of each lobe for area and environment lights.

use std::sync::Arc;

use glanz_math::Chebyshev;

use super::{LobeLookups, LtcTable};

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
    /// How it is integrated over area lights.
    pub area: AreaIntegral,
    /// How it looks up environments; none where they are uniform, of perfect mirrors, and of the clamped cosine, which takes
    /// the irradiance.
    pub lookups: Option<Arc<LobeLookups>>,
}

impl LobeIntegrals {
    /// That of the clamped cosine.
    pub fn of_cosine() -> Self {
        let albedo = Chebyshev::interpolate(1, |_| 1.0);
        Self { albedo, area: AreaIntegral::Cosine, lookups: None }
    }
}
