//! What is special to the ambient lobe.

use super::*;

#[test]
fn is_the_same_for_every_geometry_and_makes_unit_light_1() {
    for (cos_o, cos_i) in [(1.0, 1.0), (0.1, -1.0), (-0.5, 0.0)] {
        let value: f64 = Ambient.f_cos(&DirectionPair::isotropic(cos_o, cos_i, 0.0));
        assert!((value * PI - 1.0).abs() < 1e-15);
    }
}
