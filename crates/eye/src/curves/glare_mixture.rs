//! The glare function as a sum of Gaussians, which a pyramid of blurs can draw.

use core::f64::consts::{LN_2, PI};

use libm::{exp, exp2, pow, sqrt};

use super::glare::{over_half_space, parts, uniform_part};
use super::within;

/// A Gaussian in which a share of the light is spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// The share of all light, 0 to 1.
    pub weight: f64,
    /// Its standard deviation along each axis, in degrees.
    pub sigma_deg: f64,
}

impl Gaussian {
    /// The light per sr at an angle from the source, for a source of 1: the weight over the half space.
    pub fn density(&self, theta_deg: f64) -> f64 {
        self.weight * bell(theta_deg, self.sigma_deg) / solid_angle(self.sigma_deg)
    }
}

fn bell(theta_deg: f64, sigma_deg: f64) -> f64 {
    let ratio = theta_deg / sigma_deg;
    exp(-0.5 * ratio * ratio)
}

/// The integral of e^(−θ²/2σ²) over the half space, in sr: 2πσ² for narrow ones, 2π for the widest.
fn solid_angle(sigma_deg: f64) -> f64 {
    over_half_space(|theta| bell(theta, sigma_deg))
}

/// How the glare function is split into Gaussians.
///
/// ```
/// use glanz_eye::curves::GlareMixture;
///
/// let only_wide = GlareMixture { least_sigma_deg: 0.1, ..GlareMixture::new(70.0, 0.5) };
/// let spread: f64 = only_wide.gaussians().iter().map(|gaussian| gaussian.weight).sum();
/// // The viewer's own eye adds what lies near the source; less than half of the light goes farther.
/// assert!(spread > 0.2 && spread < 0.4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlareMixture {
    /// The age in years, 0 to 100.
    pub age: f64,
    /// The pigment of the eye, 0 to 1.2: see [`vos_glare`](super::vos_glare).
    pub pigment: f64,
    /// Gaussians per octave of their widths, 1 to 8: with 1 the mixture is within 2.5 % of the function over 0.002 to 30°, with 2 within
    /// 1 %.
    pub per_octave: u32,
    /// Gaussians that are narrower, in degrees, are left out, and their light stays where it is: what is shown on a screen is spread by
    /// the viewer's own eye again, which adds the small angles. 0 keeps all.
    pub least_sigma_deg: f64,
}

/// The widths from narrowest to widest, as powers of 2 of a degree: at 0.0005° the narrowest part of the function is flat, and a
/// Gaussian of 256° is nearly so over the half space.
const EXPONENTS: (i32, i32) = (-11, 8);
/// Octaves beyond the widest whose light is added to it; after so many nothing is left.
const BEYOND: i32 = 40;

impl GlareMixture {
    /// All Gaussians, one an octave.
    pub fn new(age: f64, pigment: f64) -> Self {
        Self { age, pigment, per_octave: 1, least_sigma_deg: 0.0 }
    }

    /// The Gaussians, the narrowest first. Their weights add up to 1 where none is left out; else the rest stays at the source.
    ///
    /// **Formula** c(1 + θ²/s²)^−k = Σ w e^(−θ²/2σ²) with e = s²/2σ² and w = c/Γ(k) · e^k · e^−e · 2 ln 2 for an octave (the integral that
    /// defines Γ, by the midpoint rule). The uniform part of the function is in the widest Gaussian; its term 3e-8 θ², at most 0.5 %
    /// up to 30°, is left out. Normalised by number.
    pub fn gaussians(&self) -> Vec<Gaussian> {
        let per_octave = self.per_octave.clamp(1, 8) as i32;
        let step = 1.0 / f64::from(per_octave);
        let sigma_deg = |index: i32| exp2(f64::from(EXPONENTS.0) + step * f64::from(index));
        let peak = |index: i32| self.peak(sigma_deg(index)) * 2.0 * LN_2 * step;
        let last = (EXPONENTS.1 - EXPONENTS.0) * per_octave;
        let beyond: f64 = (last + 1..=last + BEYOND * per_octave).map(peak).sum();
        let gaussian = |index: i32| {
            let more = if index == last { beyond + uniform_part(self.pigment) } else { 0.0 };
            let sigma_deg = sigma_deg(index);
            Gaussian { weight: (peak(index) + more) * solid_angle(sigma_deg), sigma_deg }
        };
        let mut gaussians: Vec<_> = (0..=last).map(gaussian).collect();
        let all: f64 = gaussians.iter().map(|gaussian| gaussian.weight).sum();
        for gaussian in &mut gaussians {
            gaussian.weight /= all;
        }
        gaussians.retain(|gaussian| gaussian.sigma_deg >= within(self.least_sigma_deg, 0.0, f64::MAX));
        gaussians
    }

