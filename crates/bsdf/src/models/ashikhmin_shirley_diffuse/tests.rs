//! What is special to the matte part beneath a coat.

use super::*;
use crate::{Shape, albedo};

fn matte(rs: f64) -> Shape {
    Shape::AshikhminShirleyDiffuse(AshikhminShirleyDiffuse { rs })
}

#[test]
fn has_the_albedo_that_the_paper_normalised_it_to() {
    for rs in [0.0, 0.04, 0.7] {
        for cos_o in [1.0, 0.6, 0.1] {
            let expected = (1.0 - rs) * (1.0 - libm::pow(1.0 - cos_o / 2.0, 5.0));
            assert!((albedo(&matte(rs), cos_o) - expected).abs() < 1e-9, "Rs = {rs}, cosθ = {cos_o}");
        }
    }
}

#[test]
fn has_the_value_of_the_paper_along_the_normal() {
    // 28/(23π) (31/32)².
    let got = matte(0.0).f_cos(&DirectionPair::isotropic(1.0, 1.0, 1.0));
    assert!((got - 0.363_666_9f64).abs() < 1e-7, "{got}");
}

#[test]
fn is_black_beneath_a_perfect_coat() {
    assert_eq!(matte(1.0).f_cos(&DirectionPair::isotropic(0.5f64, 0.5, 0.1)), 0.0);
}
