//! Whether more light leaves than arrives.

use super::directional::albedo_by;
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
    let side = subject.info().side;
    let mut worst = (0.0, 0.0, 0.0);
    for &phi in azimuths(subject) {
        for theta in THETA {
            let albedo = albedo_by(side, direction(theta, phi), |pair| subject.long(pair));
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
