//! Fresnel's equations: the reflectance of a smooth boundary.
//!
//! Source: A. Fresnel 1823; the forms for computing in M. Born and E. Wolf, Principles of Optics, §1.5
//! and §14.2. Schlick: "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
//!
//! ```
//! use glanz_bsdf::terms::{fresnel_conductor, fresnel_dielectric, fresnel_polarized};
//!
//! // Glass of index 1.5 at 60°, and a metal of η = 1.5, k = 3 along the normal.
//! assert!((fresnel_dielectric(0.5_f64, 1.5) - 0.089187).abs() < 1e-6);
//! assert!((fresnel_conductor(1.0_f64, 1.5, 3.0) - 0.606557).abs() < 1e-6);
//! // At Brewster's angle, whose tangent is the index, no light polarised in the plane of incidence is reflected.
//! let (s, p) = fresnel_polarized(1.0 / 3.25_f64.sqrt(), 1.5, 0.0);
//! assert!(s > 0.14 && p < 1e-12);
//! ```

use glanz_math::Real;

/// Reflectance of a boundary between two transparent media.
///
/// `cos_theta` is the cosine of the angle of incidence (0 … 1), `eta` the index of refraction on the
/// other side over that on this side. 1 where light is reflected totally, and at grazing incidence.
#[inline(always)]
pub fn fresnel_dielectric<R: Real>(cos_theta: R, eta: R) -> R {
    let one = cos_theta.one();
    let sin2_t = (one - cos_theta.sqr()) / eta.sqr();
    let cos_t = (one - sin2_t).max(one.zero()).sqrt();
    let s = (cos_theta - eta * cos_t) / (cos_theta + eta * cos_t);
    let p = (eta * cos_theta - cos_t) / (eta * cos_theta + cos_t);
    let reflected = (s.sqr() + p.sqr()) * one.lit(0.5);
    reflected.select(sin2_t.lt(one), one)
}

/// Reflectance of a boundary to an absorbing medium with the complex index η + i k.
///
/// `cos_theta` is the cosine of the angle of incidence, 0 … 1.
#[inline(always)]
pub fn fresnel_conductor<R: Real>(cos_theta: R, eta: R, k: R) -> R {
    let one = cos_theta.one();
    let (two, half) = (one.lit(2.0), one.lit(0.5));
    let cos2 = cos_theta.sqr();
    let sin2 = one - cos2;
    let t0 = eta.sqr() - k.sqr() - sin2;
    // a² + b² with a + i b = √(η² − sin²θ) is √(t0² + 4 η² k²).
    let a2_b2 = (t0.sqr() + two.sqr() * eta.sqr() * k.sqr()).sqrt();
    let a = ((a2_b2 + t0) * half).max(one.zero()).sqrt();
    let (t1, t2) = (a2_b2 + cos2, two * a * cos_theta);
    let s = (t1 - t2) / (t1 + t2);
    let (t3, t4) = (cos2 * a2_b2 + sin2.sqr(), t2 * sin2);
    let p = s * (t3 - t4) / (t3 + t4);
    (s + p) * half
}

/// Reflectance of a boundary to a medium with the complex index η + i k, of light polarised across (s) and in (p) the
/// plane of incidence: (s, p), whose mean is that of unpolarised light. In `f64` only, for preparing tints.
///
/// `cos_theta` is the cosine of the angle of incidence, 0 … 1.
pub fn fresnel_polarized(cos_theta: f64, eta: f64, k: f64) -> (f64, f64) {
    // √(η² − sin²θ) of the complex index, as a + i b (Born and Wolf, §14.2).
    let sin2 = 1.0 - cos_theta * cos_theta;
    let (re, im) = (eta * eta - k * k - sin2, 2.0 * eta * k);
    let length = libm::sqrt(re * re + im * im);
    let (a, b) = (libm::sqrt((0.5 * (length + re)).max(0.0)), libm::sqrt((0.5 * (length - re)).max(0.0)));
    let ratio = |c: f64, (a, b): (f64, f64)| {
        ((c - a) * (c - a) + b * b) / ((c + a) * (c + a) + b * b).max(f64::MIN_POSITIVE)
    };
    let s = ratio(cos_theta, (a, b));
    // The ratio of p to s: |(a − sinθ tanθ) + i b|² over the same with +.
    let grazing = sin2 / cos_theta.max(1e-300);
    let p = if cos_theta > 1e-12 { s * ratio(a, (grazing, b)) } else { 1.0 };
    (s, p)
}

