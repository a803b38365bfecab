//! Glare functions: how much of a point's light the eye scatters to each angle.

use core::f64::consts::{PI, TAU};
use std::sync::LazyLock;

use glanz_math::GaussLegendre;
use libm::{cosh, exp, sin, sqrt};

use super::within;

/// Degrees in radians.
const DEG: f64 = PI / 180.0;

/// A part c/(1 + (θ/s)²)^k of the glare function.
pub(super) struct Part {
    /// Its value at 0, in 1/sr.
    pub peak: f64,
    /// Its width s, in degrees.
    pub width_deg: f64,
    /// Its power k: 1/2, 1 or 3/2.
    pub power: f64,
}

impl Part {
    fn at(&self, theta_deg: f64) -> f64 {
        let ratio = theta_deg / self.width_deg;
        let base = 1.0 + ratio * ratio;
        match self.power {
            1.5 => self.peak / (base * sqrt(base)),
            1.0 => self.peak / base,
            _ => self.peak / sqrt(base),
        }
    }

    /// Its transform over the plane at ω = 2πρ, in the light that it holds.
    fn transform(&self, omega: f64) -> f64 {
        let (s, x) = (self.width_deg, self.width_deg * omega);
        let plane = match self.power {
            1.5 => s * s * exp(-x),
            1.0 => s * s * bessel_k0(x),
            _ => s * exp(-x) / omega,
        };
        self.peak * TAU * plane * DEG * DEG
    }
}

/// The parts of the glare function of CIE 135/1 that are powers of 1/(1 + (θ/s)²).
pub(super) fn parts(age: f64, pigment: f64) -> [Part; 5] {
    let (old, p) = (aged(age), pigment_of(pigment));
    let (core, skirt) = (1.0 - 0.08 * old, 1.0 + 1.6 * old);
    let part = |peak: f64, width_deg: f64, power: f64| Part { peak, width_deg, power };
    [
        part(core * 9.2e6, 0.0046, 1.5),
        part(core * 1.5e5, 0.045, 1.5),
        part(skirt * 400.0, 0.1, 1.0),
        part(skirt * p * 1300.0, 0.1, 1.5),
        part(skirt * p * 0.8, 0.1, 0.5),
    ]
}

/// The part of it that is the same at every angle: light through the wall of the eye, in 1/sr.
pub(super) fn uniform_part(pigment: f64) -> f64 {
    2.5e-3 * pigment_of(pigment)
}

/// (A/70)⁴.
fn aged(age: f64) -> f64 {
    let ratio = within(age, 0.0, 100.0) / 70.0;
    ratio * ratio * ratio * ratio
}

fn pigment_of(pigment: f64) -> f64 {
    within(pigment, 0.0, 1.2)
}

/// The total glare function of CIE 135/1:1999, in 1/sr: the point-spread function of the eye over the whole field.
///
/// **Formula** with a = (A/70)⁴: (1 − 0.08a)[9.2e6/(1 + (θ/0.0046)²)^1.5 + 1.5e5/(1 + (θ/0.045)²)^1.5] + (1 + 1.6a){400/(1 + (θ/0.1)²) +
/// 3e-8 θ² + p[1300/(1 + (θ/0.1)²)^1.5 + 0.8/(1 + (θ/0.1)²)^0.5]} + 2.5e-3 p.
/// **Parameters** `theta_deg` θ, 0 to 90°; `age` A in years, 0 to 100; `pigment` p of the iris and the wall of the eye: 0 very dark, 0.5
/// brown, 1 blue-green, 1.2 very light blue.
/// **Laws** its integral is not quite 1: [`vos_glare_integral`].
/// **Limits** the pupil's width and the wavelength are not in it, and neither is the ciliary corona.
/// **Source** J. J. Vos and T. J. T. P. van den Berg, CIE 135/1, 1999; coefficients as in HDR-VDP's `hdrvdp_otf_cie99.m`.
///
/// ```
/// let at_10_deg = glanz_eye::curves::vos_glare(10.0, 25.0, 0.5);
/// assert!((at_10_deg - 0.0616058).abs() < 5e-8);
/// ```
pub fn vos_glare(theta_deg: f64, age: f64, pigment: f64) -> f64 {
    let theta = within(theta_deg, 0.0, 90.0);
    let powers: f64 = parts(age, pigment).iter().map(|part| part.at(theta)).sum();
    powers + (1.0 + 1.6 * aged(age)) * 3e-8 * theta * theta + uniform_part(pigment)
}

