//! What is special to the sheen.

use glanz_math::Vec3;

use super::*;
use crate::{Shape, albedo};

fn sheen(alpha: f64) -> Shape {
    Shape::named("charlie", &[("alpha", alpha)]).unwrap()
}

/// The shadowing of the paper in its own words: a table for both ends, and a mirror image about ½.
fn printed_lambda(alpha: f64, cosine: f64) -> f64 {
    let mixed = |rough: f64, smooth: f64| {
        let t = libm::pow(1.0 - alpha, 2.0);
        (1.0 - t) * rough + t * smooth
    };
    let l = |x: f64| {
        let (a, b, c) = (mixed(21.5473, 25.3245), mixed(3.82987, 3.32435), mixed(0.19823, 0.16801));
        a / (1.0 + b * libm::pow(x, c)) + mixed(-1.97760, -1.27393) * x + mixed(-4.32054, -4.85967)
    };
    if cosine < 0.5 { libm::exp(l(cosine)) } else { libm::exp(2.0 * l(0.5) - l(1.0 - cosine)) }
}

#[test]
fn is_the_microfacet_formula_of_the_paper() {
    for alpha in [0.05, 0.25, 1.0] {
        for (to, ti, phi) in [(0.3, 0.9, 1.0), (1.3, 1.4, 0.2), (1.2, 0.1, 3.0), (0.7, 0.7, 2.0)] {
            let (wo, wi) = (Vec3::from_angles(to, 0.0), Vec3::from_angles(ti, phi));
            let h = Vec3::new(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z).normalized();
            let sine = libm::sqrt(h.x * h.x + h.y * h.y);
            let d = (2.0 + 1.0 / alpha) * libm::pow(sine, 1.0 / alpha) / (2.0 * PI);
            let g = 1.0 / (1.0 + printed_lambda(alpha, wo.z) + printed_lambda(alpha, wi.z));
            let (got, expected): (f64, f64) =
                (sheen(alpha).f_cos(&DirectionPair::new(wo, wi)), d * g / (4.0 * wo.z));
            assert!((got - expected).abs() <= 1e-9 * expected, "α = {alpha}: {got} for {expected}");
        }
    }
}

#[test]
fn its_distribution_covers_the_plane_once() {
    // ∫ D cosθ dω = 1 for every α.
    let rule = glanz_math::GaussLegendre::new(64);
    for alpha in [0.1, 0.25, 1.0] {
        let d = |t: f64| (2.0 + 1.0 / alpha) * libm::pow(libm::sin(t), 1.0 / alpha) / (2.0 * PI);
        let covered = rule.integrate(0.0, PI / 2.0, |t| d(t) * PI * libm::sin(2.0 * t));
        assert!((covered - 1.0).abs() < 1e-6, "α = {alpha}: {covered}");
    }
}

#[test]
fn keeps_energy_from_alpha_7_hundredths_on() {
    for alpha in [0.07, 0.1, 0.25, 0.5, 1.0] {
        for degrees in [0.0, 60.0, 80.0, 88.0, 89.0, 89.5, 89.9] {
            let got = albedo(&sheen(alpha), libm::cos(degrees * PI / 180.0));
            assert!(got < 1.0, "α = {alpha}, {degrees}°: {got}");
        }
    }
    assert!(albedo(&sheen(0.05), libm::cos(89.5 * PI / 180.0)) > 1.0);
}

#[test]
fn the_series_of_the_albedo_agrees_with_quadrature() {
    for (alpha, error) in [(1e-3, 4e-3), (0.003, 1e-3), (0.01, 6e-4), (0.06, 3e-4), (0.25, 3e-4), (1.0, 3e-4)]
    {
        let series = Albedo::new(alpha);
        for root in 0..=20 {
            let cosine = 0.002 + 0.998 * libm::pow(f64::from(root) / 20.0, 2.0);
            let (got, expected) = (series.at(cosine), albedo(&sheen(alpha), cosine));
            assert!((got - expected).abs() < error, "α = {alpha}, cosθ = {cosine}: {got} for {expected}");
        }
    }
}

#[test]
fn the_series_is_total_and_the_same_in_single_precision() {
    let series = Albedo::new(0.25);
    assert_eq!(series.at(-1.0), series.at(0.002));
    assert_eq!(series.at(7.0), series.at(1.0));
    assert_eq!(Albedo::new(-3.0), Albedo::new(1e-3));
    for i in 0..=100 {
        let cosine = i as f32 / 100.0;
        let (short, long) = (f64::from(series.at(cosine)), series.at(f64::from(cosine)));
        assert!((short - long).abs() < 2e-6, "{cosine}: {short} and {long}");
    }
}

#[test]
fn shines_at_the_limb() {
    let seen = |degrees: f64| albedo(&sheen(0.25), libm::cos(degrees * PI / 180.0));
    for (degrees, expected) in [(0.0, 0.027), (60.0, 0.188), (85.0, 0.592)] {
        assert!((seen(degrees) - expected).abs() < 5e-4, "{degrees}°: {}", seen(degrees));
    }
}
