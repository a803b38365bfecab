//! What is special to Cook and Torrance's lobe.

use glanz_math::Vec3;

use super::*;
use crate::terms::{d_beckmann, g_v_cavity};
use crate::{Shape, albedo};

fn lobe(m: f64) -> CookTorrance {
    CookTorrance::from_params(&[m, 0.5, 0.0])
}

fn seen(m: f64, degrees: f64) -> f64 {
    albedo(&Shape::CookTorrance(lobe(m)), libm::cos(degrees * PI / 180.0))
}

#[test]
fn has_the_albedo_of_an_independent_quadrature() {
    // To the digits given, but for m = 0.1 at 0°, where that quadrature is 2e-4 short: no facet there is shadowed but by
    // exp(−33), so that all light leaves.
    let table = [
        (0.0, [0.99980, 0.99997, 0.99558, 0.89242]),
        (45.0, [0.99999, 0.99216, 0.95666, 0.86883]),
        (60.0, [0.99907, 0.96559, 0.92477, 0.88687]),
    ];
    for (degrees, row) in table {
        for (m, expected) in [0.1, 0.2, 0.3, 0.5].into_iter().zip(row) {
            let got = seen(m, degrees);
            let error = if m == 0.1 && degrees == 0.0 { 2.5e-4 } else { 6e-5 };
            assert!((got - expected).abs() < error, "m = {m} at {degrees}°: {got} for {expected}");
        }
    }
}

#[test]
fn loses_nothing_along_the_normal_while_no_facet_is_shadowed() {
    assert!((seen(0.1, 0.0) - 1.0).abs() < 1e-6, "{}", seen(0.1, 0.0));
}

#[test]
fn is_the_product_of_its_terms() {
    for (theta_o, theta_i, phi) in [(0.2, 0.5, 3.0), (1.2, 1.0, 2.5), (0.8, 0.1, 0.3)] {
        let (wo, wi) = (Vec3::from_angles(theta_o, 0.0), Vec3::from_angles(theta_i, phi));
        let h = (wo + wi).normalized();
        let d = 0.7 * d_beckmann(h, (0.3, 0.3)) + 0.3 * d_beckmann(h, (0.6, 0.6));
        let expected = d * g_v_cavity(h.z, wo.z, wi.z, wo.dot(h)) / (4.0 * wo.z);
        let got = CookTorrance::from_params(&[0.3, 0.6, 0.3]).f_cos(&DirectionPair::new(wo, wi));
        assert!((got / expected - 1.0).abs() < 1e-12, "{got} for {expected}");
    }
}

#[test]
fn with_little_slope_is_a_mirror() {
    for degrees in [0.0, 30.0, 60.0, 80.0] {
        assert!((seen(0.002, degrees) - 1.0).abs() < 1e-3, "{degrees}°: {}", seen(0.002, degrees));
        let wo = Vec3::from_angles(degrees * PI / 180.0, 0.0);
        let at =
            |angle: f64| lobe(0.01).f_cos(&DirectionPair::new(wo, Vec3::from_angles(angle * PI / 180.0, PI)));
        assert!(at(degrees) > at(degrees + 0.5) && at(degrees) > at(degrees - 0.5));
    }
}