    /// The peaks of all parts of the function per natural logarithm of the squared width.
    fn peak(&self, sigma_deg: f64) -> f64 {
        let part = |part: &super::glare::Part| {
            let ratio = part.width_deg / sigma_deg;
            let e = 0.5 * ratio * ratio;
            let gamma = match part.power {
                1.5 => 0.5 * sqrt(PI),
                1.0 => 1.0,
                _ => sqrt(PI),
            };
            part.peak / gamma * pow(e, part.power) * exp(-e)
        };
        parts(self.age, self.pigment).iter().map(part).sum()
    }
}

/// The glare function of CIE 135/1 as Gaussians in octaves, the narrowest first; their weights add up to 1.
///
/// [`GlareMixture`] has half octaves, and leaves narrow Gaussians out.
///
/// ```
/// use glanz_eye::curves::{mixture, vos_glare, vos_glare_integral};
///
/// let gaussians = mixture(25.0, 0.5);
/// let at_3_deg: f64 = gaussians.iter().map(|gaussian| gaussian.density(3.0)).sum();
/// let exact = vos_glare(3.0, 25.0, 0.5) / vos_glare_integral(25.0, 0.5);
/// assert!((at_3_deg / exact - 1.0).abs() < 0.025);
/// ```
pub fn mixture(age: f64, pigment: f64) -> Vec<Gaussian> {
    GlareMixture::new(age, pigment).gaussians()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::{vos_glare, vos_glare_integral};

    /// The greatest difference of a mixture from the function, both normalised, over 0.002 to 30°.
    fn worst(mixture: GlareMixture) -> f64 {
        let gaussians = mixture.gaussians();
        let solid: Vec<_> = gaussians.iter().map(|gaussian| solid_angle(gaussian.sigma_deg)).collect();
        let all = vos_glare_integral(mixture.age, mixture.pigment);
        let error = |index: i32| {
            let theta = 0.002 * pow(15_000.0, f64::from(index) / 200.0);
            let shares = gaussians.iter().zip(&solid);
            let found: f64 = shares.map(|(g, solid)| g.weight / solid * bell(theta, g.sigma_deg)).sum();
            (found * all / vos_glare(theta, mixture.age, mixture.pigment) - 1.0).abs()
        };
        (0..=200).map(error).fold(0.0, f64::max)
    }

    /// What the midpoint rule errs by in octaves and in half octaves, with the term that is left out.
    const OCTAVES: f64 = 0.025;
    const HALF_OCTAVES: f64 = 0.01;

    #[test]
    fn the_mixture_is_the_function_of_cie_135() {
        for (age, pigment) in [(20.0, 0.0), (20.0, 0.5), (70.0, 0.5), (80.0, 1.2)] {
            let octaves = GlareMixture::new(age, pigment);
            let (coarse, fine) = (worst(octaves), worst(GlareMixture { per_octave: 2, ..octaves }));
            assert!(coarse < OCTAVES, "{age} {pigment}: {coarse}");
            assert!(fine < HALF_OCTAVES && fine < coarse, "{age} {pigment}: {fine}");
        }
    }

    #[test]
    fn all_light_is_kept() {
        /// Of a sum of twenty shares.
        const ROUNDING: f64 = 1e-14;
        for (age, pigment) in [(20.0, 0.5), (80.0, 1.2)] {
            let gaussians = mixture(age, pigment);
            assert!(gaussians.windows(2).all(|pair| pair[1].sigma_deg == 2.0 * pair[0].sigma_deg));
            let all: f64 = gaussians.iter().map(|gaussian| gaussian.weight).sum();
            assert!((all - 1.0).abs() < ROUNDING, "{all}");
        }
    }

    #[test]
    fn what_is_left_out_is_what_is_narrow_and_nothing_else_changes() {
        let all = GlareMixture::new(70.0, 0.5);
        let wide = GlareMixture { least_sigma_deg: 0.1, ..all }.gaussians();
        let kept: Vec<_> = all.gaussians().into_iter().filter(|gaussian| gaussian.sigma_deg >= 0.1).collect();
        assert_eq!(wide, kept);
        assert!(wide.len() < all.gaussians().len() && wide[0].sigma_deg == 0.125);
    }

    #[test]
    fn a_narrow_gaussian_lies_in_a_plane() {
        let sigma = 0.25;
        let plane = 2.0 * PI * (sigma * PI / 180.0) * (sigma * PI / 180.0);
        // The sphere curves away by σ².
        assert!((solid_angle(sigma) / plane - 1.0).abs() < 2e-5);
    }
}
