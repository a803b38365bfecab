//! Tables that are coarser than 1 nm, as smooth curves: Sprague's interpolation for equal steps, cubics for others.
//!
//! CIE 167:2005 recommends Sprague's fifth-order polynomials for equal steps: value, slope and curvature go on from piece to
//! piece. For unequal steps this is Lagrange's cubic through the four points around (CIE 15:2004, 7.2.2), and a line beside
//! gaps, where such a cubic would swing.

use super::resample::{Curve, Outside};

/// How far from equal steps wavelengths may lie, as a part of the step: instruments print them with one digit after the point.
const ROUNDING: f64 = 0.02;

/// The fewest points for Sprague's polynomials.
const FEWEST: usize = 6;

/// How much wider one step may be than its neighbour for a cubic through both.
const GAP: f64 = 3.0;

/// Sprague's values beyond the first point, two steps and one step before it, by the first six; mirrored for the last.
const BEYOND: [[f64; FEWEST]; 2] =
    [[884.0, -1960.0, 3033.0, -2648.0, 1080.0, -180.0], [508.0, -540.0, 488.0, -367.0, 144.0, -24.0]];
const BEYOND_BY: f64 = 209.0;

/// A table as a smooth curve.
pub(super) enum Smooth<'a> {
    /// At equal steps.
    Sprague { first: f64, step: f64, last: f64, outside: Outside, padded: Vec<f64> },
    /// At any steps.
    Cubic(Curve<'a>),
}

impl<'a> Smooth<'a> {
    /// The smooth curve of a table that has been checked.
    pub(super) fn of(curve: Curve<'a>) -> Self {
        let ((first, _), (last, _)) = (curve.first(), curve.last());
        let count = curve.nm.len();
        let step = (last - first) / (count - 1) as f64;
        let is_even = curve
            .nm
            .iter()
            .enumerate()
            .all(|(i, nm)| (nm - first - step * i as f64).abs() <= ROUNDING * step);
        if count < FEWEST || !is_even {
            return Self::Cubic(curve);
        }
        let before = |weights: &[f64; FEWEST]| sum(weights, curve.values.iter()) / BEYOND_BY;
        let behind = |weights: &[f64; FEWEST]| sum(weights, curve.values.iter().rev()) / BEYOND_BY;
        let mut padded = BEYOND.iter().map(before).collect::<Vec<_>>();
        padded.extend_from_slice(curve.values);
        padded.extend(BEYOND.iter().rev().map(behind));
        Self::Sprague { first, step, last, outside: curve.outside, padded }
    }

    /// The value at a wavelength in nm.
    pub(super) fn at(&self, nm: f64) -> f64 {
        match self {
            Self::Cubic(curve) => cubic(curve, nm),
            Self::Sprague { first, step, last, outside, padded } => {
                if !(*first..=*last).contains(&nm) && *outside == Outside::Zero {
                    return 0.0;
                }
                let position = (nm.clamp(*first, *last) - first) / step;
                let left = (position as usize).min(padded.len() - FEWEST);
                sprague(&padded[left..left + FEWEST], position - left as f64)
            }
        }
    }
}

fn sum<'a>(weights: &[f64], values: impl Iterator<Item = &'a f64>) -> f64 {
    weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
}

/// Sprague's polynomial between the third and the fourth of six points, a part `t` of the way (CIE 167:2005).
fn sprague(points: &[f64], t: f64) -> f64 {
    const WEIGHTS: [[f64; FEWEST]; 5] = [
        [2.0, -16.0, 0.0, 16.0, -2.0, 0.0],
        [-1.0, 16.0, -30.0, 16.0, -1.0, 0.0],
        [-9.0, 39.0, -70.0, 66.0, -33.0, 7.0],
        [13.0, -64.0, 126.0, -124.0, 61.0, -12.0],
        [-5.0, 25.0, -50.0, 50.0, -25.0, 5.0],
    ];
    let higher = WEIGHTS.iter().rev().fold(0.0, |value, weights| (value + sum(weights, points.iter())) * t);
    points[2] + higher / 24.0
}

/// Lagrange's cubic through the four points around a wavelength; the line between two where there are no four at like steps.
fn cubic(curve: &Curve<'_>, nm: f64) -> f64 {
    let right = curve.nm.partition_point(|known| *known < nm);
    let is_inside = right >= 2 && right + 1 < curve.nm.len();
    if !is_inside {
        return curve.at(nm);
    }
    let (x, y) = (&curve.nm[right - 2..right + 2], &curve.values[right - 2..right + 2]);
    let step = x[2] - x[1];
    let is_like = |other: f64| other <= GAP * step && step <= GAP * other;
    if !is_like(x[1] - x[0]) || !is_like(x[3] - x[2]) {
        return curve.at(nm);
    }
    let weight = |i: usize| (0..4).filter(|j| *j != i).map(|j| (nm - x[j]) / (x[i] - x[j])).product::<f64>();
    (0..4).map(|i| weight(i) * y[i]).sum()
}
