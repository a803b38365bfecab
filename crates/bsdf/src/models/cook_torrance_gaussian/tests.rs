//! What is special to the Gaussian distribution.

use glanz_math::{PI, Vec3};

use super::*;
use crate::models::cook_torrance::CookTorrance;
use crate::{Shape, albedo};

fn seen(m: f64, cos_o: f64) -> f64 {
    albedo(&Shape::CookTorranceGaussian(CookTorranceGaussian::from_params(&[m])), cos_o)
}

#[test]
fn narrow_lobes_are_those_of_beckmanns_slopes() {
    let gaussian = CookTorranceGaussian::from_params(&[0.01]);
    let beckmann = CookTorrance::from_params(&[0.01, 0.5, 0.0]);
    let wo = Vec3::from_angles(0.7, 0.0);
    for theta in [0.68, 0.7, 0.71] {
        let pair = DirectionPair::new(wo, Vec3::from_angles(theta, PI));
        assert!((gaussian.f_cos(&pair) / beckmann.f_cos(&pair) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn the_peak_for_a_spread_of_a_half_is_16_percent_higher() {
    let pair = DirectionPair::isotropic(1.0, 1.0, 1.0);
    let gaussian: f64 = CookTorranceGaussian::from_params(&[0.5]).f_cos(&pair);
    let beckmann = CookTorrance::from_params(&[0.5, 0.5, 0.0]).f_cos(&pair);
    assert!((gaussian / beckmann - 1.16).abs() < 0.02, "{}", gaussian / beckmann);
}

#[test]
fn with_little_spread_is_a_mirror() {
    for cos_o in [1.0, 0.8, 0.3] {
        assert!((seen(0.002, cos_o) - 1.0).abs() < 1e-3, "{}", seen(0.002, cos_o));
    }
    assert!(seen(0.5, 1.0) > 0.8 && seen(0.5, 1.0) < 1.0);
}
