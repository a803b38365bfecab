//! What is special to the energy of further reflections.

use super::*;
use crate::models::ggx::Ggx;
use crate::terms::smith_albedo;
use crate::{Shape, albedo};

#[test]
fn is_what_the_whole_lobe_has_beside_single_reflections() {
    let (whole, single) = (Ggx::from_params(&[0.6, 0.0, 1.0]), Ggx::from_params(&[0.6, 0.0, 0.0]));
    let multiple = GgxMultiple::from_params(&[0.6, 0.0]);
    for (cos_o, cos_i, cos_io) in [(0.3, 0.8, 0.2), (1.0, 0.5, 0.5), (0.1, 0.1, -0.9)] {
        let pair = DirectionPair::isotropic(cos_o, cos_i, cos_io);
        let rest: f64 = whole.f_cos(&pair) - single.f_cos(&pair);
        assert!((multiple.f_cos(&pair) - rest).abs() < 1e-14);
    }
}

#[test]
fn the_albedo_is_what_single_reflections_miss() {
    for cos_o in [0.1, 0.5, 1.0] {
        let got = albedo(&Shape::GgxMultiple(GgxMultiple::from_params(&[0.6, 0.0])), cos_o);
        let expected = 1.0 - smith_albedo(Distribution::Ggx, (0.6, 0.6), cos_o, 0.0);
        assert!(got < expected + 5e-4 && got > expected - 5e-3, "{got} for {expected}");
    }
}
