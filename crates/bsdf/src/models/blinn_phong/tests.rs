//! What is special to Blinn's classic lobe.

use glanz_math::Vec3;

use super::*;
use crate::models::phong::Phong;

/// Light and view in one plane, at these degrees from the normal on opposite sides.
fn pair(light: f64, view: f64) -> DirectionPair<f64> {
    let radians = PI / 180.0;
    DirectionPair::new(Vec3::from_angles(view * radians, 0.0), Vec3::from_angles(light * radians, PI))
}

#[test]
fn has_the_values_of_the_classic_term() {
    // In one plane the half vector is (view − light)/2 degrees off the normal.
    for (n, light, view, expected) in
        [(1.0, 0.0, 60.0, 0.75f64.sqrt()), (2.0, 60.0, 0.0, 0.75), (9.0, 40.0, 40.0, 1.0)]
    {
        let value = BlinnPhong::from_params(&[n]).f_cos(&pair(light, view)) * PI;
        assert!((value - expected).abs() < 1e-12, "n = {n}: {value}");
    }
}

#[test]
fn with_4_times_the_exponent_resembles_phong() {
    // cos⁴ⁿ(α/2) = cosⁿα · (1 + n·O(α⁴)): to second order the same highlight.
    let (blinn, phong) = (BlinnPhong::from_params(&[80.0]), Phong::from_params(&[20.0]));
    for degrees in [0.0, 5.0, 10.0, 15.0] {
        let pair = pair(20.0, 20.0 + degrees);
        let (a, b) = (blinn.f_cos(&pair) * PI, phong.f_cos(&pair) * PI);
        assert!((a - b).abs() < 0.01, "{degrees}°: {a} against {b}");
    }
    let same_exponent = BlinnPhong::from_params(&[20.0]).f_cos(&pair(20.0, 35.0)) * PI;
    assert!(same_exponent - phong.f_cos(&pair(20.0, 35.0)) * PI > 0.3);
}

#[test]
fn opposite_directions_have_no_half_vector_and_no_highlight() {
    let lobe = BlinnPhong::from_params(&[10.0]);
    assert_eq!(lobe.f_cos(&DirectionPair::isotropic(-0.5f64, 0.5, -1.0)), 0.0);
    // Rounding to f32 can leave a cosine sum that is not 0 over a length that is.
    assert!(lobe.f_cos(&DirectionPair::isotropic(-0.5f32, 0.500_000_1, -1.0)) < 1e-6);
}

#[test]
fn gains_energy_below_an_exponent_of_5_38_only() {
    let normal = |n: f64| 8.0 / (n + 2.0) * (1.0 - libm::exp2(-0.5 * (n + 2.0)));
    assert!(normal(5.37) > 1.0 && normal(5.39) < 1.0);
}
