//! What is special to a mirror.

use super::*;

#[test]
fn takes_its_tint_at_the_angle_of_view() {
    assert_eq!(Mirror.tint_cosine(&DirectionPair::isotropic(0.6, 0.1, 0.2)), 0.6);
    assert_eq!(Mirror.tint_cosine(&DirectionPair::isotropic(-0.1, 0.1, 0.2)), 0.0);
}
