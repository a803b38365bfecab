//! What is special to the anisotropic Phong lobe.

use glanz_math::Vec3;

use super::*;
use crate::{Shape, albedo};

fn lobe(nu: f64, nv: f64) -> Shape {
    Shape::named("ashikhmin-shirley", &[("nu", nu), ("nv", nv)]).unwrap()
}

#[test]
fn is_the_formula_of_the_paper_with_a_unit_half_vector() {
    let directions = [
        ((0.3, 0.2), (0.3, 3.4)),
        ((1.2, 1.0), (0.9, 3.9)),
        ((0.0, 0.0), (0.1, 0.4)),
        ((1.5, 0.0), (1.3, 0.5)),
    ];
    for (nu, nv) in [(10.0, 10.0), (1000.0, 10.0), (0.0, 50.0), (1.0, 1e5)] {
        for ((to, po), (ti, pi)) in directions {
            let (wo, wi) = (Vec3::<f64>::from_angles(to, po), Vec3::from_angles(ti, pi));
            let h = Vec3::new(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z).normalized();
            let exponent = (nu * h.x * h.x + nv * h.y * h.y) / (1.0 - h.z * h.z);
            let f = libm::sqrt((nu + 1.0) * (nv + 1.0)) / (8.0 * PI) * libm::pow(h.z, exponent)
                / (wo.dot(h) * wo.z.max(wi.z));
            let (got, expected) = (lobe(nu, nv).f_cos(&DirectionPair::new(wo, wi)), f * wi.z);
            let close = (got - expected).abs() <= 1e-7 * expected + 1e-30;
            assert!(close, "{nu}, {nv}: {got} for {expected}");
        }
    }
}

#[test]
fn the_logarithm_has_all_digits_on_both_sides_of_its_seam() {
    for x in [0.0, 1e-12, 1e-3, 0.1, 0.249_999_9, 0.25, 0.250_000_1, 1.0, 1e6] {
        let exact = if x > 0.0 { libm::log1p(x) / x * LOG2_E } else { LOG2_E };
        assert!((log2_1p_per_x(x) / exact - 1.0).abs() < 1e-14, "{x}");
        let short = f64::from(log2_1p_per_x(x as f32));
        assert!((short / exact - 1.0).abs() < 6e-7, "{x}: {short} for {exact}");
    }
}

#[test]
fn of_no_width_is_a_perfect_mirror() {
    for degrees in [0.0, 45.0, 60.0] {
        let got = albedo(&lobe(1e5, 0.0), libm::cos(degrees * PI / 180.0));
        assert!((got - 1.0).abs() < 5e-3, "{degrees}°: {got}");
    }
}

#[test]
fn every_width_returns_half_of_the_light_along_the_surface() {
    for nu in [0.0, 10.0, 1000.0] {
        let got = albedo(&lobe(nu, 0.0), 1e-5);
        assert!((got - 0.5).abs() < 1e-3, "{nu}: {got}");
    }
}

#[test]
fn one_exponent_alone_stands_for_both() {
    let pair = DirectionPair::new(Vec3::from_angles(0.5, 0.3), Vec3::from_angles(0.6, 3.0));
    assert_eq!(lobe(70.0, 0.0).f_cos(&pair), lobe(70.0, 70.0).f_cos(&pair));
}
