//! What is special to the classic Phong lobe.

use glanz_math::Vec3;

use super::*;

/// Light 30° off the normal and a view this many degrees from its mirror direction, in one plane.
fn beside_the_mirror(degrees: f64) -> DirectionPair<f64> {
    let radians = PI / 180.0;
    DirectionPair::new(
        Vec3::from_angles((30.0 + degrees) * radians, 0.0),
        Vec3::from_angles(30.0 * radians, PI),
    )
}

#[test]
fn has_the_values_of_the_classic_term() {
    // With the light π of Glanz the value is (R·V)^n.
    let cases = [
        (1.0, 60.0, 0.5),
        (2.0, 45.0, 0.5),
        (10.0, 0.0, 1.0),
        (3.0, 30.0, 0.649_519_052_838_329),
        (7.0, 95.0, 0.0),
    ];
    for (shininess, degrees, expected) in cases {
        let value = Phong::from_params(&[shininess]).f_cos(&beside_the_mirror(degrees)) * PI;
        assert!((value - expected).abs() < 1e-12, "n = {shininess}, {degrees}°: {value}");
    }
}

#[test]
fn has_its_peak_in_the_mirror_direction() {
    let lobe = Phong::from_params(&[50.0]);
    let peak = lobe.f_cos(&beside_the_mirror(0.0));
    assert!((peak * PI - 1.0).abs() < 1e-12);
    assert!([-20.0, -1.0, 1.0, 20.0].iter().all(|d| lobe.f_cos(&beside_the_mirror(*d)) < peak));
}

#[test]
fn has_no_cosine_of_the_light() {
    // Grazing light gives the full highlight in its mirror direction, to the last bit before night.
    let lobe = Phong::from_params(&[20.0]);
    let grazing = DirectionPair::isotropic(1e-6, 1e-6, 2e-12 - 1.0);
    assert!((lobe.f_cos(&grazing) * PI - 1.0f64).abs() < 1e-9);
    assert_eq!(lobe.f_cos(&DirectionPair::isotropic(1e-6, -1e-6, -1.0)), 0.0);
}

#[test]
fn with_exponent_0_is_the_same_on_the_whole_lit_side() {
    let lobe = Phong::from_params(&[0.0]);
    assert_eq!(lobe.f_cos(&beside_the_mirror(0.0)), lobe.f_cos(&beside_the_mirror(-115.0)));
}
