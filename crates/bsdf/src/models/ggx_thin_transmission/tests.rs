//! What is special to thin sheets.

use glanz_math::Vec3;

use super::*;
use crate::{Shape, albedo};

#[test]
fn is_the_reflection_of_the_light_mirrored() {
    let (wo, wi) = (Vec3::from_angles(0.7f64, 0.0), Vec3::from_angles(0.5, 2.8));
    let through = GgxThinTransmission::from_params(&[0.3]);
    let behind = DirectionPair::new(wo, Vec3::new(wi.x, wi.y, -wi.z));
    let expected = Ggx::from_params(&[0.3, 0.0, 0.0]).f_cos(&DirectionPair::new(wo, wi));
    assert!((through.f_cos(&behind) / expected - 1.0).abs() < 1e-12);
    assert!((through.tint_cosine(&behind) - DirectionPair::new(wo, wi).cos_view_half()).abs() < 1e-12);
}

#[test]
fn a_smooth_sheet_is_as_if_it_were_not_there() {
    for degrees in [0.0, 40.0, 75.0] {
        let wo = Vec3::from_angles(degrees * glanz_math::PI / 180.0, 0.3);
        let got = albedo(&Shape::GgxThinTransmission(GgxThinTransmission::from_params(&[0.001])), wo.z);
        assert!((got - 1.0).abs() < 1e-3, "{degrees}°: {got}");
        let lobe = GgxThinTransmission::from_params(&[0.01]);
        let tilted = Vec3::from_angles(
            glanz_math::PI - (degrees + 1.0) * glanz_math::PI / 180.0,
            0.3 + glanz_math::PI,
        );
        assert!(lobe.f_cos(&DirectionPair::new(wo, -wo)) > lobe.f_cos(&DirectionPair::new(wo, tilted)));
    }
}
