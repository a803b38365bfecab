//! Whether more light leaves than arrives.

use super::grid::{THETA, azimuths, direction};
use super::report::{Check, Finding};
use super::subject::Subject;

/// What quadrature may add to an albedo of exactly 1.
const TOLERANCE: f64 = 2e-4;

/// Looks for the view direction towards which most light leaves.
pub(super) fn check(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.excuse() {
        return Finding::not_applicable(Check::Energy, reason);
    }
    // Radiance is squeezed by η² where light enters a denser medium.
    let spread = subject.eta() * subject.eta();
    let mut worst = (0.0, 0.0, 0.0);
    for &phi in azimuths(subject) {
        for theta in THETA {
            let albedo = spread * subject.integral(direction(theta, phi), &|pair| subject.long(pair));
            if albedo > worst.0 || albedo.is_nan() {
                worst = (albedo, theta, phi);
            }
        }
    }
    let (albedo, theta, phi) = worst;
    let grain = if subject.info().anisotropic { format!(", φo = {phi}°") } else { String::new() };
    let detail = format!("the greatest albedo is {albedo:.5}: θo = {theta}°{grain}");
    Finding::judged(Check::Energy, subject.info(), albedo <= 1.0 + TOLERANCE, albedo, detail)
}
