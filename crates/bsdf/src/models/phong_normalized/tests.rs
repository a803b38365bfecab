//! What is special to the energy-normalised Phong lobe.

use super::*;
use crate::{Shape, albedo};

fn seen(shininess: f64, cos_o: f64) -> f64 {
    albedo(&Shape::PhongNormalized(PhongNormalized::from_params(&[shininess])), cos_o)
}

#[test]
fn returns_all_light_along_the_normal() {
    for n in [0.0, 1.0, 10.0, 300.0, 1e5] {
        assert!((seen(n, 1.0) - 1.0).abs() < 2e-5, "n = {n}: {}", seen(n, 1.0));
    }
}

#[test]
fn has_the_albedo_of_lewis_for_exponent_2() {
    // n = 2 by hand: (2/π) ∫ max(R·wo, 0)² cosθi dωi is 9/16 at 60° and 1/4 at 90°.
    assert!((seen(2.0, 0.5) - 0.5625).abs() < 2e-5, "{}", seen(2.0, 0.5));
    assert!((seen(2.0, 0.0) - 0.25).abs() < 2e-5, "{}", seen(2.0, 0.0));
}

#[test]
fn with_exponent_0_is_lambert() {
    let pair = DirectionPair::isotropic(0.4f64, 0.8, 0.1);
    let (lobe, matte) = (PhongNormalized::from_params(&[0.0]), crate::models::lambert::Lambert);
    assert!((lobe.f_cos(&pair) - matte.f_cos(&pair)).abs() < 1e-15);
}

#[test]
fn is_the_classic_lobe_times_cosine_and_factor() {
    let pair = DirectionPair::isotropic(0.9f64, 0.7, 0.5);
    let classic = crate::models::phong::Phong::from_params(&[8.0]).f_cos(&pair);
    let value = PhongNormalized::from_params(&[8.0]).f_cos(&pair);
    assert!((value / (classic * 0.7 * 5.0) - 1.0).abs() < 1e-12);
}
