//! Normalization: the microfacets cover the surface, ∫ D cosθ dω = 1.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::laws::hemisphere::borders;
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};

/// The error of the quadrature and of the model: distributions that are cut off at grazing facets are not normalised again.
const TOLERANCE: f64 = 1e-3;
/// Why the law does not apply to most models.
pub(in crate::laws) const NO_FACETS: &str = "it is not made of facets";
/// Gauss–Legendre points per cell and direction.
const POINTS: usize = 6;

/// Integrates the projected area of the facets over their normals.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if subject.distribution(Vec3::new(0.0, 0.0, 1.0)).is_none() {
        return Finding::not_applicable(Law::Normalization, NO_FACETS);
    }
    let area = projected_area(|half| subject.distribution(half).unwrap_or(0.0));
    let detail = format!("∫ D cosθ dω is {area:.6}");
    let holds = (area - 1.0).abs() <= TOLERANCE;
    Finding::judged(Law::Normalization, subject.info(), holds, area, detail)
}

/// ∫ D cosθ dω over the hemisphere. Anisotropic ones have their axes along x and y; cells are refined towards both.
pub(in crate::laws) fn projected_area(distribution: impl Fn(Vec3<f64>) -> f64) -> f64 {
    let rule = GaussLegendre::new(POINTS);
    let polar = borders(0.0, 0.5 * PI, 0.0);
    let quarter = borders(0.0, 0.25 * PI, 0.0);
    let strip = |theta: f64| {
        let ring = |from: f64, sign: f64| -> f64 {
            let value = |phi: f64| distribution(Vec3::from_angles(theta, from + sign * phi));
            quarter.windows(2).map(|cell| rule.integrate(cell[0], cell[1], value)).sum()
        };
        let axes = [0.0, 0.5 * PI, PI, 1.5 * PI];
        let around: f64 = axes.map(|axis| ring(axis, 1.0) + ring(axis, -1.0)).iter().sum();
        let (sine, cosine) = libm::sincos(theta);
        around * sine * cosine
    };
    polar.windows(2).map(|cell| rule.integrate(cell[0], cell[1], strip)).sum()
}
