//! The factors D and G by themselves, for plots and certificates.

use glanz_math::Vec3;

use super::Distribution;
use crate::DirectionPair;
use crate::terms::{smith_g1, smith_g2};

/// Viewer and light, the latter turned up where it is below.
pub(crate) fn both_above(pair: &DirectionPair<f64>) -> (Vec3<f64>, Vec3<f64>) {
    let wo = Vec3::new(pair.tangent_o.0, pair.tangent_o.1, pair.cos_o);
    (wo, Vec3::new(pair.tangent_i.0, pair.tangent_i.1, pair.cos_i.abs()))
}

/// D towards a facet normal, 0 for one below the surface.
pub(crate) fn d_above<D: Distribution>(half: Vec3<f64>, alpha: (f64, f64)) -> f64 {
    if half.z <= 0.0 { 0.0 } else { D::d(half, alpha) }
}

/// Smith's height-correlated G2 of facets that are seen and lit from the same side.
pub(super) fn g2_same_side<D: Distribution>(pair: &DirectionPair<f64>, alpha: (f64, f64)) -> f64 {
    let (wo, wi) = both_above(pair);
    smith_g2(D::lambda(wo, alpha), D::lambda(wi, alpha))
}

/// Smith's G1(wo) G1(wi) of facets that are seen from one side and lit from the other.
pub(super) fn g1_both_sides<D: Distribution>(pair: &DirectionPair<f64>, alpha: (f64, f64)) -> f64 {
    let (wo, wi) = both_above(pair);
    smith_g1(D::lambda(wo, alpha)) * smith_g1(D::lambda(wi, alpha))
}
