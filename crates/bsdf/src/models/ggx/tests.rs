//! What is special to GGX.

use glanz_math::{PI, Vec3};

use super::*;
use crate::{DirectionPair, Model, Shape, albedo};

fn ggx(alpha: f64, alpha_y: f64, multiscatter: f64) -> Ggx {
    Ggx::from_params(&[alpha, alpha_y, multiscatter])
}

#[test]
fn a_single_reflection_loses_two_thirds_at_alpha_1() {
    // By hand: D is 1/π for α = 1 and G2 along the normal is 2 cosθi/(1 + cosθi), so that with u = cosθh
    // E = 2 ∫ (2u − 1/u) du from √½ to 1 = 1 − ln 2.
    let got = albedo(&Shape::Ggx(ggx(1.0, 0.0, 0.0)), 1.0);
    assert!((got - (1.0 - core::f64::consts::LN_2)).abs() < 1e-4, "{got}");
}

#[test]
fn alpha_scale_multiplies_both_widths() {
    for (theta_o, theta_i, phi) in [(0.2, 0.5, 3.0), (1.2, 1.0, 2.5), (0.8, 0.1, 0.3), (1.5, 1.45, PI)] {
        let (wo, wi) = (Vec3::from_angles(theta_o, 0.4), Vec3::from_angles(theta_i, 0.4 + phi));
        let mut pair = DirectionPair::new(wo, wi);
        let expected = ggx(0.1, 0.04, 0.0).f_cos(&pair);
        pair.alpha_scale = 0.2;
        let got = ggx(0.5, 0.2, 0.0).f_cos(&pair);
        assert!((got / expected - 1.0).abs() < 1e-11, "{got} for {expected}");
        pair.alpha_scale = 0.0;
        assert!(ggx(0.5, 0.2, 1.0).f_cos(&pair).is_finite());
    }
}