/// The integral of [`vos_glare`] over the half space: 1.005 to 1.2, by which it is divided to keep all light.
///
/// ```
/// let all = glanz_eye::curves::vos_glare_integral(70.0, 0.5);
/// assert!((all - 1.06640).abs() < 5e-6);
/// ```
pub fn vos_glare_integral(age: f64, pigment: f64) -> f64 {
    over_half_space(|theta| vos_glare(theta, age, pigment))
}

/// ∫ f(θ) 2π sinθ dθ over 0 … 90° of a function of the angle in degrees.
pub(super) fn over_half_space(f: impl Fn(f64) -> f64) -> f64 {
    over_ring(LEAST_DEG, 90.0, &f) + f(0.0) * PI * (LEAST_DEG * DEG) * (LEAST_DEG * DEG)
}

/// Within this angle all glare functions are flat to 1e-7.
const LEAST_DEG: f64 = 1e-6;

/// The same from one angle to another: Gauss–Legendre over the logarithm of the angle, an octave at a time.
fn over_ring(from_deg: f64, to_deg: f64, f: &impl Fn(f64) -> f64) -> f64 {
    static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(8));
    let (mut sum, mut low) = (0.0, from_deg);
    while low < to_deg {
        let high = (2.0 * low).min(to_deg);
        sum += RULE.integrate(libm::log(low), libm::log(high), |log| {
            let theta = exp(log);
            f(theta) * TAU * sin(theta * DEG) * theta * DEG
        });
        low = high;
    }
    sum
}

/// The modulation transfer function of [`vos_glare`] at a spatial frequency, not normalised: divided by [`vos_glare_integral`] it is 1 at 0.
///
/// **Formula** the transforms over the plane, ω = 2πρ: (1 + θ²/s²)^−3/2 → 2πs²e^(−sω), ^−1 → 2πs²K0(sω), ^−½ → 2πs e^(−sω)/ω. The terms
/// 3e-8 θ² and 2.5e-3 p, which are wide, have no part in it.
/// **Parameters** `frequency` ρ in cycles per degree, 0.01 to 1000; `age` and `pigment` as there.
/// **Limits** the optics' own aberrations are in it only as far as the glare function has them; for 1-D gratings, as for all.
///
/// ```
/// let mtf = |frequency| glanz_eye::curves::vos_glare_mtf(frequency, 25.0, 0.5);
/// assert!(mtf(1.0) > 0.81 && mtf(30.0) < 0.16);
/// ```
pub fn vos_glare_mtf(frequency: f64, age: f64, pigment: f64) -> f64 {
    let omega = TAU * within(frequency, 0.01, 1000.0);
    parts(age, pigment).iter().map(|part| part.transform(omega)).sum()
}

/// The modified Bessel function K0(x) = ∫ e^(−x cosh t) dt: the trapezoidal rule, whose error falls exponentially there.
fn bessel_k0(x: f64) -> f64 {
    const STEP: f64 = 0.05;
    let values = (1..).map(|i| exp(-x * cosh(STEP * f64::from(i))));
    STEP * (0.5 * exp(-x) + values.take_while(|value| *value > 1e-20).sum::<f64>())
}

/// The general disability glare equation of CIE 146:2002, in 1/sr: the equivalent veiling luminance of a source, per lx at the eye.
///
/// **Formula** 10/θ³ + (5/θ² + 0.1p/θ)(1 + (A/62.5)⁴) + 0.0025p.
/// **Parameters** `theta_deg` θ from the line of sight, 0.1 to 100°; `age` A in years; `pigment` p as in [`vos_glare`].
/// **Source** CIE 146:2002, as in three programs; the factor of age is not on the first term.
///
/// ```
/// assert!((glanz_eye::curves::cie146_glare(1.0, 70.0, 0.5) - 22.9975).abs() < 5e-5);
/// ```
pub fn cie146_glare(theta_deg: f64, age: f64, pigment: f64) -> f64 {
    let (theta, p) = (within(theta_deg, 0.1, 100.0), pigment_of(pigment));
    let ratio = within(age, 0.0, 100.0) / 62.5;
    let old = 1.0 + ratio * ratio * ratio * ratio;
    10.0 / (theta * theta * theta) + (5.0 / (theta * theta) + 0.1 * p / theta) * old + 0.0025 * p
}

