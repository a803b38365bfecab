//! Directional albedos up to the horizon, narrow lobes included.

use glanz_math::{GaussLegendre, PI, Vec3};

use crate::albedo::directional;
use crate::{DirectionPair, ModelInfo, Side};

/// Halvings of the cells towards the peak: the finest are 1.5e-9 rad wide. A lobe of width 0.001 that is seen at
/// 89.999° is 2e-8 rad narrow in azimuth.
const HALVINGS: i32 = 30;
/// No cell is wider than this, so that kinks far from the peak are resolved.
const WIDEST: f64 = PI / 16.0;
/// Gauss–Legendre points per cell and direction.
const POINTS: usize = 6;

/// The integral of a function of two directions over the hemisphere that lobes of this description answer to,
/// `eta` being the index below the surface over that above it.
///
/// As `albedo::directional`, but for the plain highlight its grid is finer: there the integral is right up to the
/// horizon.
pub(super) fn albedo_by(
    info: &ModelInfo,
    eta: f64,
    wo: Vec3<f64>,
    f_cos: &dyn Fn(&DirectionPair<f64>) -> f64,
) -> f64 {
    let phi_o = libm::atan2(wo.y, wo.x);
    if info.anisotropic || info.side == Side::Transmission {
        return directional(info, eta, (wo.z, phi_o), f_cos);
    }
    by_angles(wo, f_cos)
}

/// The same over the upper hemisphere, in angles that are refined towards the mirror direction.
pub(super) fn by_angles(wo: Vec3<f64>, f_cos: &dyn Fn(&DirectionPair<f64>) -> f64) -> f64 {
    let phi_peak = libm::atan2(wo.y, wo.x) + PI;
    let theta_o = libm::acos(wo.z.clamp(0.0, 1.0));
    let rule = GaussLegendre::new(POINTS);
    let polar = refined(0.0, 0.5 * PI, theta_o);
    let around = refined(-PI, PI, 0.0);
    let strip = |theta: f64| {
        let value = |phi: f64| f_cos(&DirectionPair::new(wo, Vec3::from_angles(theta, phi_peak + phi)));
        let ring: f64 = around.windows(2).map(|cell| rule.integrate(cell[0], cell[1], value)).sum();
        ring * libm::sin(theta)
    };
    polar.windows(2).map(|cell| rule.integrate(cell[0], cell[1], strip)).sum()
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
