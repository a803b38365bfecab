//! Masking and shadowing of microfacets: Smith's Λ, G1 and G2, and the V-grooves of Torrance and Sparrow.
//!
//! Directions are given in the local frame, above the surface; widths as (along the tangent, along the bitangent).

use glanz_math::{Real, Vec3};

/// α² tan²θ for the width along the direction: αx² x² + αy² y² over z².
#[inline(always)]
fn stretched_squared<R: Real>(w: Vec3<R>, alpha: (R, R)) -> R {
    ((alpha.0 * w.x).sqr() + (alpha.1 * w.y).sqr()) / w.z.sqr()
}

/// Smith's Λ of the GGX distribution: (√(1 + α² tan²θ) − 1) / 2.
///
/// B. Walter and others, Microfacet Models for Refraction through Rough Surfaces, 2007, as Λ in E. Heitz,
/// Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, 2014, equation 72.
#[inline(always)]
pub fn lambda_ggx<R: Real>(w: Vec3<R>, alpha: (R, R)) -> R {
    let one = w.z.one();
    ((one + stretched_squared(w, alpha)).sqrt() - one) * one.lit(0.5)
}

/// Smith's Λ of Beckmann's distribution, in the rational approximation of Walter and others 2007 (within 0.35 %
/// of G1) rather than the exact form with erf: 0 from a = 1/(α tanθ) = 1.6 on, else
/// (1 − 1.259 a + 0.396 a²) / (3.535 a + 2.181 a²).
///
/// E. Heitz 2014, equation 77.
#[inline(always)]
pub fn lambda_beckmann<R: Real>(w: Vec3<R>, alpha: (R, R)) -> R {
    let one = w.z.one();
    let a = stretched_squared(w, alpha).max(one.lit(1e-20)).rsqrt();
    let above = one - one.lit(1.259) * a + one.lit(0.396) * a.sqr();
    let below = one.lit(3.535) * a + one.lit(2.181) * a.sqr();
    (above / below).select(a.lt(one.lit(1.6)), one.zero())
}

/// Smith's G1, the fraction of the facets turned to a direction that is visible from it: 1 / (1 + Λ).
///
/// B. G. Smith, Geometrical shadowing of a random rough surface, 1967.
///
/// ```
/// use glanz_bsdf::terms::{lambda_ggx, smith_g1, smith_g2};
/// use glanz_math::Vec3;
///
/// // At 45°, α = 1: Λ is (√2 − 1)/2, so that 83 % of the facets are visible and 71 % both visible and lit.
/// let w = Vec3::from_angles(std::f64::consts::FRAC_PI_4, 0.0);
/// let lambda = lambda_ggx(w, (1.0, 1.0));
/// assert!((smith_g1(lambda) - 0.8284).abs() < 1e-4 && (smith_g2(lambda, lambda) - 0.7071).abs() < 1e-4);
/// ```
#[inline(always)]
pub fn smith_g1<R: Real>(lambda: R) -> R {
    lambda.one() / (lambda.one() + lambda)
}

/// Smith's G2, the fraction that is both visible and lit, where the height of a facet counts for both: 1 / (1 + Λo + Λi).
///
/// Height-correlated masking and shadowing: E. Heitz 2014, equation 99.
#[inline(always)]
pub fn smith_g2<R: Real>(lambda_o: R, lambda_i: R) -> R {
    lambda_o.one() / (lambda_o.one() + lambda_o + lambda_i)
}

/// The fraction that is both visible and lit in V-grooves: min(1, 2 (n·h)(n·wo)/(wo·h), 2 (n·h)(n·wi)/(wo·h)).
///
/// K. E. Torrance and E. M. Sparrow, Theory for Off-Specular Reflection from Roughened Surfaces, 1967; the short form
/// of J. F. Blinn 1977 as in R. L. Cook and K. E. Torrance 1982.
#[inline(always)]
pub fn g_v_cavity<R: Real>(cos_h: R, cos_o: R, cos_i: R, cos_view_half: R) -> R {
    let least = cos_o.min(cos_i);
    ((cos_h + cos_h) * least / cos_view_half).min(cos_h.one())
}

#[cfg(test)]
mod tests {
    use glanz_math::{PI, hemisphere};

    use super::*;
    use crate::terms::{d_beckmann, d_ggx};

    fn view(degrees: f64) -> Vec3<f64> {
        Vec3::from_angles(degrees * PI / 180.0, 0.6)
    }

    /// The facets seen must cover what the surface covers: G1 ∫ max(wo·h, 0) D dωh = cosθo (Heitz 2014, eq. 16).
    fn seen(wo: Vec3<f64>, d: impl Fn(Vec3<f64>) -> f64) -> f64 {
        hemisphere(300, |h| d(h) * wo.dot(h).max(0.0)) / wo.z
    }

    #[test]
    fn seen_facets_cover_the_surface_from_every_angle() {
        // The error that the authors of the rational approximation state.
        const APPROXIMATION: f64 = 3.5e-3;
        for degrees in [0.0, 40.0, 75.0, 88.0] {
            for alpha in [(0.2, 0.2), (0.6, 0.6), (0.15, 0.5)] {
                let wo = view(degrees);
                let ggx = seen(wo, |h| d_ggx(h, alpha)) * smith_g1(lambda_ggx(wo, alpha));
                assert!((ggx - 1.0).abs() < 1e-4, "GGX {alpha:?} at {degrees}°: {ggx}");
                let beckmann = seen(wo, |h| d_beckmann(h, alpha)) * smith_g1(lambda_beckmann(wo, alpha));
                assert!(
                    (beckmann - 1.0).abs() < APPROXIMATION,
                    "Beckmann {alpha:?} at {degrees}°: {beckmann}"
                );
            }
        }
    }

    #[test]
    fn heights_that_count_for_both_leave_more_than_independent_fractions() {
        let lambda = lambda_ggx(view(70.0), (0.5, 0.5));
        assert!(smith_g2(lambda, lambda) > smith_g1(lambda) * smith_g1(lambda));
        assert!(smith_g2(lambda, lambda) < smith_g1(lambda));
        assert_eq!(smith_g2(lambda, 0.0), smith_g1(lambda));
    }

    #[test]
    fn a_groove_shadows_nothing_in_the_middle_and_all_at_grazing() {
        assert_eq!(g_v_cavity(1.0, 0.8, 0.8, 0.8), 1.0);
        assert!((g_v_cavity(0.9, 0.1, 0.8, 0.6) - 0.3).abs() < 1e-15);
        assert_eq!(g_v_cavity(0.7, 0.0, 0.8, 0.6), 0.0);
    }
}
