//! Where a lobe sends most, so that points are put there: nothing here changes what is found, only how soon.

use glanz_bsdf::models::ggx::LEAST_ALPHA;
use glanz_bsdf::{DirectionPair, LightTerm, Side};
use glanz_math::{PI, Real, Vec3};

use crate::prepare::DirectLobe;

/// Slopes of microfacets at which a lobe is tried, from the least to the largest in equal steps of the logarithm.
const STEPS: usize = 160;
const LEAST_SLOPE: f64 = 1e-4;
const LARGEST_SLOPE: f64 = 1e2;

/// A lobe as slopes of microfacets.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Proposal {
    /// The number of the lobe in its material.
    pub lobe: usize,
    /// The slope within which half of the lobe is, along its x and its y axis.
    alpha: [f64; 2],
    /// Whether light passes, and the index of what is below; 1 for what is thin.
    refracts: Option<f64>,
}

/// A proposal at a point.
#[derive(Clone, Copy)]
pub(crate) struct PointProposal<R> {
    alpha: [R; 2],
    refracts: Option<f64>,
    /// The viewer, in the frame of the lobe.
    wo: Vec3<R>,
    /// cos θo + √(cos² θo + α² sin² θo): twice the cosine over the part of slopes that is seen.
    reach: R,
}

impl Proposal {
    /// Of the lobes that are not alike in all directions.
    pub(crate) fn all(lobes: &[DirectLobe]) -> Vec<Self> {
        lobes.iter().enumerate().filter_map(|(number, lobe)| Self::new(number, lobe)).collect()
    }

    fn new(number: usize, lobe: &DirectLobe) -> Option<Self> {
        let info = lobe.shape.info();
        if info.delta || lobe.term != LightTerm::Specular {
            return None;
        }
        let refracts = (info.side == Side::Transmission).then(|| lobe.shape.eta());
        let along = |x: f64, y: f64| half_slope(|slope| value(lobe, refracts, [slope * x, slope * y], slope));
        Some(Self { lobe: number, alpha: [along(1.0, 0.0), along(0.0, 1.0)], refracts })
    }

    /// For a viewer in the lobe's frame, of a lobe whose width is so many times its own.
    #[inline(always)]
    pub(crate) fn at<R: Real>(&self, wo: Vec3<R>, width: R) -> PointProposal<R> {
        let [x, y] = self.alpha;
        let least = width.lit(LEAST_ALPHA);
        let alpha = [(width * width.lit(x)).max(least), (width * width.lit(y)).max(least)];
        let slopes = (alpha[0] * wo.x).sqr() + (alpha[1] * wo.y).sqr();
        let reach = wo.z + (wo.z.sqr() + slopes).sqrt();
        PointProposal { alpha, refracts: self.refracts, wo, reach }
    }
}

/// What a lobe has at a slope, for a viewer straight above, per logarithm of the slope.
fn value(lobe: &DirectLobe, refracts: Option<f64>, [x, y]: [f64; 2], slope: f64) -> f64 {
    let cosine = 1.0 / libm::sqrt(1.0 + slope * slope);
    let h = Vec3::new(-x * cosine, -y * cosine, cosine);
    let wo = Vec3::new(0.0, 0.0, 1.0);
    let wi = match refracts {
        Some(eta) if eta != 1.0 => match refracted(wo, h, eta) {
            Some(wi) => wi,
            None => return 0.0,
        },
        other => {
            let wi = wo.reflected(h);
            if other.is_some() { Vec3::new(wi.x, wi.y, -wi.z) } else { wi }
        }
    };
    // dωi = 4 cos θh dωh, and dωh = cos³ θh r dr dφ.
    lobe.shape.f_cos(&DirectionPair::new(wo, wi)).max(0.0) * cosine.powi(4) * slope * slope
}

/// The slope within which half of a density over its logarithm is; a wide lobe where there is none.
fn half_slope(density: impl Fn(f64) -> f64) -> f64 {
    let step = libm::log(LARGEST_SLOPE / LEAST_SLOPE) / STEPS as f64;
    let slope = |i: usize| LEAST_SLOPE * libm::exp(step * (i as f64 + 0.5));
    let values: Vec<f64> = (0..STEPS).map(|i| density(slope(i))).collect();
    let total: f64 = values.iter().sum();
    let mut sum = 0.0;
    for (i, value) in values.iter().enumerate() {
        sum += value;
        if sum >= 0.5 * total && total.is_finite() && total > 0.0 {
            return slope(i).clamp(LEAST_ALPHA, 1.0);
        }
    }
    1.0
}

