//! What is special to the generalised cosine lobe.

use glanz_math::Vec3;

use super::*;
use crate::models::lambert::Lambert;
use crate::models::phong_normalized::PhongNormalized;
use crate::{Shape, albedo_at};

fn lobe(cx: f64, cy: f64, cz: f64, n: f64) -> Lafortune {
    Lafortune::from_params(&[cx, cy, cz, n])
}

fn pairs() -> Vec<DirectionPair<f64>> {
    let angles = [(0.2, 0.1, 0.3, 3.0), (1.2, 0.4, 1.1, 3.5), (0.9, 2.0, 0.4, 2.2), (1.5, 0.0, 0.1, 1.0)];
    let pair = |(to, po, ti, pi)| DirectionPair::new(Vec3::from_angles(to, po), Vec3::from_angles(ti, pi));
    angles.into_iter().map(pair).collect()
}

#[test]
fn with_a_mirror_for_its_axis_is_phong() {
    for pair in pairs() {
        let phong = PhongNormalized::from_params(&[20.0]).f_cos(&pair);
        for scale in [0.5, 1.0, 2.0] {
            let got = lobe(-scale, -scale, scale, 20.0).f_cos(&pair);
            assert!((got - phong).abs() < 1e-12, "{got} for {phong}");
        }
    }
}

#[test]
fn with_exponent_0_is_lambert() {
    for pair in pairs() {
        assert!((lobe(0.3, -1.0, 0.7, 0.0).f_cos(&pair) - Lambert.f_cos(&pair)).abs() < 1e-15);
    }
}

#[test]
fn with_equal_weights_sends_light_back() {
    let back = lobe(1.0, 1.0, 1.0, 50.0);
    let wo = Vec3::from_angles(0.8, 0.3);
    let at = |theta, phi| back.f_cos(&DirectionPair::new(wo, Vec3::from_angles(theta, phi)));
    let peak = at(0.8, 0.3);
    assert!((peak - 52.0 / (2.0 * PI) * libm::cos(0.8)).abs() < 1e-12);
    assert!(at(0.8, 0.5) < peak && at(0.8, 0.3 + PI) < 1e-3 * peak);
}

#[test]
fn on_the_normal_alone_has_the_albedo_of_a_cosine_power() {
    // Cx = Cy = 0: ∫ (n+2)/(2π) (cosθo cosθi)ⁿ cosθi dωi = cosⁿθo.
    let matte = Shape::Lafortune(lobe(0.0, 0.0, 1.5, 3.0));
    for cos_o in [1.0, 0.7, 0.2] {
        let got = albedo_at(&matte, cos_o, 0.4);
        assert!((got - cos_o * cos_o * cos_o).abs() < 1e-4, "cosθ = {cos_o}: {got}");
    }
}

#[test]
fn the_raw_tint_gives_the_lobe_of_a_published_fit() {
    // The second lobe of the blue paint of the paper, in the green.
    let (c, n) = ([-0.406_681, -0.406_681, 0.017_625], 2.581_499);
    let fit = lobe(c[0], c[1], c[2], n);
    for pair in pairs() {
        let dot = c[0] * pair.tangent_o.0 * pair.tangent_i.0
            + c[1] * pair.tangent_o.1 * pair.tangent_i.1
            + c[2] * pair.cos_o * pair.cos_i;
        let raw = libm::pow(dot.max(0.0), n) * pair.cos_i;
        assert!((fit.raw_tint() * fit.f_cos(&pair) - raw).abs() < 1e-12 * raw.max(1e-3));
    }
}

#[test]
fn without_any_weight_is_black() {
    assert!(pairs().iter().all(|pair| lobe(0.0, 0.0, 0.0, 0.0).f_cos(pair) == 0.0));
}
