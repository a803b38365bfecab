//! How much light a rough surface sends out after a single reflection: the directional albedo of microfacets that
//! reflect all light, with Smith's height-correlated masking. What is missing to 1 met a second facet.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::terms::{lambda_beckmann, lambda_ggx, smith_g2};

/// How the slopes of microfacets are distributed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// See [`d_beckmann`](crate::terms::d_beckmann).
    Beckmann,
    /// See [`d_ggx`](crate::terms::d_ggx).
    Ggx,
}

impl Distribution {
    /// Smith's Λ.
    pub(crate) fn lambda(self, w: Vec3<f64>, alpha: (f64, f64)) -> f64 {
        match self {
            Self::Beckmann => lambda_beckmann(w, alpha),
            Self::Ggx => lambda_ggx(w, alpha),
        }
    }

    /// The slope in parts of the width which a share `rest` of the facets is steeper than.
    fn slope(self, rest: f64) -> f64 {
        match self {
            Self::Beckmann => libm::sqrt(-libm::log(rest)),
            Self::Ggx => libm::sqrt(1.0 / rest - 1.0),
        }
    }

    /// The inverse of that.
    fn steeper(self, slope: f64) -> f64 {
        match self {
            Self::Beckmann => libm::exp(-slope * slope),
            Self::Ggx => 1.0 / (1.0 + slope * slope),
        }
    }
}

/// The directional albedo E(wo) of a microfacet surface whose facets are perfect mirrors, single reflections only:
/// ∫ D(h) G2(wo, wi) / (4 cosθo) dωi. `alpha` is (along the tangent, along the bitangent), `cos_o` 0 … 1, `azimuth`
/// in radians from the tangent.
///
/// Quadrature over equal shares of the facets, within 5e-4: dωi = 4 (wo·h) dωh, and D (n·h) dωh is the share.
pub fn smith_albedo(distribution: Distribution, alpha: (f64, f64), cos_o: f64, azimuth: f64) -> f64 {
    // E is even in the azimuth where wo lies in a plane of symmetry: half of the circle is enough.
    let even = alpha.0 == alpha.1 || azimuth == 0.0;
    let azimuth = if alpha.0 == alpha.1 { 0.0 } else { azimuth };
    let (angles, circle) = if even { (32, PI) } else { (64, 2.0 * PI) };
    let wo = Vec3::from_angles(libm::acos(cos_o.clamp(1e-6, 1.0)), azimuth);
    let lambda_o = distribution.lambda(wo, alpha);
    // The share of steeper facets is t³, which puts points among the steepest. Along the normal facets steeper than 45
    // degrees turn light down: a kink, and so the border of two cells.
    let kink = libm::cbrt(distribution.steeper(1.0 / alpha.0.max(alpha.1))).clamp(0.1, 0.9);
    let rule = GaussLegendre::new(24);
    let at = |t: f64| {
        let slope = distribution.slope(t * t * t);
        let ring: f64 = (0..angles)
            .map(|i| {
                let (sin, cos) = libm::sincos((f64::from(i) + 0.5) * circle / f64::from(angles));
                let h = Vec3::new(slope * cos * alpha.0, slope * sin * alpha.1, 1.0).normalized();
                let (wi, cosine) = (wo.reflected(h), wo.dot(h));
                if cosine <= 0.0 || wi.z <= 0.0 {
                    return 0.0;
                }
                cosine / (h.z * wo.z) * smith_g2(lambda_o, distribution.lambda(wi, alpha))
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
pub fn smith_albedo_average(distribution: Distribution, alpha: f64) -> f64 {
    let value = |cosine: f64| 2.0 * cosine * smith_albedo(distribution, (alpha, alpha), cosine, 0.0);
    // What is missing is missing at cosines about alpha: cells around it.
    let borders = [0.0, 0.5 * alpha, (2.0 * alpha).min(0.9), 1.0];
    borders.windows(2).map(|cell| GaussLegendre::new(10).integrate(cell[0], cell[1], value)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terms::{d_beckmann, d_ggx};

    /// Of the quadrature over shares.
    const QUADRATURE: f64 = 5e-4;

    #[test]
    fn is_the_integral_of_the_reflection_over_all_directions() {
        for (distribution, alpha) in [
            (Distribution::Ggx, (0.3, 0.3)),
            (Distribution::Beckmann, (0.5, 0.5)),
            (Distribution::Ggx, (0.2, 0.7)),
            (Distribution::Beckmann, (0.9, 0.4)),
        ] {
            for cos_o in [0.15, 0.6, 1.0] {
                let wo = Vec3::from_angles(libm::acos(cos_o), 0.9);
                let integral = glanz_math::hemisphere(300, |wi| {
                    let h = (wo + wi).normalized();
                    let d = match distribution {
                        Distribution::Beckmann => d_beckmann(h, alpha),
                        Distribution::Ggx => d_ggx(h, alpha),
                    };
                    let lambda = |w| distribution.lambda(w, alpha);
                    d * smith_g2(lambda(wo), lambda(wi)) / (4.0 * cos_o)
                });
                let got = smith_albedo(distribution, alpha, cos_o, 0.9);
                assert!((got - integral).abs() < QUADRATURE, "{alpha:?}, {cos_o}: {got} for {integral}");
            }
        }
    }

    #[test]
    fn a_mirror_loses_nothing_and_roughness_ever_more() {
        let mean = |alpha| smith_albedo_average(Distribution::Ggx, alpha);
        assert!((mean(1e-3) - 1.0).abs() < QUADRATURE);
        let means = [0.01, 0.1, 0.3, 0.6, 1.0].map(mean);
        assert!(means.windows(2).all(|pair| pair[0] > pair[1]), "{means:?}");
    }
}
