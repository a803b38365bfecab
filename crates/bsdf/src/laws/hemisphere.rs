//! Directional integrals up to the horizon, narrow lobes included: the quadrature of [`crate::albedo`], with a finer grid
//! for isotropic reflection.

use core::cell::RefCell;

use glanz_math::{PI, Vec3};

use super::subject::Subject;
use crate::albedo::{WIDEST, directional, over_angles, refined};
use crate::{DirectionPair, Side};

/// Halvings of the cells towards the peak: the finest are 1.5e-9 rad wide. A lobe of width 0.001 that is viewed at
/// 89.999° is 2e-8 rad narrow in azimuth.
const HALVINGS: i32 = 30;
/// Borders nearer to each other than this, in radians, are one.
const NEAREST: f64 = 1e-12;

/// What an integrand is multiplied with.
pub(super) type Weight<'a> = &'a dyn Fn(&DirectionPair<f64>) -> f64;

/// ∫ f_cos · weight dωi over the hemisphere that the subject answers to, for each weight.
///
/// A subject that is fast for many pairs at a time is evaluated once for all points of the quadrature, whose order does not
/// depend on values: the points are listed, evaluated, and added up in the same order. Values that are not finite, which
/// are another law's, count as 0.
pub(super) fn moments(subject: &dyn Subject, wo: Vec3<f64>, weights: &[Weight<'_>]) -> Vec<f64> {
    if !subject.is_single() {
        let moment = |weight: &Weight<'_>| integral(subject, wo, &|pair| subject.value(pair) * weight(pair));
        return weights.iter().map(moment).collect();
    }
    let points = RefCell::new(Vec::new());
    integral(subject, wo, &|pair| {
        points.borrow_mut().push(*pair);
        0.0
    });
    let values = subject.values(&points.into_inner());
    let moment = |weight: &Weight<'_>| {
        let next = RefCell::new(values.iter());
        let finite = || next.borrow_mut().next().filter(|value| value.is_finite());
        integral(subject, wo, &|pair| finite().map_or(0.0, |value| value * weight(pair)))
    };
    weights.iter().map(moment).collect()
}

/// ∫ f_cos dωi over the hemisphere that the subject answers to, for a function of about its width in the place of its
/// own f_cos.
pub(super) fn integral(
    subject: &dyn Subject,
    wo: Vec3<f64>,
    f_cos: &dyn Fn(&DirectionPair<f64>) -> f64,
) -> f64 {
    let (info, phi_o) = (subject.info(), libm::atan2(wo.y, wo.x));
    match info.anisotropic || info.side == Side::Transmission {
        true => directional(info, subject.eta(), (wo.z, phi_o), f_cos),
        false => by_angles(wo, f_cos),
    }
}

/// The same over the upper hemisphere, in angles that are refined towards the mirror direction.
pub(super) fn by_angles(wo: Vec3<f64>, f_cos: &dyn Fn(&DirectionPair<f64>) -> f64) -> f64 {
    let phi_peak = libm::atan2(wo.y, wo.x) + PI;
    let theta_o = libm::acos(wo.z.clamp(0.0, 1.0));
    let (polar, around) = (borders(0.0, 0.5 * PI, theta_o), borders(-PI, PI, 0.0));
    over_angles(&polar, &around, |theta, phi| {
        f_cos(&DirectionPair::new(wo, Vec3::from_angles(theta, phi_peak + phi)))
    })
}

/// Cell borders from `low` to `high`, ever finer towards `peak`.
pub(super) fn borders(low: f64, high: f64, peak: f64) -> Vec<f64> {
    refined(low, high, WIDEST, NEAREST, &[(peak, HALVINGS)])
}
