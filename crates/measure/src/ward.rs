//! G. J. Ward's way from readings to the widths of his model: a straight line through logarithms.
//!
//! Ward 1992 has f = ρd/π + ρs exp(−(tx²/αx² + ty²/αy²)) / (4π αx αy √(cosθi cosθo)), tx and ty being the slopes hx/hz and hy/hz of
//! the facet that mirrors light into the detector. So
//!
//! ln[(f − ρd/π) 4π √(cosθi cosθo)] = ln(ρs/(αx αy)) − tx²/αx² − ty²/αy²,
//!
//! which is linear in 1/αx², 1/αy² and ln ρs: linear regression finds them, once ρd is known. A weight of (f − ρd/π)² makes the
//! squares of the logarithms' errors those of f itself, to first order. Readings that hardly rise above the matte part do not
//! count: their logarithm tells of noise, and they stand far out, where it has leverage. ρd begins with what the darkest readings say and
//! follows from the readings less the highlight that was found; a few rounds suffice.

use core::f64::consts::{FRAC_1_PI, PI};

use crate::{FitError, Readings};

/// Rounds of regression and ρd.
const ROUNDS: usize = 8;

/// Readings count up to this angle of light and detector from the normal, in degrees.
const MOST_THETA_DEG: f64 = 80.0;

/// The part of the readings whose least value begins as ρd/π.
const DARKEST: f64 = 0.1;

/// Readings count from this part of the matte one on, and of the greatest.
const LEAST_OF_MATTE: f64 = 0.25;
const LEAST_OF_GREATEST: f64 = 1e-3;

/// Ward's model, as a regression found it.
#[derive(Clone, Debug, PartialEq)]
pub struct WardFit {
    /// The albedo of the matte part.
    pub rho_d: f64,
    /// The albedo of the highlight, as Ward names it.
    pub rho_s: f64,
    /// The widths along x and y; the same where one was asked for.
    pub alpha: [f64; 2],
    /// The readings as the last regression had them, those above ρd/π.
    pub points: Vec<WardPoint>,
    /// The part of the weighted variance of the logarithms that the line explains.
    pub r_squared: f64,
}

/// A reading in the logarithms of the regression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WardPoint {
    /// tx² and ty², the squares of the slopes of the facet that mirrors.
    pub slopes: [f64; 2],
    /// ln[(f − ρd/π) 4π √(cosθi cosθo)].
    pub value: f64,
    /// (f − ρd/π)², by the greatest of all; 0 of readings that hardly rise above the matte part.
    pub weight: f64,
}

impl WardFit {
    /// ln(ρs/(αx αy)), where the line begins.
    pub fn intercept(&self) -> f64 {
        libm::log(self.rho_s / (self.alpha[0] * self.alpha[1]))
    }

    /// The abscissa at which a point lies on one line of slope −1/αx²: tx² + (αx/αy)² ty², which is tan²δ for one width.
    pub fn abscissa(&self, point: &WardPoint) -> f64 {
        let ratio = self.alpha[0] / self.alpha[1];
        point.slopes[0] + ratio * ratio * point.slopes[1]
    }
}

/// A reading with what the model needs of its directions.
struct Known {
    slopes: [f64; 2],
    /// 4π √(cosθi cosθo).
    factor: f64,
    f: f64,
}

/// Fits Ward's model to one channel of readings; `anisotropic` with a width along x and one along y.
///
/// ```
/// use glanz_bsdf::{DirectionPair, Shape};
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Readings, fit_ward};
///
/// let ward = Shape::named("ward", &[("alpha", 0.2), ("alpha_y", 0.2)])?;
/// let mut readings = Readings::new(Channels::Luminance);
/// let wi = Vec3::from_angles(0.5, 0.0);
/// for step in 0..200 {
///     let wo = Vec3::from_angles(0.006 * f64::from(step), 2.4 * f64::from(step));
///     let f = 0.3 / std::f64::consts::PI + 0.1 * ward.f_cos(&DirectionPair::new(wo, wi)) / wi.z;
///     readings.push(wi, wo, &[f as f32]);
/// }
/// let fit = fit_ward(&readings, 0, false)?;
/// assert!((fit.alpha[0] - 0.2).abs() < 0.002 && (fit.rho_s - 0.1).abs() < 0.002 && (fit.rho_d - 0.3).abs() < 0.003);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FitError::TooFew`] with fewer than ten readings, [`FitError::Nothing`] where they do not fall off from the mirror
/// direction.
pub fn fit_ward(readings: &Readings, channel: usize, anisotropic: bool) -> Result<WardFit, FitError> {
    let known = known(readings, channel);
    if known.len() < 10 {
        let numbers = if anisotropic { 4 } else { 3 };
        return Err(FitError::TooFew { readings: known.len(), most_theta_deg: MOST_THETA_DEG, numbers });
    }
    let mut values: Vec<f64> = known.iter().map(|reading| reading.f).collect();
    values.sort_by(f64::total_cmp);
    let mut rho_d = (PI * values[(DARKEST * values.len() as f64) as usize]).max(0.0);
    let mut found = regression(&known, rho_d, anisotropic)?;
    for _ in 1..ROUNDS {
        rho_d = matte(&known, &found);
        found = regression(&known, rho_d, anisotropic)?;
    }
    Ok(found)
}

