//! What is special to Beckmann's slopes with Smith's shadowing.

use glanz_math::Vec3;

use super::*;
use crate::terms::{d_beckmann, lambda_beckmann, smith_g2};
use crate::{Shape, albedo, albedo_at};

fn beckmann(alpha: f64, alpha_y: f64, multiscatter: f64) -> Beckmann {
    Beckmann::from_params(&[alpha, alpha_y, multiscatter])
}

fn directions() -> [(Vec3<f64>, Vec3<f64>); 4] {
    [(0.2, 0.5, 3.0), (1.2, 1.0, 2.9), (0.3, 0.1, 2.3), (1.5, 1.45, 3.1)]
        .map(|(o, i, phi)| (Vec3::from_angles(o, 0.4), Vec3::from_angles(i, 0.4 + phi)))
}

#[test]
fn a_single_reflection_is_the_product_of_its_terms() {
    for alpha in [(0.3, 0.3), (0.1, 0.3), (1.0, 0.2)] {
        for (wo, wi) in directions() {
            let g = smith_g2(lambda_beckmann(wo, alpha), lambda_beckmann(wi, alpha));
            let expected = d_beckmann((wo + wi).normalized(), alpha) * g / (4.0 * wo.z);
            let got = beckmann(alpha.0, alpha.1, 0.0).f_cos(&DirectionPair::new(wo, wi));
            assert!((got / expected - 1.0).abs() < 1e-11, "{alpha:?}: {got} for {expected}");
        }
    }
}

#[test]
fn equal_widths_ask_for_no_tangent() {
    for (wo, wi) in directions() {
        let bare = DirectionPair::isotropic(wo.z, wi.z, wo.dot(wi));
        let (one, two) = (beckmann(0.3, 0.0, 1.0), beckmann(0.3, 0.3, 1.0));
        assert_eq!(one.f_cos(&bare), one.f_cos(&DirectionPair::new(wo, wi)));
        assert_eq!(one.f_cos(&bare), two.f_cos(&bare));
    }
}

#[test]
fn a_white_furnace_shows_it_to_half_a_percent() {
    for alpha in [0.01, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0] {
        for degrees in [0.0, 30.0, 60.0, 80.0, 87.0] {
            let got = albedo(&Shape::Beckmann(beckmann(alpha, 0.0, 1.0)), libm::cos(degrees * PI / 180.0));
            assert!((0.995..1.0002).contains(&got), "α = {alpha} at {degrees}°: {got}");
        }
    }
}

#[test]
fn an_elongated_surface_is_white_to_a_percent_and_more_the_more_it_is_elongated() {
    for (alpha, alpha_y, loss) in [(0.05, 0.16, 0.008), (0.5, 0.3, 0.015), (0.9, 0.1, 0.12)] {
        for degrees in [0.0, 45.0, 80.0] {
            for azimuth in [0.0, 0.7, 1.5] {
                let shape = Shape::Beckmann(beckmann(alpha, alpha_y, 1.0));
                let got = albedo_at(&shape, libm::cos(degrees * PI / 180.0), azimuth);
                assert!(got > 1.0 - loss && got < 1.0002, "{alpha}/{alpha_y} at {degrees}°, {azimuth}: {got}");
            }
        }
    }
}

#[test]
fn with_little_width_is_a_mirror() {
    for degrees in [0.0, 30.0, 60.0, 80.0] {
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let single = albedo(&Shape::Beckmann(beckmann(0.001, 0.0, 0.0)), wo.z);
        assert!((single - 1.0).abs() < 1e-3, "{degrees}°: {single}");
        let at =
            |angle: f64| beckmann(0.01, 0.0, 1.0).f_cos(&DirectionPair::new(wo, Vec3::from_angles(angle * PI / 180.0, PI)));
        assert!(at(degrees) > at(degrees + 0.5) && at(degrees) > at(degrees - 0.5));
    }
}
