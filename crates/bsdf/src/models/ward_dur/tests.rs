//! What is special to Ward's highlight with Dür's factor.

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
            let f = e / (4.0 * PI * widths.0 * widths.1 * wo.z * wi.z);
            let (got, expected) = (value("ward-dur", widths, wo, wi), f * wi.z);
            assert!(
                (got - expected).abs() <= 1e-9 * expected + FADED,
                "{widths:?}, {o:?}, {i:?}: {got} for {expected}"
            );
        }
    }
}

#[test]
fn has_the_albedos_of_the_table() {
    for (degrees, expected) in [(0.0, 0.928_30), (45.0, 0.927_55), (60.0, 0.916_91), (75.0, 0.889_27)] {
        let got = albedo_in_angles("ward-dur", degrees);
        assert!((got - expected).abs() < TABLE, "{degrees}°: {got} for {expected}");
    }
}

#[test]
fn of_no_width_is_a_perfect_mirror() {
    for degrees in [0.0_f64, 45.0, 60.0, 75.0] {
        let got = albedo(&lobe("ward-dur", 0.002, 0.0), libm::cos(degrees * PI / 180.0));
        // What the width of 0.002 still does at 75°: α² tan²θ, a few times.
        assert!((got - 1.0).abs() < 3e-4, "{degrees}°: {got}");
    }
}

#[test]
fn returns_more_than_arrives_at_85_degrees() {
    assert!((albedo_in_angles("ward-dur", 85.0) - 1.13).abs() < 0.005);
}

#[test]
fn takes_a_width_per_axis() {
    widths_belong_to_their_axes("ward-dur");
}

#[test]
fn has_its_peak_in_the_mirror_direction() {
    peaks_in_the_mirror_direction("ward-dur");
}