/// The age-adjusted Stiles–Holladay equation of CIE 146:2002, in 1/sr: 10/θ² · (1 + (A/70)⁴) from 1 to 30°.
///
/// ```
/// assert_eq!(glanz_eye::curves::stiles_holladay_glare(10.0, 70.0), 0.2);
/// ```
pub fn stiles_holladay_glare(theta_deg: f64, age: f64) -> f64 {
    let theta = within(theta_deg, 1.0, 30.0);
    10.0 / (theta * theta) * (1.0 + aged(age))
}

/// The photopic glare of computer graphics, in 1/sr: no age, no iris.
///
/// **Formula** 0.384·2.61e6·e^(−(θ/0.02)²) + 0.478·20.91/(θ + 0.02)³ + 0.138·72.37/(θ + 0.02)², θ in degrees, 0 to 90°.
/// **Source** G. Spencer, P. Shirley, K. Zimmerman, D. P. Greenberg, "Physically-based glare effects for digital images", SIGGRAPH 1995.
///
/// ```
/// use glanz_eye::curves::{spencer_photopic_glare, vos_glare};
///
/// // At 1° it is that of a young eye.
/// let ratio = spencer_photopic_glare(1.0) / vos_glare(1.0, 20.0, 0.5);
/// assert!((0.9..1.1).contains(&ratio));
/// ```
pub fn spencer_photopic_glare(theta_deg: f64) -> f64 {
    let theta = within(theta_deg, 0.0, 90.0);
    let (narrow, wide) = (theta / 0.02, theta + 0.02);
    0.384 * 2.61e6 * exp(-narrow * narrow)
        + 0.478 * 20.91 / (wide * wide * wide)
        + 0.138 * 72.37 / (wide * wide)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    #[test]
    fn the_function_of_cie_135_has_its_values() {
        // eye.md 72–73.
        assert_digits(vos_glare(1.0, 25.0, 0.5), "19.2665");
        assert_digits(vos_glare(10.0, 25.0, 0.5), "0.0616058");
    }

    #[test]
    fn its_integral_is_not_1() {
        // eye.md 75–77, and §2 for the least.
        for (age, pigment, known) in
            [(20.0, 0.5, "1.03135"), (70.0, 0.5, "1.06640"), (70.0, 1.2, "1.14447"), (20.0, 0.0, "1.00487")]
        {
            assert_digits(vos_glare_integral(age, pigment), known);
        }
    }

    #[test]
    fn its_transform_has_its_values() {
        // eye.md 78–81, at 25 years and brown eyes.
        for (frequency, known) in [(1.0, "0.81177"), (5.0, "0.46405"), (10.0, "0.31309"), (30.0, "0.15647")] {
            assert_digits(vos_glare_mtf(frequency, 25.0, 0.5), known);
        }
    }

    #[test]
    fn light_is_scattered_as_far_as_is_known() {
        // eye.md §2: light beyond 0.1, 1 and 10°, in per cent of a source of 1, before the integral is made 1.
        for (age, known) in [(20.0, ["32.7", "7.6", "3.2"]), (70.0, ["40.8", "13.9", "6.6"])] {
            for (theta, known) in [0.1, 1.0, 10.0].into_iter().zip(known) {
                let beyond = over_ring(theta, 90.0, &|theta| vos_glare(theta, age, 0.5));
                assert_digits(100.0 * beyond, known);
            }
        }
    }

    #[test]
    fn the_equations_of_cie_146_have_their_values() {
        // eye.md 82–83.
        assert_digits(cie146_glare(1.0, 70.0, 0.5), "22.9975");
        assert_digits(cie146_glare(10.0, 70.0, 0.5), "0.152794");
        assert_eq!(stiles_holladay_glare(5.0, 0.0), 0.4);
    }

    #[test]
    fn spencers_glare_keeps_all_light() {
        // eye.md §2.
        assert_digits(over_half_space(spencer_photopic_glare), "0.9996");
    }

    #[test]
    fn the_bessel_function_has_its_values() {
        // Abramowitz and Stegun, table 9.8: K0(0.1), K0(1), K0(2) e².
        assert_digits(bessel_k0(0.1), "2.4270690");
        assert_digits(bessel_k0(1.0), "0.4210244");
        assert_digits(bessel_k0(2.0) * exp(2.0), "0.8415682");
    }
}
