//! What is special to Ward's highlight.

use glanz_math::PI;

use crate::albedo;
use crate::terms::ward::checks::*;

/// The table that these albedos come from is exact to 2e-5.
const TABLE: f64 = 2e-5;

#[test]
fn is_the_formula_of_the_paper_in_angles() {
    for widths in [(0.2, 0.2), (0.05, 0.16), (0.5, 0.1)] {
        for [o, i] in DIRECTIONS {
            let (wo, wi) = (direction(o), direction(i));
            let (e, _) = printed_exponential(wo, wi, widths);
            let f = e / (libm::sqrt(wo.z * wi.z) * 4.0 * PI * widths.0 * widths.1);
            let (got, expected) = (value("ward", widths, wo, wi), f * wi.z);
            assert!(
                (got - expected).abs() <= 1e-9 * expected + FADED,
                "{widths:?}, {o:?}, {i:?}: {got} for {expected}"
            );
        }
    }
}

#[test]
fn has_the_albedos_of_the_table() {
    for (degrees, expected) in [(0.0, 0.894_90), (45.0, 0.638_12), (60.0, 0.458_85)] {
        let got = albedo_in_angles("ward", degrees);
        assert!((got - expected).abs() < TABLE, "{degrees}°: {got} for {expected}");
    }
}

#[test]
fn loses_most_of_the_light_at_75_degrees() {
    let got = albedo_in_angles("ward", 75.0);
    assert!((got - 0.269_19).abs() < TABLE, "{got}");
}

#[test]
fn of_no_width_reflects_the_cosine() {
    for degrees in [0.0_f64, 45.0, 60.0, 75.0] {
        let cosine = libm::cos(degrees * PI / 180.0);
        let got = albedo(&lobe("ward", 0.002, 0.0), cosine);
        // What the width of 0.002 still does at 75°: α² tan²θ, a few times.
        assert!((got - cosine).abs() < 3e-4, "{degrees}°: {got} for {cosine}");
    }
}

#[test]
fn returns_more_than_arrives_a_hair_off_the_horizon() {
    let seen = |degrees: f64| albedo(&lobe("ward", 0.2, 0.0), libm::cos(degrees * PI / 180.0));
    assert!(seen(89.0) < 0.3 && seen(89.99) > 2.0, "{} and {}", seen(89.0), seen(89.99));
}

#[test]
fn takes_a_width_per_axis() {
    widths_belong_to_their_axes("ward");
}

#[test]
fn has_its_peak_in_the_mirror_direction() {
    peaks_in_the_mirror_direction("ward");
}
