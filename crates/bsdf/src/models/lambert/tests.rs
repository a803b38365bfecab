//! What is special to Lambert's law.

use super::*;
use crate::{Shape, albedo};

#[test]
fn has_the_value_of_the_cosine_over_pi() {
    for (cos_i, expected) in [(1.0, 1.0 / PI), (0.5, 0.5 / PI), (0.0, 0.0), (-0.5, 0.0)] {
        assert_eq!(Lambert.f_cos(&DirectionPair::isotropic(0.3f64, cos_i, 0.1)), expected);
    }
}

#[test]
fn looks_the_same_from_everywhere() {
    let seen = |cos_o: f64| Lambert.f_cos(&DirectionPair::isotropic(cos_o, 0.7, 0.2 * cos_o));
    assert!([0.0, 0.3, 1.0].iter().all(|cos_o| seen(*cos_o) == seen(0.5)));
}

#[test]
fn returns_all_light() {
    for cos_o in [1.0, 0.5, 0.01] {
        assert!((albedo(&Shape::Lambert(Lambert), cos_o) - 1.0).abs() < 1e-9);
    }
}
