//! What is special to a lobe without width.

use super::*;
use crate::Shape;

#[test]
fn takes_its_tint_at_the_angle_of_view() {
    let shape = Shape::named("refraction", &[("eta", 1.33)]).unwrap();
    assert_eq!(shape.tint_cosine(&DirectionPair::isotropic(0.6, -0.8, -0.9)), 0.6);
    assert_eq!(shape.eta(), 1.33);
    assert!(shape.info().delta);
}
