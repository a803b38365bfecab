//! What the tests of Ward's family have in common.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::{DirectionPair, Shape};

/// Directions off the plane of mirroring and in it, steep and flat, as polar angle and azimuth in degrees.
pub(crate) const DIRECTIONS: [[(f64, f64); 2]; 6] = [
    [(0.0, 0.0), (0.0, 0.0)],
    [(30.0, 20.0), (30.0, 200.0)],
    [(30.0, 20.0), (35.0, 190.0)],
    [(60.0, 90.0), (50.0, 281.0)],
    [(85.0, 10.0), (70.0, 200.0)],
    [(45.0, 0.0), (12.0, 60.0)],
];

/// What the lobes take for nothing: 2^-100 times a height of at most a thousand.
pub(crate) const FADED: f64 = 1e-27;

/// The unit vector of a polar angle and an azimuth in degrees.
pub(crate) fn direction((theta, phi): (f64, f64)) -> Vec3<f64> {
    Vec3::from_angles(theta * PI / 180.0, phi * PI / 180.0)
}

/// Ward's exponential as he printed it: exp(−tan²δ (cos²φ/αx² + sin²φ/αy²)), in angles of the unit half
/// vector. With it the cosine wo·h.
pub(crate) fn printed_exponential(
    wo: Vec3<f64>,
    wi: Vec3<f64>,
    (alpha_x, alpha_y): (f64, f64),
) -> (f64, f64) {
    let h = Vec3::new(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z).normalized();
    let (delta, phi) = (libm::acos(h.z.min(1.0)), libm::atan2(h.y, h.x));
    let along = libm::pow(libm::cos(phi) / alpha_x, 2.0) + libm::pow(libm::sin(phi) / alpha_y, 2.0);
    (libm::exp(-libm::pow(libm::tan(delta), 2.0) * along), wo.dot(h))
}

/// The value of the model for the widths, in both places.
pub(crate) fn value(model: &str, (alpha, alpha_y): (f64, f64), wo: Vec3<f64>, wi: Vec3<f64>) -> f64 {
    lobe(model, alpha, alpha_y).f_cos(&DirectionPair::new(wo, wi))
}

/// The model with both widths.
pub(crate) fn lobe(model: &str, alpha: f64, alpha_y: f64) -> Shape {
    Shape::named(model, &[("alpha", alpha), ("alpha_y", alpha_y)]).unwrap()
}

/// The directional albedo of a lobe with α = 0.2 on a plain grid in angles: it has no cells to cut at the
/// horizon as that of [`crate::albedo`] has, and is exact to 1e-6 for lobes as wide as this one.
pub(crate) fn albedo_in_angles(model: &str, degrees: f64) -> f64 {
    let (shape, rule) = (lobe(model, 0.2, 0.0), GaussLegendre::new(200));
    let wo = direction((degrees, 0.0));
    rule.integrate(0.0, PI / 2.0, |theta| {
        let ring = rule
            .integrate(0.0, PI, |phi| shape.f_cos(&DirectionPair::new(wo, Vec3::from_angles(theta, phi))));
        2.0 * ring * libm::sin(theta)
    })
}

/// Turned a quarter about the normal, a surface with exchanged widths is the same one; and `alpha` alone
/// stands for both.
pub(crate) fn widths_belong_to_their_axes(model: &str) {
    let quarter = |v: Vec3<f64>| Vec3::new(-v.y, v.x, v.z);
    for [o, i] in DIRECTIONS {
        let (wo, wi) = (direction(o), direction(i));
        let (there, turned) =
            (value(model, (0.1, 0.4), wo, wi), value(model, (0.4, 0.1), quarter(wo), quarter(wi)));
        assert!((there - turned).abs() <= 1e-12 * there, "{model}, {o:?}, {i:?}: {there} and {turned}");
        assert_eq!(value(model, (0.3, 0.0), wo, wi), value(model, (0.3, 0.3), wo, wi));
    }
    assert_eq!(value(model, (0.3, 1e-5), Vec3::new(0.0, 0.0, 1.0), direction((1.0, 0.0))), {
        value(model, (0.3, 1e-3), Vec3::new(0.0, 0.0, 1.0), direction((1.0, 0.0)))
    });
}

/// A narrow lobe has its peak at the mirror direction and falls to all sides.
pub(crate) fn peaks_in_the_mirror_direction(model: &str) {
    for theta in [0.0, 30.0, 60.0] {
        let wo = direction((theta, 40.0));
        let at = |theta: f64, phi: f64| value(model, (0.02, 0.03), wo, direction((theta, phi)));
        let peak = at(theta, 220.0);
        for (beside, around) in [(theta + 1.0, 220.0), (theta - 1.0, 220.0), (theta.max(1.0), 223.0)] {
            let near = at(beside, around);
            assert!(
                near < peak && near > 0.0,
                "{model}, {theta}°: {near} at {beside}°, {around}°, {peak} at the peak"
            );
        }
    }
}
