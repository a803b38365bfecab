//! What is special to the rough matte lobe that keeps energy.

use glanz_math::{GaussLegendre, Vec3};

use super::*;
use crate::models::lambert::Lambert;
use crate::{Shape, albedo};

/// What the quadrature of albedos adds.
const QUADRATURE: f64 = 2e-5;

fn eon(roughness: f64, rho: f64) -> Shape {
    Shape::named("eon", &[("roughness", roughness), ("rho", rho)]).unwrap()
}

/// The single scattering of the paper (its equations for Fujii's form) in angles.
fn single(r: f64, theta_i: f64, theta_o: f64, phi: f64) -> f64 {
    let s = libm::sin(theta_i) * libm::sin(theta_o) * libm::cos(phi);
    let t = if s > 0.0 { libm::cos(theta_i).max(libm::cos(theta_o)) } else { 1.0 };
    (1.0 + r * s / t) / (PI + (PI / 2.0 - 2.0 / 3.0) * r)
}

/// Its directional albedo by quadrature, which knows nothing of the closed form.
fn single_albedo(r: f64, theta_o: f64) -> f64 {
    let rule = GaussLegendre::new(24);
    let (low, high, half) = (theta_o, PI / 2.0, PI / 2.0);
    let strip = |theta: f64| {
        let f = |phi| single(r, theta, theta_o, phi);
        2.0 * (rule.integrate(0.0, half, f) + rule.integrate(half, PI, f))
            * libm::sin(theta)
            * libm::cos(theta)
    };
    rule.integrate(0.0, low, strip) + rule.integrate(low, high, strip)
}

#[test]
fn is_the_formula_of_the_paper_with_albedos_by_quadrature() {
    let rule = GaussLegendre::new(24);
    for r in [0.2, 1.0] {
        let average = rule.integrate(0.0, PI / 2.0, |t| single_albedo(r, t) * libm::sin(2.0 * t));
        for rho in [0.1, 0.8, 1.0] {
            let color = rho * rho * average / (1.0 - rho * (1.0 - average));
            for (i, o, phi) in [(0.3, 1.0, 0.5), (1.2, 1.3, 2.9), (0.7, 0.2, 1.7)] {
                let lost = |theta| 1.0 - single_albedo(r, theta);
                let f = rho * single(r, i, o, phi) + color / PI * lost(i) * lost(o) / (1.0 - average);
                let pair = DirectionPair::new(Vec3::from_angles(o, 0.0), Vec3::from_angles(i, phi));
                let got = rho * Eon::from_params(&[r, rho]).f_cos(&pair);
                let expected = f * libm::cos(i);
                assert!((got - expected).abs() < 1e-7, "r = {r}, ρ = {rho}: {got} for {expected}");
            }
        }
    }
}

#[test]
fn a_white_furnace_stays_white() {
    for roughness in [0.0, 0.1, 0.5, 1.0] {
        for cos_o in [1.0, 0.8, 0.5, 0.2, 0.01, 1e-4] {
            let got = albedo(&eon(roughness, 1.0), cos_o);
            assert!((got - 1.0).abs() < QUADRATURE, "r = {roughness}, cosθ = {cos_o}: {got}");
        }
    }
}

#[test]
fn without_roughness_is_lambert_for_every_reflectance() {
    for rho in [0.0, 0.5, 1.0] {
        for (i, o, phi) in [(0.1, 0.2, 0.3), (1.5, 1.4, 3.1), (1.2, 0.0, 2.0)] {
            let pair = DirectionPair::new(Vec3::from_angles(o, 0.0), Vec3::from_angles(i, phi));
            assert_eq!(Eon::from_params(&[0.0, rho]).f_cos(&pair), Lambert.f_cos(&pair));
        }
    }
}

#[test]
fn darker_walls_scatter_less_than_their_tint_alone_says() {
    let seen = |rho| albedo(&eon(1.0, rho), 0.9);
    assert!(seen(0.0) < seen(0.5) && seen(0.5) < seen(1.0));
    assert!((seen(0.0) - single_albedo(1.0, libm::acos(0.9))).abs() < QUADRATURE);
}
