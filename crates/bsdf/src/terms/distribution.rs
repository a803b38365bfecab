//! How the normals of microfacets are distributed: D, in facet area per surface area and solid angle, 1/sr.
//!
//! ∫ D(h) (n·h) dωh over the upper hemisphere is 1 for each of them but Charlie's, which is so by its own definition
//! as well. Half vectors are given in the local frame, widths as (along the tangent, along the bitangent).

use glanz_math::{GaussLegendre, PI, Real, Vec3};

/// e to the power −`x` for `x` >= 0, exactly 0 from 2^-100 on, as [`Real::pow`] has it.
#[inline(always)]
pub(crate) fn exp_of_minus<R: Real>(x: R) -> R {
    (-x).exp().select(x.lt(x.lit(69.3)), x.zero())
}

/// The slopes of `h` in parts of the widths, squared and added: tan²θh / α² where both widths are α.
#[inline(always)]
fn slope_squared<R: Real>(h: Vec3<R>, (x, y): (R, R)) -> R {
    ((h.x / x).sqr() + (h.y / y).sqr()) / h.z.sqr()
}

/// A normal distribution of slopes: exp(−tan²θh/α²) / (π αx αy cos⁴θh).
///
/// P. Beckmann and A. Spizzichino, The Scattering of Electromagnetic Waves from Rough Surfaces, 1963; the
/// elongated form as in E. Heitz, Understanding the Masking-Shadowing Function, 2014. `h` of length 1, its z > 0.
#[inline(always)]
pub fn d_beckmann<R: Real>(h: Vec3<R>, alpha: (R, R)) -> R {
    let area = h.z.lit(PI) * alpha.0 * alpha.1 * h.z.sqr().sqr();
    exp_of_minus(slope_squared(h, alpha)) / area
}

/// Trowbridge and Reitz's distribution: 1 / (π αx αy cos⁴θh (1 + tan²θh/α²)²).
///
/// T. S. Trowbridge and K. P. Reitz, Average irregularity representation of a rough surface for ray reflection,
/// 1975; named GGX by B. Walter, S. R. Marschner, H. Li and K. E. Torrance, Microfacet Models for Refraction through
/// Rough Surfaces, 2007. `h` of length 1, its z > 0.
///
/// ```
/// use glanz_bsdf::terms::d_ggx;
/// use glanz_math::Vec3;
///
/// // 1/(π α²) along the normal.
/// let (normal, alpha) = (Vec3::new(0.0, 0.0, 1.0), (0.5_f64, 0.5));
/// assert!((d_ggx(normal, alpha) * std::f64::consts::PI * 0.25 - 1.0).abs() < 1e-12);
/// // All facets together have the area of the surface.
/// let area = glanz_math::hemisphere(400, |h| d_ggx(h, alpha) * h.z);
/// assert!((area - 1.0).abs() < 1e-5);
/// ```
#[inline(always)]
pub fn d_ggx<R: Real>(h: Vec3<R>, alpha: (R, R)) -> R {
    let t = (h.x / alpha.0).sqr() + (h.y / alpha.1).sqr() + h.z.sqr();
    h.z.one() / (h.z.lit(PI) * alpha.0 * alpha.1 * t.sqr())
}

/// A normal distribution of angles: c exp(−(θh/m)²), with c from [`gaussian_scale`].
///
/// R. L. Cook and K. E. Torrance, A Reflectance Model for Computer Graphics, 1982, after Blinn 1977. `theta_h` is in
/// radians.
#[inline(always)]
pub fn d_gaussian<R: Real>(theta_h: R, m: R, scale: R) -> R {
    scale * exp_of_minus((theta_h / m).sqr())
}

/// The c of [`d_gaussian`], called arbitrary by its authors, for which the facets cover the surface:
/// 1 / ∫ exp(−(θ/m)²) cosθ dω; towards m → 0 it is 1/(π m²).
pub fn gaussian_scale(m: f64) -> f64 {
    // Beyond 7 m the exponential is below 1e-21; 48 points are exact to rounding for so smooth a function.
    let end = (7.0 * m).min(PI / 2.0);
    let value = |t: f64| libm::exp(-(t / m) * (t / m)) * libm::cos(t) * libm::sin(t);
    1.0 / (2.0 * PI * GaussLegendre::new(48).integrate(0.0, end, value))
}

/// A power of the sine, for fibres that stand up: (2 + 1/α) sin^(1/α) θh / (2π).
///
/// A. C. Estevez and C. Kulla, Production Friendly Microfacet Sheen BRDF, 2017, called Charlie there. `sin_h` is
/// 0 … 1, `alpha` 0 … 1 and not 0.
#[inline(always)]
pub fn d_charlie<R: Real>(sin_h: R, alpha: R) -> R {
    let exponent = alpha.one() / alpha;
    (exponent + exponent.lit(2.0)) * sin_h.pow(exponent) * exponent.lit(0.5 / PI)
}

#[cfg(test)]
mod tests {
    use glanz_math::hemisphere;

    use super::*;

    /// Of 400 × 800 directions, for widths from 0.1 on.
    const QUADRATURE: f64 = 1e-5;

    fn covered(d: impl Fn(Vec3<f64>) -> f64) -> f64 {
        hemisphere(400, |h| d(h) * h.z)
    }

    #[test]
    fn facets_cover_the_surface() {
        for alpha in [(0.1, 0.1), (0.3, 0.3), (1.0, 1.0), (0.2, 0.7)] {
            let (beckmann, ggx) = (covered(|h| d_beckmann(h, alpha)), covered(|h| d_ggx(h, alpha)));
            assert!((beckmann - 1.0).abs() < QUADRATURE, "Beckmann, {alpha:?}: {beckmann}");
            assert!((ggx - 1.0).abs() < QUADRATURE, "GGX, {alpha:?}: {ggx}");
        }
        for m in [0.1, 0.5, 1.0] {
            let scale = gaussian_scale(m);
            let gaussian = covered(|h| d_gaussian(libm::acos(h.z), m, scale));
            assert!((gaussian - 1.0).abs() < QUADRATURE, "Gaussian, {m}: {gaussian}");
            let charlie = covered(|h| d_charlie(libm::sqrt(1.0 - h.z * h.z), m));
            assert!((charlie - 1.0).abs() < QUADRATURE, "Charlie, {m}: {charlie}");
        }
    }

    #[test]
    fn narrow_distributions_have_the_peak_1_over_pi_alpha_squared() {
        let (up, alpha) = (Vec3::new(0.0, 0.0, 1.0), (0.01, 0.01));
        let peak = 1.0 / (PI * 1e-4);
        assert!((d_beckmann(up, alpha) / peak - 1.0).abs() < 1e-12);
        assert!((d_ggx(up, alpha) / peak - 1.0).abs() < 1e-12);
        assert!((gaussian_scale(0.01) / peak - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_width_is_that_of_its_own_axis() {
        let along = |x: f64, y: f64| Vec3::new(x, y, libm::sqrt(1.0 - x * x - y * y));
        for d in [d_beckmann::<f64>, d_ggx::<f64>] {
            assert!(d(along(0.3, 0.0), (0.5, 0.1)) > 10.0 * d(along(0.0, 0.3), (0.5, 0.1)));
        }
    }
}
