//! The factors D and G of models of facets by themselves, as plots and certificates ask for them.

use glanz_math::Vec3;

use super::{Distribution, d_beckmann, d_ggx, lambda_beckmann, lambda_ggx, smith_g1, smith_g2};
use crate::DirectionPair;

/// Viewer and light, the latter turned up where it is below.
pub(crate) fn both_above(pair: &DirectionPair<f64>) -> (Vec3<f64>, Vec3<f64>) {
    let wo = Vec3::new(pair.tangent_o.0, pair.tangent_o.1, pair.cos_o);
    (wo, Vec3::new(pair.tangent_i.0, pair.tangent_i.1, pair.cos_i.abs()))
}

/// D towards a facet above the surface.
pub(crate) fn distribution(kind: Distribution, half: Vec3<f64>, alpha: (f64, f64)) -> f64 {
    if half.z <= 0.0 {
        return 0.0;
    }
    match kind {
        Distribution::Ggx => d_ggx(half, alpha),
        Distribution::Beckmann => d_beckmann(half, alpha),
    }
}

/// Λ of viewer and light.
fn lambdas(kind: Distribution, pair: &DirectionPair<f64>, alpha: (f64, f64)) -> (f64, f64) {
    let (wo, wi) = both_above(pair);
    match kind {
        Distribution::Ggx => (lambda_ggx(wo, alpha), lambda_ggx(wi, alpha)),
        Distribution::Beckmann => (lambda_beckmann(wo, alpha), lambda_beckmann(wi, alpha)),
    }
}

/// Smith's G of a facet that is seen and lit from the same side, where its height counts for both.
pub(crate) fn shadowing(kind: Distribution, pair: &DirectionPair<f64>, alpha: (f64, f64)) -> f64 {
    let (o, i) = lambdas(kind, pair, alpha);
    smith_g2(o, i)
}

/// Smith's G of a facet that is seen from one side and lit from the other.
pub(crate) fn shadowing_apart(kind: Distribution, pair: &DirectionPair<f64>, alpha: (f64, f64)) -> f64 {
    let (o, i) = lambdas(kind, pair, alpha);
    smith_g1(o) * smith_g1(i)
}
