//! Energy: no more light leaves than arrives, for any view direction.

use crate::laws::grid::{THETA, azimuths, direction};
use crate::laws::hemisphere::{by_angles, moments};
use crate::laws::subject::Subject;
use crate::laws::verdict::{Finding, Law};

/// What the quadrature may add to an albedo of exactly 1.
const TOLERANCE: f64 = 2e-4;

/// Looks for the view direction with the greatest directional albedo.
pub(in crate::laws) fn judge(subject: &dyn Subject) -> Finding {
    if let Some(reason) = subject.no_directional_light() {
        return Finding::not_applicable(Law::Energy, reason);
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
    let azimuth = if subject.info().anisotropic { format!(", φo = {phi}°") } else { String::new() };
    let detail = format!("the greatest albedo is {albedo:.5}: θo = {theta}°{azimuth}");
    let finding = Finding::judged(Law::Energy, subject.info(), albedo <= 1.0 + TOLERANCE, albedo, detail);
    Finding { wo: Some(direction(theta, phi)), ..finding }
}

/// The albedo times η²: radiance is compressed by that where light enters a denser medium.
///
/// Near the horizon the quadrature for anisotropic lobes is coarse; there a second one, which misses lobes that are
/// narrow one way only, must find too much as well.
fn albedo(subject: &dyn Subject, theta: f64, phi: f64) -> f64 {
    let wo = direction(theta, phi);
    let albedo = subject.eta() * subject.eta() * moments(subject, wo, &[&|_| 1.0])[0];
    match albedo > 1.0 + TOLERANCE && subject.info().anisotropic && !subject.transmits() {
        true => albedo.min(by_angles(wo, &|pair| subject.value(pair))),
        false => albedo,
    }
}
