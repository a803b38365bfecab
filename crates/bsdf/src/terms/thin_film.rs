//! Reflectance and transmittance of more than one boundary, coherent (thin films) and incoherent (sheets). In `f64` only:
//! evaluated where tints are prepared, not per pixel.

use core::ops::{Add, Div, Mul, Sub};

use glanz_math::PI;

/// Reflectance of a thin film between air and a substrate, all reflections within it added up with their phases.
///
/// `cos_theta` (0 … 1) is the cosine of the angle of incidence in air, `eta_film` the index of the film, which does
/// not absorb, `thickness_nm` its thickness, `substrate` the complex index (η, k) below, `lambda_nm` the wavelength
/// in vacuum, which is > 0. A film of thickness 0 leaves the bare substrate.
///
/// Source: G. B. Airy 1833; M. Born and E. Wolf, Principles of Optics, §1.6.4 and §14.4. Coherent over any
/// thickness: wavelengths must lie closely enough to show the fringes of a thick film.
///
/// ```
/// use glanz_bsdf::terms::fresnel_film;
///
/// // A quarter of a wavelength of magnesium fluoride on glass, at 550 nm: ((n1² − n2)/(n1² + n2))², 1.26 %.
/// let thickness_nm = 550.0 / (4.0 * 1.38);
/// let coated = fresnel_film(1.0, 550.0, 1.38, thickness_nm, (1.52, 0.0));
/// assert!((coated - 0.0126).abs() < 1e-4);
/// // Bare glass reflects 4.26 %.
/// assert!((fresnel_film(1.0, 550.0, 1.38, 0.0, (1.52, 0.0)) - 0.0426).abs() < 1e-4);
/// ```
pub fn fresnel_film(
    cos_theta: f64,
    lambda_nm: f64,
    eta_film: f64,
    thickness_nm: f64,
    substrate: (f64, f64),
) -> f64 {
    airy(cos_theta, lambda_nm, eta_film, thickness_nm, substrate).clamp(0.0, 1.0)
}

/// [`fresnel_film`] with its rounding, which may leave 0 … 1 by a few units of the last place.
fn airy(cos_theta: f64, lambda_nm: f64, eta_film: f64, thickness_nm: f64, substrate: (f64, f64)) -> f64 {
    let cos_0 = Complex(cos_theta.clamp(0.0, 1.0), 0.0);
    let sin2 = Complex(1.0, 0.0) - cos_0 * cos_0;
    let (n0, n1, n2) = (Complex(1.0, 0.0), Complex(eta_film, 0.0), Complex(substrate.0, substrate.1));
    // Waves as exp(−iωt): a cosine's imaginary part >= 0 lets them fade with depth.
    let cosine_in = |n: Complex| (Complex(1.0, 0.0) - sin2 / (n * n)).sqrt();
    let (cos_1, cos_2) = (cosine_in(n1), cosine_in(n2));
    let phase = n1 * cos_1 * Complex(4.0 * PI * thickness_nm / lambda_nm, 0.0);
    let round = (phase * Complex(0.0, 1.0)).exp();
    let reflectance = |first: Complex, second: Complex| {
        let inner = second * round;
        ((first + inner) / (Complex(1.0, 0.0) + first * inner)).norm_squared()
    };
    // Amplitudes of a boundary: s compares n cosθ, p compares cosθ / n, both the side before with that behind.
    let step = |before: Complex, behind: Complex| {
        let sum = before + behind;
        if sum.norm_squared() == 0.0 { Complex(-1.0, 0.0) } else { (before - behind) / sum }
    };
    let s = reflectance(step(n0 * cos_0, n1 * cos_1), step(n1 * cos_1, n2 * cos_2));
    let p = reflectance(step(n1 * cos_0, n0 * cos_1), step(n2 * cos_1, n1 * cos_2));
    0.5 * (s + p)
}

/// What a plane sheet reflects and what it lets through, (R, T), all reflections within it added up without their
/// phases: for sheets many wavelengths thick.
///
/// `cos_theta` is the cosine of the angle of incidence, `eta` the index of the sheet over that around it,
/// `transmittance` (0 … 1) what is left of light that crosses the sheet once, along its slanted way.
///
/// Source: G. G. Stokes, On the intensity of the light reflected from or transmitted through a pile of plates,
/// 1862; each polarisation by itself, then the mean.
pub fn fresnel_slab(cos_theta: f64, eta: f64, transmittance: f64) -> (f64, f64) {
    let cos_0 = cos_theta.clamp(0.0, 1.0);
    let cos_1 = libm::sqrt((1.0 - (1.0 - cos_0 * cos_0) / (eta * eta)).max(0.0));
    let reflectance = |before: f64, behind: f64| {
        let amplitude = if before + behind > 0.0 { (before - behind) / (before + behind) } else { 1.0 };
        amplitude * amplitude
    };
    let sheet = |r: f64| {
        let around = r * r * transmittance * transmittance;
        if around >= 1.0 {
            return (1.0, 0.0);
        }
        let through = (1.0 - r) * (1.0 - r) * transmittance / (1.0 - around);
        (r + r * transmittance * through, through)
    };
    let (s, p) = (sheet(reflectance(cos_0, eta * cos_1)), sheet(reflectance(eta * cos_0, cos_1)));
    (0.5 * (s.0 + p.0), 0.5 * (s.1 + p.1))
}

/// A complex number, as far as films need it.
#[derive(Clone, Copy, Debug)]
struct Complex(f64, f64);

