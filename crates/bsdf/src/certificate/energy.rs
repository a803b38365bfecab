//! Whether more light leaves than arrives.

use super::directional::by_angles;
use super::grid::{THETA, azimuths, direction};
use super::report::{Check, Finding};
use super::subject::Subject;
use crate::DirectionPair;

/// What quadrature may add to an albedo of exactly 1.
const TOLERANCE: f64 = 2e-4;

/// Looks for the view direction towards which most light leaves.
pub(super) fn check(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.excuse() {
        return Finding::not_applicable(Check::Energy, reason);
    }
    let mut worst = (0.0, 0.0, 0.0);
    for &phi in azimuths(subject) {
        for theta in THETA {
            let albedo = albedo(subject, theta, phi);
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

/// The albedo times η²: radiance is squeezed by that where light enters a denser medium.
///
/// Near the horizon the quadrature for surfaces with a grain is coarse; there a second one, which misses lobes that are
/// narrow one way alone, must find too much as well.
fn albedo(subject: &dyn Subject, theta: f64, phi: f64) -> f64 {
    let wo = direction(theta, phi);
    let value = |pair: &DirectionPair<f64>| subject.long(pair);
    let albedo = subject.eta() * subject.eta() * subject.integral(wo, &value);
    match albedo > 1.0 + TOLERANCE && subject.info().anisotropic && !subject.transmits() {
        true => albedo.min(by_angles(wo, &value)),
        false => albedo,
    }
}
