//! What is special to the full model of Oren and Nayar.

use glanz_math::Vec3;

use super::*;
use crate::models::lambert::Lambert;
use crate::{Shape, albedo};

/// The functional model in angles, as printed, for reflectance 1: L1 and L2 over the incident cosine, times
/// π.
fn printed(sigma_deg: f64, theta_i: f64, theta_o: f64, phi: f64) -> (f64, f64) {
    let v = libm::pow(sigma_deg * PI / 180.0, 2.0);
    let (alpha, beta) = (theta_i.max(theta_o), theta_i.min(theta_o));
    let (cos_phi, ratio) = (libm::cos(phi), 2.0 * beta / PI);
    let c1 = 1.0 - 0.5 * v / (v + 0.33);
    let slope = if cos_phi >= 0.0 { libm::sin(alpha) } else { libm::sin(alpha) - ratio * ratio * ratio };
    let c2 = 0.45 * v / (v + 0.09) * slope;
    let c3 = 0.125 * v / (v + 0.09) * libm::pow(4.0 * alpha * beta / (PI * PI), 2.0);
    let sides = (1.0 - cos_phi.abs()) * c3 * libm::tan((alpha + beta) / 2.0);
    let between = 0.17 * v / (v + 0.13) * (1.0 - cos_phi * ratio * ratio);
    (c1 + cos_phi * c2 * libm::tan(beta) + sides, between)
}

fn pair(theta_i: f64, theta_o: f64, phi: f64) -> DirectionPair<f64> {
    DirectionPair::new(Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(theta_i, phi))
}

#[test]
fn is_the_formula_of_the_paper_in_angles() {
    let radians = PI / 180.0;
    for sigma_deg in [5.0, 20.0, 60.0] {
        for (i, o, phi) in [
            (0.0, 0.0, 0.0),
            (30.0, 70.0, 10.0),
            (70.0, 30.0, 80.0),
            (50.0, 40.0, 130.0),
            (60.0, 60.0, 179.0),
        ] {
            let (i, o, phi) = (i * radians, o * radians, phi * radians);
            let (first, second) = printed(sigma_deg, i, o, phi);
            for rho in [0.0, 0.3, 1.0] {
                let got = OrenNayar::from_params(&[sigma_deg, rho]).f_cos(&pair(i, o, phi));
                let expected = libm::cos(i) / PI * (first + rho * second);
                assert!(
                    (got - expected).abs() < 1e-9 * expected,
                    "σ = {sigma_deg}°, ρ = {rho}: {got} for {expected}"
                );
            }
        }
    }
}

#[test]
fn without_slopes_is_lambert() {
    for rho in [0.0, 1.0] {
        let smooth = OrenNayar::from_params(&[0.0, rho]);
        for (i, o, phi) in [(0.1, 0.2, 0.3), (1.5, 1.4, 3.1), (1.2, 0.0, 2.0)] {
            assert_eq!(smooth.f_cos(&pair(i, o, phi)), Lambert.f_cos(&pair(i, o, phi)));
        }
    }
}

#[test]
fn sends_more_light_back_than_on() {
    let rough = OrenNayar::from_params(&[30.0, 1.0]);
    assert!(rough.f_cos(&pair(1.0, 1.0, 0.0)) > 1.5 * rough.f_cos(&pair(1.0, 1.0, PI)));
}

#[test]
fn is_black_where_the_fit_falls_below_zero() {
    let grazing = 85.0 * PI / 180.0;
    let (first, _) = printed(60.0, grazing, grazing, PI);
    assert!(first < 0.0);
    assert_eq!(OrenNayar::from_params(&[60.0, 0.0]).f_cos(&pair(grazing, grazing, PI)), 0.0);
}

#[test]
fn returns_a_twentieth_too_much_at_most() {
    let seen = |sigma| albedo(&Shape::named("oren-nayar", &[("sigma_deg", sigma)]).unwrap(), 1e-4);
    let most = (0..=90).map(|sigma| seen(f64::from(sigma))).fold(0.0, f64::max);
    assert!((most - 1.051).abs() < 5e-4, "{most}");
    assert!(seen(33.0) > 1.0 && seen(37.0) < 1.0);
}
