//! Structural similarity: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image quality assessment:
//! from error visibility to structural similarity", IEEE Transactions on Image Processing 13 (4), 2004.
//!
//! Window, σ, K₁ and K₂ are those of section III.B there, for values 0 … 1. As in the program that its
//! authors publish, the mean is over the pixels whose whole window lies in the picture; in a picture smaller
//! than the window it is over all. At the edges of the map the picture goes on with its last pixels.

use core::ops::Range;
use std::borrow::Cow;

use super::filter::{Kernel, filter};
use crate::compare::Pair;
use crate::compare::bands::in_bands;
use crate::compare::rows::one_plane;

/// Pixels from the middle of the window to its edge: 11×11 in all.
const RADIUS: usize = 5;
/// Width of the Gaussian window in pixels.
const SIGMA: f64 = 1.5;
/// (K₁ L)² with K₁ = 0.01 and the range of values L = 1.
const C1: f64 = 0.01 * 0.01;
/// (K₂ L)² with K₂ = 0.03.
const C2: f64 = 0.03 * 0.03;
/// Luma of R′G′B′ codes by ITU-R BT.601.
const LUMA: [f64; 3] = [0.299, 0.587, 0.114];

/// 1 − SSIM of every pixel.
pub(crate) fn map(pair: &Pair) -> Vec<f32> {
    in_bands(pair.width, pair.height, RADIUS, |rows| band(pair, rows))
}

/// The same of these rows, as if they were the picture.
fn band(pair: &Pair, rows: Range<usize>) -> Vec<f32> {
    let (width, height) = (pair.width, rows.len());
    let values = pair.values(rows);
    let luma = |codes: &[Cow<'_, [f32]>; 3]| {
        one_plane(width, height, |i| {
            let [r, g, b] = [0, 1, 2].map(|channel: usize| LUMA[channel] * f64::from(codes[channel][i]));
            r + g + b
        })
    };
    let [reference, test] = values.each_ref().map(luma);
    let window = window();
    let smooth = |value: &(dyn Fn(f64, f64) -> f64 + Sync)| {
        let plane = one_plane(width, height, |i| value(reference[i], test[i]));
        filter(&plane, width, &window, &window)
    };
    let (mean_x, mean_y) = (smooth(&|x, _| x), smooth(&|_, y| y));
    let (xx, yy, xy) = (smooth(&|x, _| x * x), smooth(&|_, y| y * y), smooth(&|x, y| x * y));
    one_plane(width, height, |i| {
        let (x, y) = (mean_x[i], mean_y[i]);
        let (variance_x, variance_y, covariance) = (xx[i] - x * x, yy[i] - y * y, xy[i] - x * y);
        let luminance = (2.0 * x * y + C1) / (x * x + y * y + C1);
        let structure = (2.0 * covariance + C2) / (variance_x + variance_y + C2);
        (1.0 - luminance * structure) as f32
    })
}

/// The mean SSIM, from the map of 1 − SSIM.
pub(crate) fn mean(pair: &Pair, map: &[f32]) -> f64 {
    let inside = |side: usize| if side > 2 * RADIUS { RADIUS..side - RADIUS } else { 0..side };
    let (columns, rows) = (inside(pair.width), inside(pair.height));
    let count = columns.len() * rows.len();
    let rows = rows.map(|y| &map[y * pair.width..][columns.clone()]);
    let sum: f64 = rows.flatten().copied().map(f64::from).sum();
    1.0 - sum / count as f64
}

/// The Gaussian window along one direction, of sum 1.
fn window() -> Kernel<f64> {
    let radius = RADIUS as i32;
    let weights: Vec<f64> =
        (-radius..=radius).map(|x| libm::exp(-f64::from(x * x) / (2.0 * SIGMA * SIGMA))).collect();
    let sum: f64 = weights.iter().sum();
    Kernel::new(weights.into_iter().map(|weight| weight / sum).collect())
}
