//! The light side of ꟻLIP: in which exposures a picture is looked at, and how it then looks.

use super::planes::Planes;
use crate::compare::rows::three_planes;

/// The tone curve (k₀x² + k₁x + k₂)/(k₃x² + k₄x + k₅): the filmic curve of K. Narkowicz (2015), close to
/// that of the Academy, for light that is first scaled by 0.6, as the paper of 2021 takes it.
const CURVE: [f64; 6] = [0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.0, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14];
/// What the curve makes of the brightest pixel in the first exposure and of the median one in the last.
const LEVEL: f64 = 0.85;
/// The least median luminance that an exposure is made for, 2⁻²³ as in the authors' program: a picture
/// that is mostly black would ask for exposures without end.
const LEAST_MEDIAN: f64 = 1.0 / (1 << 23) as f64;
/// Luminance of linear RGB, ITU-R BT.709.
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// Exposures in stops: 2 to this power scales the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposures {
    /// The first, for the brightest pixel of the reference.
    pub start: f64,
    /// The last, for its median pixel.
    pub stop: f64,
    /// How many there are, at equal steps, both ends among them.
    pub count: usize,
}

impl Exposures {
    /// The exposures for the reference, or for the other picture where the reference has no light; `None`
    /// where that has none either.
    pub fn for_pair(reference: &Planes, test: &Planes) -> Option<Self> {
        Self::of(reference).or_else(|| Self::of(test))
    }

    /// From the exposure that brings the brightest pixel to [`LEVEL`] to that for the median one, of an
    /// even number of pixels the upper in the middle; one exposure for every stop begun, at least two.
    fn of(light: &Planes) -> Option<Self> {
        let [r, g, b] = light;
        let luminance = |i: usize| {
            let [r, g, b] = [r[i], g[i], b[i]].map(|value| f64::from(value.max(0.0)));
            (LUMINANCE[0] * r + LUMINANCE[1] * g + LUMINANCE[2] * b) as f32
        };
        let mut values: Vec<f32> = (0..r.len()).map(luminance).collect();
        let brightest = values.iter().copied().map(f64::from).fold(0.0, f64::max);
        if brightest == 0.0 {
            return None;
        }
        let middle = values.len() / 2;
        let median = f64::from(*values.select_nth_unstable_by(middle, f32::total_cmp).1);
        let bright_end = light_for_level();
        let start = libm::log2(bright_end / brightest);
        // A picture of one luminance, or of less than the least, has one exposure only.
        let stop = libm::log2(bright_end / median.max(LEAST_MEDIAN)).max(start);
        let count = if stop > start { ((stop - start).ceil() as usize).max(2) } else { 1 };
        Some(Self { start, stop, count })
    }

    /// Every exposure.
    pub fn stops(self) -> impl Iterator<Item = f64> {
        let step = (self.stop - self.start) / (self.count.max(2) - 1) as f64;
        (0..self.count).map(move |i| self.start + i as f64 * step)
    }
}

/// The light that the curve brings to [`LEVEL`]: the greater root of a quadratic.
fn light_for_level() -> f64 {
    let [a, b, c] = [0, 1, 2].map(|i| CURVE[i] - LEVEL * CURVE[i + 3]);
    let half = -0.5 * b / a;
    half + (half * half - c / a).sqrt()
}

/// The light in this exposure after the tone curve, 0 … 1.
pub(super) fn expose(light: &Planes, width: usize, height: usize, stops: f64) -> Planes {
    let scale = libm::exp2(stops);
    three_planes(width, height, |i| light.each_ref().map(|plane| tone(f64::from(plane[i]) * scale) as f32))
}

fn tone(light: f64) -> f64 {
    let [k0, k1, k2, k3, k4, k5] = CURVE;
    // Beyond any light the curve is at its end, above 1; the bound keeps its squares finite.
    let x = light.clamp(0.0, 1e9);
    ((k0 * x * x + k1 * x + k2) / (k3 * x * x + k4 * x + k5)).clamp(0.0, 1.0)
}
