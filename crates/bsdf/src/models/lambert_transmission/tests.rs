//! What is special to light that passes evenly.

use super::*;
use crate::{Shape, albedo};

#[test]
fn passes_all_light_at_every_angle() {
    for cos_o in [1.0, 0.5, 0.01] {
        let got = albedo(&Shape::LambertTransmission(LambertTransmission), cos_o);
        assert!((got - 1.0).abs() < 1e-6, "{got}");
    }
}
