//! What is special to the emission lobe.

use super::*;

#[test]
fn is_1_for_every_geometry() {
    for (cos_o, cos_i) in [(1.0f64, 1.0), (0.1, -1.0), (-0.5, 0.0)] {
        assert_eq!(Emission.f_cos(&DirectionPair::isotropic(cos_o, cos_i, 0.0)), 1.0);
    }
}
