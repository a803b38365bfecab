//! Root mean square error, and signal to noise.

use std::borrow::Cow;

use crate::compare::Pair;
use crate::compare::rows::one_plane;

/// The planes of both pictures.
type Values<'a> = [[Cow<'a, [f32]>; 3]; 2];

/// The root of the mean square over the channels of every pixel, and of all.
pub(crate) fn map_and_rmse(pair: &Pair) -> (Vec<f32>, f64) {
    let values = pair.values(0..pair.height);
    let map = one_plane(pair.width, pair.height, |i| (square(&values, i) / 3.0).sqrt() as f32);
    let pixels = pair.width * pair.height;
    let sum: f64 = (0..pixels).map(|i| square(&values, i)).sum();
    (map, (sum / (3 * pixels) as f64).sqrt())
}

/// 20 log₁₀(1 / rmse) in decibels: the peak of the signal is 1. Infinite for no error.
pub(crate) fn psnr(rmse: f64) -> f64 {
    -20.0 * libm::log10(rmse)
}

/// The sum of the squares of the differences of the channels of pixel `i`.
fn square([reference, test]: &Values, i: usize) -> f64 {
    let difference = |channel: usize| f64::from(test[channel][i]) - f64::from(reference[channel][i]);
    let [r, g, b] = [0, 1, 2].map(difference);
    r * r + g * g + b * b
}
