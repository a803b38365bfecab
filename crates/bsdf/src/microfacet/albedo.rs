//! The directional albedo of microfacets that reflect all light, single reflections only, with Smith's height-correlated
//! masking. What it lacks to 1 has met more than one facet.

use glanz_math::{GaussLegendre, PI, Vec3};

use super::Distribution;
use crate::terms::smith_g2;

/// The directional albedo E(wo) of a microfacet surface whose facets are perfect mirrors, single reflections only:
/// ∫ D(h) G2(wo, wi) / (4 cosθo) dωi. `alpha` is (along the tangent, along the bitangent), `cos_o` 0 … 1, `azimuth`
/// in radians from the tangent.
///
/// Quadrature over the cumulative distribution of the facets, within 5e-4: dωi = 4 (wo·h) dωh, and D (n·h) dωh is its
/// differential.
///
/// ```
/// use glanz_bsdf::microfacet::{GgxDistribution, smith_albedo};
///
/// // Along the normal a smooth surface reflects nearly all light at its first facet, the roughest a third of it: the rest
/// // meets a second one.
/// let at = |alpha: f64| smith_albedo::<GgxDistribution>((alpha, alpha), 1.0, 0.0);
/// assert!(at(0.1) > 0.98 && (at(1.0) - (1.0 - std::f64::consts::LN_2)).abs() < 1e-5);
/// ```
pub fn smith_albedo<D: Distribution>(alpha: (f64, f64), cos_o: f64, azimuth: f64) -> f64 {
    // E is even in the azimuth where wo lies in a plane of symmetry: half of the circle is enough.
    let even = alpha.0 == alpha.1 || azimuth == 0.0;
    let azimuth = if alpha.0 == alpha.1 { 0.0 } else { azimuth };
    let (angles, circle) = if even { (32, PI) } else { (64, 2.0 * PI) };
    let wo = Vec3::from_angles(libm::acos(cos_o.clamp(1e-6, 1.0)), azimuth);
    let lambda_o = D::lambda(wo, alpha);
    // The fraction of steeper facets is t³, which puts points among the steepest. Along the normal facets steeper than 45
    // degrees turn light down: a kink, and so the border of two cells.
    let kink = libm::cbrt(D::steeper(1.0 / alpha.0.max(alpha.1))).clamp(0.1, 0.9);
    let rule = GaussLegendre::new(24);
    let at = |t: f64| {
        let slope = D::slope(t * t * t);
        let ring: f64 = (0..angles)
            .map(|i| {
                let (sin, cos) = libm::sincos((f64::from(i) + 0.5) * circle / f64::from(angles));
                let h = Vec3::new(slope * cos * alpha.0, slope * sin * alpha.1, 1.0).normalized();
                let (wi, cosine) = (wo.reflected(h), wo.dot(h));
                if cosine <= 0.0 || wi.z <= 0.0 {
                    return 0.0;
                }
                cosine / (h.z * wo.z) * smith_g2(lambda_o, D::lambda(wi, alpha))
            })
            .sum();
        3.0 * t * t * ring / f64::from(angles)
    };
    rule.integrate(0.0, kink, at) + rule.integrate(kink, 1.0, at)
}

/// The mean of [`smith_albedo`] over diffuse light, 2 ∫ E cosθ dcosθ, of an isotropic surface.
///
/// The colour of light reflected more than once follows from it: F²avg Eavg / (1 − Favg (1 − Eavg)), with Favg the
/// like mean of Fresnel's reflectance (C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks,
/// 2017, and S. Jakob, M. Hašan and others 2014).
pub fn smith_albedo_average<D: Distribution>(alpha: f64) -> f64 {
    let value = |cosine: f64| 2.0 * cosine * smith_albedo::<D>((alpha, alpha), cosine, 0.0);
    // 1 − E is greatest at cosines about alpha: cells around it.
    let borders = [0.0, 0.5 * alpha, (2.0 * alpha).min(0.9), 1.0];
    borders.windows(2).map(|cell| GaussLegendre::new(10).integrate(cell[0], cell[1], value)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::microfacet::{BeckmannDistribution, GgxDistribution};

    /// Of the quadrature over the cumulative distribution.
    const QUADRATURE: f64 = 5e-4;

    fn is_the_integral<D: Distribution>(alpha: (f64, f64)) {
        for cos_o in [0.15, 0.6, 1.0] {
            let wo = Vec3::from_angles(libm::acos(cos_o), 0.9);
            let integral = glanz_math::hemisphere(300, |wi| {
                let g = smith_g2(D::lambda(wo, alpha), D::lambda(wi, alpha));
                D::d((wo + wi).normalized(), alpha) * g / (4.0 * cos_o)
            });
            let got = smith_albedo::<D>(alpha, cos_o, 0.9);
            assert!((got - integral).abs() < QUADRATURE, "{alpha:?}, {cos_o}: {got} for {integral}");
        }
    }

    #[test]
    fn is_the_integral_of_the_reflection_over_all_directions() {
        is_the_integral::<GgxDistribution>((0.3, 0.3));
        is_the_integral::<GgxDistribution>((0.2, 0.7));
        is_the_integral::<BeckmannDistribution>((0.5, 0.5));
        is_the_integral::<BeckmannDistribution>((0.9, 0.4));
    }

    #[test]
    fn a_mirror_loses_nothing_and_roughness_ever_more() {
        let mean = smith_albedo_average::<GgxDistribution>;
        assert!((mean(1e-3) - 1.0).abs() < QUADRATURE);
        let means = [0.01, 0.1, 0.3, 0.6, 1.0].map(mean);
        assert!(means.windows(2).all(|pair| pair[0] > pair[1]), "{means:?}");
    }
}