/// The readings of a channel, as the regression needs them.
fn known(readings: &Readings, channel: usize) -> Vec<Known> {
    let least = libm::cos(MOST_THETA_DEG.to_radians());
    let one = |index: usize| {
        let [wi, wo] = readings.pair(index);
        let f = f64::from(*readings.values(index).get(channel)?);
        if wi.z < least || wo.z < least || !f.is_finite() {
            return None;
        }
        let h = wi + wo;
        let slopes = [h.x / h.z, h.y / h.z].map(|slope| slope * slope);
        Some(Known { slopes, factor: 4.0 * PI * libm::sqrt(wi.z * wo.z), f })
    };
    (0..readings.len()).filter_map(one).collect()
}

/// The line through the logarithms, ρd being known.
fn regression(known: &[Known], rho_d: f64, anisotropic: bool) -> Result<WardFit, FitError> {
    let points = points(known, rho_d);
    let columns = if anisotropic { 3 } else { 2 };
    let row = |point: &WardPoint| match anisotropic {
        true => [1.0, -point.slopes[0], -point.slopes[1]],
        false => [1.0, -point.slopes[0] - point.slopes[1], 0.0],
    };
    let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for point in &points {
        let row = row(point);
        for i in 0..columns {
            right[i] += point.weight * row[i] * point.value;
            (0..columns).for_each(|j| matrix[i][j] += point.weight * row[i] * row[j]);
        }
    }
    let nothing = || FitError::Nothing("ward: they do not fall off from the mirror direction".to_owned());
    let [intercept, along, across] = solved(matrix, right, columns).ok_or_else(nothing)?;
    let across = if anisotropic { across } else { along };
    if !(along > 0.0 && across > 0.0 && intercept.is_finite()) {
        return Err(nothing());
    }
    let alpha = [along, across].map(|steepness| libm::sqrt(1.0 / steepness));
    let line = |point: &WardPoint| intercept - along * point.slopes[0] - across * point.slopes[1];
    let r_squared = r_squared(&points, line);
    Ok(WardFit { rho_d, rho_s: libm::exp(intercept) * alpha[0] * alpha[1], alpha, points, r_squared })
}

fn points(known: &[Known], rho_d: f64) -> Vec<WardPoint> {
    let above = known.iter().map(|reading| (reading, reading.f - rho_d * FRAC_1_PI));
    let above: Vec<_> = above.filter(|(_, value)| *value > 0.0).collect();
    let most = above.iter().map(|(_, value)| *value).fold(f64::MIN_POSITIVE, f64::max);
    let least = (LEAST_OF_MATTE * rho_d * FRAC_1_PI).max(LEAST_OF_GREATEST * most);
    let point = |(reading, value): &(&Known, f64)| WardPoint {
        slopes: reading.slopes,
        value: libm::log(value * reading.factor),
        weight: if *value < least { 0.0 } else { (value / most) * (value / most) },
    };
    above.iter().map(point).collect()
}

/// The matte part that leaves the least relative errors beside a highlight.
fn matte(known: &[Known], found: &WardFit) -> f64 {
    let (mut sum, mut weights) = (0.0, 0.0);
    let intercept = found.intercept();
    for reading in known.iter().filter(|reading| reading.f > 0.0) {
        let exponent: f64 = (0..2).map(|i| reading.slopes[i] / (found.alpha[i] * found.alpha[i])).sum();
        let highlight = libm::exp(intercept - exponent) / reading.factor;
        let weight = 1.0 / (reading.f * reading.f);
        sum += weight * (reading.f - highlight);
        weights += weight;
    }
    if weights > 0.0 { (PI * sum / weights).max(0.0) } else { 0.0 }
}

fn r_squared(points: &[WardPoint], line: impl Fn(&WardPoint) -> f64) -> f64 {
    let total: f64 = points.iter().map(|point| point.weight).sum();
    let mean = points.iter().map(|point| point.weight * point.value).sum::<f64>() / total;
    let sum = |of: &dyn Fn(&WardPoint) -> f64| -> f64 {
        points.iter().map(|point| point.weight * (point.value - of(point)) * (point.value - of(point))).sum()
    };
    1.0 - sum(&line) / sum(&|_| mean)
}

/// Solves the first rows and columns of a system by elimination (Gauss); none where it is singular.
fn solved(mut matrix: [[f64; 3]; 3], mut right: [f64; 3], count: usize) -> Option<[f64; 3]> {
    for pivot in 0..count {
        let size = matrix[pivot][pivot];
        if size.abs() < 1e-14 {
            return None;
        }
        for row in pivot + 1..count {
            let part = matrix[row][pivot] / size;
            (pivot..count).for_each(|column| matrix[row][column] -= part * matrix[pivot][column]);
            right[row] -= part * right[pivot];
        }
    }
    let mut found = [0.0; 3];
    for row in (0..count).rev() {
        let rest: f64 = (row + 1..count).map(|column| matrix[row][column] * found[column]).sum();
        found[row] = (right[row] - rest) / matrix[row][row];
    }
    Some(found)
}
