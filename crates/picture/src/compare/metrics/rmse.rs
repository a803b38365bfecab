//! Root mean square error, and signal to noise.

use crate::compare::Pair;
use crate::compare::rows::one_plane;

/// The root of the mean square over the channels of every pixel.
pub(crate) fn map(pair: &Pair) -> Vec<f32> {
    one_plane(pair.width, pair.height, |i| (square(pair, i) / 3.0).sqrt() as f32)
}

/// The root of the mean square over the channels of all pixels.
pub(crate) fn rmse(pair: &Pair) -> f64 {
    let pixels = pair.width * pair.height;
    let sum: f64 = (0..pixels).map(|i| square(pair, i)).sum();
    (sum / (3 * pixels) as f64).sqrt()
}

/// 20 log₁₀(1 / rmse) in decibels: the peak of the signal is 1. Infinite for no error.
pub(crate) fn psnr(rmse: f64) -> f64 {
    -20.0 * libm::log10(rmse)
}

/// The sum of the squares of the differences of the channels of pixel `i`.
fn square(pair: &Pair, i: usize) -> f64 {
    let [reference, test] = pair.values();
    let difference = |channel: usize| f64::from(test[channel][i]) - f64::from(reference[channel][i]);
    let [r, g, b] = [0, 1, 2].map(difference);
    r * r + g * g + b * b
}
