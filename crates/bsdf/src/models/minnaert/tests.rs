//! What is special to Minnaert's law.

use super::*;
use crate::models::lambert::Lambert;
use crate::{Shape, albedo};

#[test]
fn with_exponent_1_is_lambert() {
    for (cos_o, cos_i) in [(1.0, 1.0), (0.3, 0.8), (0.01, 0.5)] {
        let pair = DirectionPair::isotropic(cos_o, cos_i, 0.2f64);
        let (got, expected) = (Minnaert { k: 1.0 }.f_cos(&pair), Lambert.f_cos(&pair));
        assert!((got - expected).abs() < 1e-15, "{got} for {expected}");
    }
}

#[test]
fn has_a_power_of_the_view_for_its_albedo() {
    for k in [0.0, 0.5, 0.7, 1.0, 2.5] {
        for cos_o in [1.0, 0.6, 0.1] {
            let (got, expected) =
                (albedo(&Shape::Minnaert(Minnaert { k }), cos_o), libm::pow(cos_o, k - 1.0));
            assert!((got / expected - 1.0).abs() < 1e-4, "k = {k}, cosθ = {cos_o}: {got} for {expected}");
        }
    }
}

#[test]
fn makes_a_full_moon_evenly_bright_with_exponent_one_half() {
    let full = |cosine: f64| Minnaert { k: 0.5 }.f_cos(&DirectionPair::isotropic(cosine, cosine, 1.0));
    assert!([0.9, 0.5, 0.05].iter().all(|cosine| (full(*cosine) - full(1.0)).abs() < 1e-14));
}
