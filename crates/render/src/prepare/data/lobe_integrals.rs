//! Precomputed integrals of each lobe for area and environment lights.

use std::sync::Arc;

use glanz_math::{Chebyshev, Real};

use super::{LobeLookups, LtcTable};

/// How a lobe is integrated over area lights.
#[derive(Clone, Debug, PartialEq)]
pub enum AreaIntegral {
    /// It is the clamped cosine: the form factor of the outline is the integral.
    Cosine,
    /// By linearly transformed cosines.
    Ltc(Arc<LtcTable>),
    /// By a sum over points of the light: lobes with a grain, and lobes of scenes without areas.
    Points,
    /// It sends light into one direction, which meets the light or not.
    Mirror,
}

/// The albedo of a lobe over the view.
#[derive(Clone, Debug, PartialEq)]
pub struct Albedo {
    /// Over the cosine of the view angle; of a lobe with a grain the mean over azimuths.
    pub mean: Chebyshev,
    /// Of a lobe with a grain what is added times the cosine of twice the azimuth from the lobe's x axis, and of four times
    /// it.
    pub waves: Vec<Chebyshev>,
}

impl Albedo {
    /// 1 for all views.
    pub fn constant() -> Self {
        Self { mean: Chebyshev::interpolate(1, |_| 1.0), waves: Vec::new() }
    }

    /// For a view; `tangent` are the coordinates of the viewer on the lobe's x and y axis, of lobes with a grain.
    #[inline(always)]
    pub fn at<R: Real>(&self, cos_o: R, tangent: Option<[R; 2]>) -> R {
        let mean = self.mean.at(cos_o);
        let (Some([x, y]), [twice, four_times]) = (tangent, self.waves.as_slice()) else {
            return mean.max(cos_o.zero());
        };
        let squared = x.sqr() + y.sqr();
        let wave = (x.sqr() - y.sqr()) / squared.max(squared.lit(1e-20));
        let second = wave.sqr() * wave.lit(2.0) - wave.one();
        (mean + twice.at(cos_o) * wave + four_times.at(cos_o) * second).max(cos_o.zero())
    }
}

/// What a lobe makes of area and environment lights.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeIntegrals {
    /// Its albedo, layers included.
    pub albedo: Albedo,
    /// How it is integrated over area lights.
    pub area: AreaIntegral,
    /// How it looks up environments; none where they are uniform, of perfect mirrors, and of the clamped cosine, which takes
    /// the irradiance.
    pub lookups: Option<Arc<LobeLookups>>,
}

impl LobeIntegrals {
    /// That of the clamped cosine.
    pub fn of_cosine() -> Self {
        Self { albedo: Albedo::constant(), area: AreaIntegral::Cosine, lookups: None }
    }
}