/// The direction on the other side of a boundary.
fn refracted(wo: Vec3<f64>, h: Vec3<f64>, eta: f64) -> Option<Vec3<f64>> {
    let cos_o = wo.dot(h);
    let cos2 = 1.0 - (1.0 - cos_o * cos_o) / (eta * eta);
    (cos2 > 0.0).then(|| h * (cos_o / eta - libm::sqrt(cos2)) - wo * (1.0 / eta))
}

impl<R: Real> PointProposal<R> {
    /// A direction of the proposal by a point of the unit square, in the lobe's frame, and where there is one.
    ///
    /// Slopes that the viewer sees, after J. Dupuy and A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps",
    /// 2023, which is that of E. Heitz, 2018, by fewer steps.
    #[inline(always)]
    pub(crate) fn direction(&self, v: f64, turn: [f64; 2]) -> (Vec3<R>, R::Mask) {
        let (wo, [ax, ay]) = (self.wo, self.alpha);
        let (zero, one) = (wo.z.zero(), wo.z.one());
        let round = Vec3::new(wo.x * ax, wo.y * ay, wo.z);
        let round = round * round.dot(round).max(one.lit(1e-30)).rsqrt();
        let z = one.lit(1.0 - v) * (one + round.z) - round.z;
        let sine = (one - z.sqr()).max(zero).sqrt();
        let cap = Vec3::new(sine * one.lit(turn[0]), sine * one.lit(turn[1]), z) + round;
        let h = Vec3::new(cap.x * ax, cap.y * ay, cap.z.max(zero));
        let h = h * h.dot(h).max(one.lit(1e-30)).rsqrt();
        let cos_o = wo.dot(h);
        match self.refracts {
            Some(eta) if eta != 1.0 => {
                let inverse = one.lit(1.0 / eta);
                let cos2 = one - (one - cos_o.sqr()) * inverse.sqr();
                let wi = h * (cos_o * inverse - cos2.max(zero).sqrt()) - wo * inverse;
                (wi, zero.lt(cos2) & wi.z.lt(zero))
            }
            other => {
                let wi = h * (cos_o + cos_o) - wo;
                let is_above = zero.lt(wi.z);
                (if other.is_some() { Vec3::new(wi.x, wi.y, -wi.z) } else { wi }, is_above)
            }
        }
    }

    /// How dense its directions are around one, per steradian.
    #[inline(always)]
    pub(crate) fn density(&self, wi: Vec3<R>) -> R {
        let (wo, zero, one) = (self.wo, self.wo.z.zero(), self.wo.z.one());
        match self.refracts {
            Some(eta) if eta != 1.0 => {
                let h = wo + wi * one.lit(eta);
                let h = h * h.dot(h).max(one.lit(1e-30)).rsqrt();
                let h = h * one.select(zero.lt(h.z), -one);
                let (cos_o, cos_i) = (wo.dot(h), wi.dot(h));
                let sum = cos_o + cos_i * one.lit(eta);
                let jacobian = one.lit(eta * eta) * cos_i.abs() / sum.sqr().max(one.lit(1e-12));
                let density = self.slopes(h) * one.lit(2.0) * cos_o / self.reach * jacobian;
                density.select(zero.lt(cos_o) & cos_i.lt(zero) & wi.z.lt(zero), zero)
            }
            other => {
                let wi = if other.is_some() { Vec3::new(wi.x, wi.y, -wi.z) } else { wi };
                let h = wo + wi;
                let h = h * h.dot(h).max(one.lit(1e-30)).rsqrt();
                (self.slopes(h) * one.lit(0.5) / self.reach).select(zero.lt(wi.z), zero)
            }
        }
    }

    /// GGX, as density of half vectors over the projected solid angle.
    #[inline(always)]
    fn slopes(&self, h: Vec3<R>) -> R {
        let [x, y] = self.alpha;
        let scaled = (h.x / x).sqr() + (h.y / y).sqr() + h.z.sqr();
        h.x.lit(1.0 / PI) / (x * y * scaled.sqr())
    }
}
