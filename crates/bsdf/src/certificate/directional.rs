//! Directional albedos from any side and azimuth, narrow lobes included.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::{Pair, Shape, Side};

/// Halvings of the cells towards the peak: the finest are 1.5e-9 rad wide. A lobe of width 0.001 that is seen at
/// 89.999° is 2e-8 rad narrow in azimuth.
const HALVINGS: i32 = 30;
/// No cell is wider than this, so that kinks far from the peak are resolved.
const WIDEST: f64 = PI / 16.0;
/// Gauss–Legendre points per cell and direction.
const POINTS: usize = 6;
/// Steps by which the peak of light that passes through is sought; a step is 0.01°, less than the narrowest
/// lobes are wide.
const SEARCH: u32 = 9000;

/// The directional albedo of a shape towards any viewer above it: ∫ f_cos(wo, wi) dωi over the hemisphere that
/// it answers to. For lobes of light without direction the integral exists but is no reflectance.
pub fn albedo_towards(shape: &Shape, wo: Vec3<f64>) -> f64 {
    albedo_by(shape.info().side, wo, |pair| shape.f_cos(pair))
}

/// The integral of any function of two directions over the light's hemisphere on that side.
///
/// Quadrature on a grid in angles that is refined towards the peak: the mirror direction, or, for light that
/// passes through, where the plane of incidence is brightest. The error is below 2e-5 for lobes of one peak
/// that have no edge but the horizon.
pub fn albedo_by(side: Side, wo: Vec3<f64>, f_cos: impl Fn(&Pair<f64>) -> f64) -> f64 {
    let phi_peak = libm::atan2(wo.y, wo.x) + PI;
    let theta_o = libm::acos(wo.z.clamp(0.0, 1.0));
    let (low, high) = if side == Side::Transmission { (PI / 2.0, PI) } else { (0.0, PI / 2.0) };
    let theta_peak = match side {
        Side::Reflection => theta_o,
        Side::Transmission => brightest(wo, phi_peak, &f_cos),
    };
    let rule = GaussLegendre::new(POINTS);
    let polar = refined(low, high, theta_peak);
    let around = refined(-PI, PI, 0.0);
    let strip = |theta: f64| {
        let value = |phi: f64| f_cos(&Pair::new(wo, Vec3::from_angles(theta, phi_peak + phi)));
        let ring: f64 = around.windows(2).map(|cell| rule.integrate(cell[0], cell[1], value)).sum();
        ring * libm::sin(theta)
    };
    polar.windows(2).map(|cell| rule.integrate(cell[0], cell[1], strip)).sum()
}

/// The angle below the horizon, on the far side of the normal, from which most light comes.
fn brightest(wo: Vec3<f64>, phi: f64, f_cos: &impl Fn(&Pair<f64>) -> f64) -> f64 {
    let mut best = (0.0, PI);
    for step in 0..=SEARCH {
        let theta = PI - 0.5 * PI * f64::from(step) / f64::from(SEARCH);
        let value = f_cos(&Pair::new(wo, Vec3::from_angles(theta, phi)));
        if value > best.0 {
            best = (value, theta);
        }
    }
    best.1
}

/// Cell borders from `low` to `high`, ever finer towards `peak`.
pub(super) fn refined(low: f64, high: f64, peak: f64) -> Vec<f64> {
    let mut borders = vec![low, peak, high];
    for halving in 0..=HALVINGS {
        let distance = 0.5 * PI * libm::ldexp(1.0, -halving);
        borders.extend([peak - distance, peak + distance]);
    }
    let steps = libm::ceil((high - low) / WIDEST) as i32;
    borders.extend((1..steps).map(|i| low + (high - low) * f64::from(i) / f64::from(steps)));
    borders.retain(|x| (low..=high).contains(x));
    borders.sort_by(f64::total_cmp);
    borders.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    borders
}