/// Schlick's approximation: `f0` at normal incidence, 1 at grazing incidence.
#[inline(always)]
pub fn fresnel_schlick<R: Real>(cos_theta: R, f0: R) -> R {
    let m = (cos_theta.one() - cos_theta).clamp(0.0, 1.0);
    f0 + (m.one() - f0) * (m.sqr().sqr() * m)
}

#[cfg(test)]
mod tests {
    use glanz_math::PI;

    use super::*;

    /// Half a unit of the last digit that the reference values are given to.
    const DIGITS: f64 = 5.1e-7;

    fn cosine(degrees: f64) -> f64 {
        libm::cos(degrees * PI / 180.0)
    }

    #[test]
    fn glass_reflects_what_the_tables_say() {
        let known = [
            (0.0, 0.040_000),
            (30.0, 0.041_523),
            (45.0, 0.050_240),
            (60.0, 0.089_187),
            (75.0, 0.253_061),
            (85.0, 0.612_800),
        ];
        for (degrees, expected) in known {
            let got = fresnel_dielectric(cosine(degrees), 1.5);
            assert!((got - expected).abs() < DIGITS, "{degrees}°: {got}");
        }
    }

    #[test]
    fn metal_reflects_what_the_tables_say() {
        for (degrees, expected) in [(0.0, 0.606_557), (45.0, 0.602_581), (60.0, 0.597_310)] {
            let got = fresnel_conductor(cosine(degrees), 1.5, 3.0);
            assert!((got - expected).abs() < DIGITS, "{degrees}°: {got}");
        }
    }

    #[test]
    fn a_metal_that_does_not_absorb_is_glass() {
        for degrees in [0.0, 20.0, 56.3099, 80.0, 89.9] {
            let glass = fresnel_dielectric(cosine(degrees), 1.5);
            let metal = fresnel_conductor(cosine(degrees), 1.5, 0.0);
            assert!((glass - metal).abs() < 1e-12, "{degrees}°: {glass} and {metal}");
        }
    }

    #[test]
    fn light_that_leaves_glass_is_reflected_totally_beyond_41_81_degrees() {
        assert!(fresnel_dielectric(cosine(41.7), 1.0 / 1.5) < 1.0);
        assert_eq!(fresnel_dielectric(cosine(41.9), 1.0 / 1.5), 1.0);
    }

    #[test]
    fn everything_is_reflected_at_grazing_incidence() {
        assert_eq!(fresnel_dielectric(0.0, 1.5), 1.0);
        assert_eq!(fresnel_conductor(0.0, 0.2, 3.0), 1.0);
        assert_eq!(fresnel_schlick(0.0, 0.04), 1.0);
    }

    #[test]
    fn glass_reflects_no_light_of_one_polarisation_at_brewsters_angle() {
        let (s, p) = fresnel_polarized(cosine(45.0), 1.5, 0.0);
        assert!((s - 0.092_013).abs() < DIGITS && (p - 0.008_466).abs() < DIGITS, "{s}, {p}");
        assert!(fresnel_polarized(cosine(56.3099), 1.5, 0.0).1 < 1e-10);
        for (eta, k) in [(1.5, 0.0), (0.2, 3.0)] {
            let (s, p) = fresnel_polarized(cosine(70.0), eta, k);
            let mean = fresnel_conductor(cosine(70.0), eta, k);
            assert!((0.5 * (s + p) - mean).abs() < 1e-12, "{eta}, {k}");
        }
    }

    #[test]
    fn schlick_is_a_fifth_too_low_for_glass_at_60_degrees() {
        assert!((fresnel_schlick(cosine(60.0), 0.04) - 0.070_000).abs() < DIGITS);
    }
}
