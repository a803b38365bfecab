//! What is special to rough refraction.

use glanz_math::Vec3;

use super::*;
use crate::terms::{d_ggx, lambda_ggx, smith_g1};
use crate::{Shape, albedo};

fn lobe(alpha: f64, eta: f64) -> GgxTransmission {
    GgxTransmission::from_params(&[alpha, eta])
}

#[test]
fn is_the_product_of_its_terms() {
    for eta in [1.5, 1.0 / 1.5] {
        for (theta_o, theta_i, phi) in [(0.3, 0.3, 3.0), (0.6, 0.2, 2.5), (0.1, 0.5, 3.1)] {
            let (wo, wi) = (Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(PI - theta_i, phi));
            let sum = (wo + wi * eta).normalized();
            let h = if sum.z < 0.0 { -sum } else { sum };
            let (oh, ih) = (wo.dot(h), wi.dot(h));
            assert!(oh > 0.0 && ih < 0.0);
            let alpha = (0.4, 0.4);
            let up = Vec3::new(wi.x, wi.y, -wi.z);
            let g = smith_g1(lambda_ggx(wo, alpha)) * smith_g1(lambda_ggx(up, alpha));
            let expected = d_ggx(h, alpha) * g * oh * -ih / (wo.z * (oh + eta * ih) * (oh + eta * ih));
            let got = lobe(0.4, eta).f_cos(&DirectionPair::new(wo, wi));
            assert!((got / expected - 1.0).abs() < 1e-11, "{got} for {expected}");
            assert!((lobe(0.4, eta).tint_cosine(&DirectionPair::new(wo, wi)) - oh).abs() < 1e-12);
        }
    }
}

#[test]
fn with_little_width_is_perfect_refraction() {
    for (eta, degrees) in [(1.5, 0.0), (1.5, 60.0), (1.5, 80.0), (0.75, 0.0), (0.75, 40.0)] {
        let cosine = libm::cos(degrees * PI / 180.0);
        let got = eta * eta * albedo(&Shape::GgxTransmission(lobe(0.001, eta)), cosine);
        assert!((got - 1.0).abs() < 2e-3, "{eta} at {degrees}°: {got}");
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let bent = libm::asin(libm::sqrt(1.0 - cosine * cosine) / eta);
        let at = |angle: f64| lobe(0.01, eta).f_cos(&DirectionPair::new(wo, Vec3::from_angles(PI - angle, PI)));
        assert!(at(bent) > at(bent + 0.01) && at(bent) > at(bent - 0.01), "{eta} at {degrees}°");
    }
}

#[test]
fn without_a_difference_of_indices_it_is_as_with_a_small_one() {
    let pair = DirectionPair::new(Vec3::from_angles(0.3, 0.0), Vec3::from_angles(PI - 0.3, PI));
    assert_eq!(lobe(0.3, 1.0).f_cos(&pair), lobe(0.3, 1.01).f_cos(&pair));
    assert!(lobe(0.3, 1.0).f_cos(&pair).is_finite());
}