impl Complex {
    fn norm_squared(self) -> f64 {
        self.0 * self.0 + self.1 * self.1
    }
    /// The root whose imaginary part is not negative.
    fn sqrt(self) -> Self {
        let size = libm::hypot(self.0, self.1);
        let real = libm::sqrt((0.5 * (size + self.0)).max(0.0));
        let imaginary = libm::sqrt((0.5 * (size - self.0)).max(0.0));
        Self(if self.1 < 0.0 { -real } else { real }, imaginary)
    }
    fn exp(self) -> Self {
        let (sin, cos) = libm::sincos(self.1);
        let size = libm::exp(self.0);
        Self(size * cos, size * sin)
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0 - self.1 * other.1, self.0 * other.1 + self.1 * other.0)
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let scale = 1.0 / other.norm_squared();
        let product = self * Self(other.0, -other.1);
        Self(product.0 * scale, product.1 * scale)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::terms::{fresnel_conductor, fresnel_dielectric};

    /// Rounding of some dozens of operations.
    const ROUNDING: f64 = 1e-12;

    fn cosine(degrees: f64) -> f64 {
        libm::cos(degrees * PI / 180.0)
    }

    #[test]
    fn a_film_of_no_thickness_leaves_the_bare_substrate() {
        for degrees in [0.0, 30.0, 56.3, 80.0, 89.9] {
            let (c, metal) = (cosine(degrees), (0.2, 3.4));
            let (film, bare) =
                (fresnel_film(c, 550.0, 1.38, 0.0, metal), fresnel_conductor(c, metal.0, metal.1));
            assert!((film - bare).abs() < ROUNDING, "metal at {degrees}°: {film} for {bare}");
            let (film, bare) = (fresnel_film(c, 550.0, 1.38, 0.0, (1.5, 0.0)), fresnel_dielectric(c, 1.5));
            assert!((film - bare).abs() < ROUNDING, "glass at {degrees}°: {film} for {bare}");
        }
    }

    #[test]
    fn a_quarter_wave_reflects_what_the_formula_for_coatings_says() {
        // ((n0 ns − n1²) / (n0 ns + n1²))² (Born and Wolf, §1.6.4): magnesium fluoride on glass 1.26 %, and nothing
        // at all where the film's index is the root of the glass's.
        for eta in [1.38, libm::sqrt(1.52), 2.35] {
            let got = fresnel_film(1.0, 550.0, eta, 550.0 / (4.0 * eta), (1.52, 0.0));
            let amplitude = (1.52 - eta * eta) / (1.52 + eta * eta);
            assert!((got - amplitude * amplitude).abs() < ROUNDING, "{eta}: {got}");
        }
        assert!((fresnel_film(1.0, 550.0, 1.38, 550.0 / (4.0 * 1.38), (1.52, 0.0)) - 0.0126).abs() < 5e-5);
    }

    #[test]
    fn a_half_wave_is_as_if_it_were_not_there() {
        let got = fresnel_film(1.0, 600.0, 2.0, 150.0, (1.5, 0.0));
        assert!((got - 0.04).abs() < ROUNDING, "{got}");
    }

    #[test]
    fn a_soap_film_much_thinner_than_light_is_black() {
        assert!(fresnel_film(cosine(30.0), 550.0, 1.33, 5.0, (1.0, 0.0)) < 2e-3);
        assert!(fresnel_film(cosine(30.0), 550.0, 1.33, 110.0, (1.0, 0.0)) > 0.07);
    }

    #[test]
    fn a_pane_of_glass_reflects_two_surfaces_worth() {
        // 2r/(1 + r) for r = 4 % (Stokes 1862).
        let (r, t) = fresnel_slab(1.0, 1.5, 1.0);
        assert!((r - 0.08 / 1.04).abs() < ROUNDING && (t - 0.96 / 1.04).abs() < ROUNDING, "{r} {t}");
        assert_eq!(fresnel_slab(0.0, 1.5, 1.0), (1.0, 0.0));
    }

    #[test]
    fn a_black_sheet_reflects_its_first_surface_alone() {
        for degrees in [0.0, 50.0, 85.0] {
            let (r, t) = fresnel_slab(cosine(degrees), 1.5, 0.0);
            assert!((r - fresnel_dielectric(cosine(degrees), 1.5)).abs() < ROUNDING);
            assert_eq!(t, 0.0);
        }
    }

    proptest! {
        #[test]
        fn a_film_never_reflects_more_than_it_gets(
            cos_theta in 0.0..=1.0, lambda in 300.0..780.0, eta in 1.0..4.0, thickness in 0.0..5000.0,
            substrate in (0.05..5.0, 0.0..10.0),
        ) {
            let r = airy(cos_theta, lambda, eta, thickness, substrate);
            prop_assert!((0.0..=1.0 + ROUNDING).contains(&r), "{}", r);
        }

        #[test]
        fn a_sheet_that_does_not_absorb_loses_nothing(cos_theta in 0.0..=1.0, eta in 0.3..4.0) {
            let (r, t) = fresnel_slab(cos_theta, eta, 1.0);
            prop_assert!((r + t - 1.0).abs() < ROUNDING && r >= 0.0 && t >= 0.0, "{} {}", r, t);
        }

        #[test]
        fn a_sheet_that_absorbs_loses_some(cos_theta in 0.001..=1.0, eta in 1.01..4.0, left in 0.0..0.999) {
            let (r, t) = fresnel_slab(cos_theta, eta, left);
            prop_assert!(r + t < 1.0 && r >= 0.0 && t >= 0.0, "{} {}", r, t);
        }
    }
}
