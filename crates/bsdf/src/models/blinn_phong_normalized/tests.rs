//! What is special to the energy-normalised Blinn–Phong lobe.

use super::*;
use crate::models::blinn_phong::BlinnPhong;
use crate::{Shape, albedo};

fn lobe(shininess: f64) -> BlinnPhongNormalized {
    BlinnPhongNormalized::from_params(&[shininess])
}

#[test]
fn returns_all_light_along_the_normal() {
    for n in [0.0, 1.0, 10.0, 300.0, 1e5] {
        let got = albedo(&Shape::BlinnPhongNormalized(lobe(n)), 1.0);
        assert!((got - 1.0).abs() < 2e-5, "n = {n}: {got}");
    }
}

#[test]
fn has_the_albedo_of_an_independent_quadrature() {
    // 400 × 800 points in another program.
    for (n, cos_o, expected) in [(2.0, 0.5, 0.7), (100.0, 0.5, 0.26506), (8.0, 0.0, 0.12403)] {
        let got = albedo(&Shape::BlinnPhongNormalized(lobe(n)), cos_o);
        assert!((got - expected).abs() < 2e-5, "n = {n}: {got}");
    }
}

#[test]
fn is_the_classic_lobe_times_cosine_and_factor() {
    // n = 2: (4·6)/(8π(1/2 + 2)) = 1.2/π.
    let pair = DirectionPair::isotropic(0.9f64, 0.7, 0.5);
    let classic = BlinnPhong::from_params(&[2.0]).f_cos(&pair);
    assert!((lobe(2.0).f_cos(&pair) / (classic * 0.7 * 1.2) - 1.0).abs() < 1e-12);
}

#[test]
fn with_exponent_0_is_lambert() {
    let pair = DirectionPair::isotropic(0.4f64, 0.8, 0.1);
    let matte = crate::models::lambert::Lambert.f_cos(&pair);
    assert!((lobe(0.0).f_cos(&pair) - matte).abs() < 1e-15);
}
