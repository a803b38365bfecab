//! What is special to GGX.

use glanz_math::Vec3;

use super::*;
use crate::terms::{d_ggx, lambda_ggx, smith_g2};
use crate::{Shape, albedo, albedo_at};

fn ggx(alpha: f64, alpha_y: f64, multiscatter: f64) -> Ggx {
    Ggx::from_params(&[alpha, alpha_y, multiscatter])
}

fn directions() -> [(Vec3<f64>, Vec3<f64>); 4] {
    [(0.2, 0.5, 3.0), (1.2, 1.0, 2.5), (0.8, 0.1, 0.3), (1.5, 1.45, 3.1)]
        .map(|(o, i, phi)| (Vec3::from_angles(o, 0.4), Vec3::from_angles(i, 0.4 + phi)))
}

#[test]
fn a_single_reflection_is_the_product_of_its_terms() {
    for alpha in [(0.3, 0.3), (0.05, 0.16), (1.0, 0.2)] {
        for (wo, wi) in directions() {
            let g = smith_g2(lambda_ggx(wo, alpha), lambda_ggx(wi, alpha));
            let expected = d_ggx((wo + wi).normalized(), alpha) * g / (4.0 * wo.z);
            let got = ggx(alpha.0, alpha.1, 0.0).f_cos(&DirectionPair::new(wo, wi));
            assert!((got / expected - 1.0).abs() < 1e-11, "{alpha:?}: {got} for {expected}");
        }
    }
}

#[test]
fn equal_widths_ask_for_no_tangent() {
    for (wo, wi) in directions() {
        let bare = DirectionPair::isotropic(wo.z, wi.z, wo.dot(wi));
        let (one, two) = (ggx(0.3, 0.0, 1.0), ggx(0.3, 0.3, 1.0));
        assert_eq!(one.f_cos(&bare), one.f_cos(&DirectionPair::new(wo, wi)));
        assert_eq!(one.f_cos(&bare), two.f_cos(&bare));
        assert!(!one.is_anisotropic() && !two.is_anisotropic() && ggx(0.3, 0.2, 1.0).is_anisotropic());
    }
}

#[test]
fn a_white_furnace_shows_it_to_half_a_percent() {
    for alpha in [0.01, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0] {
        for degrees in [0.0, 30.0, 60.0, 80.0, 87.0] {
            let got = albedo(&Shape::Ggx(ggx(alpha, 0.0, 1.0)), libm::cos(degrees * PI / 180.0));
            assert!((0.995..1.0002).contains(&got), "α = {alpha} at {degrees}°: {got}");
        }
    }
}

#[test]
fn an_elongated_surface_is_white_to_a_percent_and_more_the_more_it_is_elongated() {
    for (alpha, alpha_y, loss) in [(0.05, 0.16, 0.008), (0.5, 0.3, 0.012), (0.9, 0.1, 0.07)] {
        for degrees in [0.0, 45.0, 80.0] {
            for azimuth in [0.0, 0.7, 1.5] {
                let shape = Shape::Ggx(ggx(alpha, alpha_y, 1.0));
                let got = albedo_at(&shape, libm::cos(degrees * PI / 180.0), azimuth);
                assert!(got > 1.0 - loss && got < 1.0002, "{alpha}/{alpha_y} at {degrees}°, {azimuth}: {got}");
            }
        }
    }
}

#[test]
fn a_single_reflection_loses_two_thirds_at_alpha_1() {
    // By hand: D is 1/π for α = 1 and G2 along the normal is 2 cosθi/(1 + cosθi), so that with u = cosθh
    // E = 2 ∫ (2u − 1/u) du from √½ to 1 = 1 − ln 2.
    let got = albedo(&Shape::Ggx(ggx(1.0, 0.0, 0.0)), 1.0);
    assert!((got - (1.0 - core::f64::consts::LN_2)).abs() < 1e-4, "{got}");
}

#[test]
fn with_little_width_is_a_mirror() {
    for degrees in [0.0, 30.0, 60.0, 80.0] {
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let single = albedo(&Shape::Ggx(ggx(0.001, 0.0, 0.0)), wo.z);
        assert!((single - 1.0).abs() < 1e-3, "{degrees}°: {single}");
        let at = |angle: f64| ggx(0.01, 0.0, 1.0).f_cos(&DirectionPair::new(wo, Vec3::from_angles(angle * PI / 180.0, PI)));
        assert!(at(degrees) > at(degrees + 0.5) && at(degrees) > at(degrees - 0.5));
    }
}

#[test]
fn widening_multiplies_both_widths() {
    for (wo, wi) in directions() {
        let mut pair = DirectionPair::new(wo, wi);
        let expected = ggx(0.1, 0.04, 0.0).f_cos(&pair);
        pair.alpha_scale = 0.2;
        let got = ggx(0.5, 0.2, 0.0).f_cos(&pair);
        assert!((got / expected - 1.0).abs() < 1e-11, "{got} for {expected}");
        pair.alpha_scale = 0.0;
        assert!(ggx(0.5, 0.2, 1.0).f_cos(&pair).is_finite());
    }
}
