//! What is special to the short form of Oren and Nayar.

use glanz_math::Vec3;

use super::*;
use crate::models::lambert::Lambert;
use crate::{Shape, albedo};

fn pair(theta_i: f64, theta_o: f64, phi: f64) -> DirectionPair<f64> {
    DirectionPair::new(Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(theta_i, phi))
}

fn seen(sigma_deg: f64, cos_o: f64) -> f64 {
    albedo(&Shape::named("oren-nayar-qualitative", &[("sigma_deg", sigma_deg)]).unwrap(), cos_o)
}

#[test]
fn is_the_formula_of_the_paper_in_angles() {
    let v = libm::pow(25.0 * PI / 180.0, 2.0);
    let (a, b) = (1.0 - 0.5 * v / (v + 0.33), 0.45 * v / (v + 0.09));
    for (i, o, phi) in [(0.0, 0.0, 0.0), (0.5, 1.2, 0.1), (1.2, 0.5, 1.4), (0.9, 0.8, 2.5), (1.4, 1.5, 0.0)] {
        let (alpha, beta) = (f64::max(i, o), f64::min(i, o));
        let f = (a + b * libm::cos(phi).max(0.0) * libm::sin(alpha) * libm::tan(beta)) / PI;
        let got = OrenNayarQualitative::from_params(&[25.0]).f_cos(&pair(i, o, phi));
        let expected = f * libm::cos(i);
        assert!((got - expected).abs() < 1e-12, "{i}, {o}, {phi}: {got} for {expected}");
    }
}

#[test]
fn without_slopes_is_lambert() {
    let smooth = OrenNayarQualitative::from_params(&[0.0]);
    for (i, o, phi) in [(0.1, 0.2, 0.3), (1.5, 1.4, 3.1), (1.2, 0.0, 2.0)] {
        assert_eq!(smooth.f_cos(&pair(i, o, phi)), Lambert.f_cos(&pair(i, o, phi)));
    }
}

#[test]
fn seen_along_the_normal_has_the_albedo_a() {
    for sigma_deg in [10.0, 45.0, 90.0] {
        let v = libm::pow(sigma_deg * PI / 180.0, 2.0);
        assert!((seen(sigma_deg, 1.0) - (1.0 - 0.5 * v / (v + 0.33))).abs() < 1e-5);
    }
}

#[test]
fn returns_a_little_too_much_when_grazed_and_little_when_very_rough() {
    // Along the surface the second term has the albedo B/2: 1 − σ²/(2(σ²+0.33)) + 9σ²/(40(σ²+0.09)).
    for (sigma_deg, expected) in [(5.0, 1.006_3), (11.0, 1.015_1), (18.0, 1.002_6), (19.0, 0.998_8)] {
        let got = seen(sigma_deg, 1e-5);
        assert!((got - expected).abs() < 1e-4, "σ = {sigma_deg}°: {got}");
    }
    assert!(seen(45.0, 1.0) < 0.68);
}

#[test]
fn is_the_same_for_all_forward_light() {
    let rough = OrenNayarQualitative::from_params(&[40.0]);
    let there = |phi| rough.f_cos(&pair(0.8, 0.7, phi));
    assert!((there(PI) - there(2.0)).abs() < 1e-15 && there(1.0) > 1.05 * there(PI));
}
