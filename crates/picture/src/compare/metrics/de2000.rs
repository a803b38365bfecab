//! Colour difference per pixel.

use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};

use crate::compare::Pair;
use crate::compare::rows::one_plane;

/// ΔE00 of every pixel, in CIELAB with the white D65, which is R = G = B = 1.
///
/// Light brighter than white has L* above 100, where CIEDE2000 was never tried: L* weighs less there, as
/// the formula has it.
pub(crate) fn map(pair: &Pair) -> Vec<f32> {
    let [reference, test] = pair.light();
    one_plane(pair.width, pair.height, |i| {
        let color = |rgb: &[Vec<f32>; 3]| [0, 1, 2].map(|channel: usize| rgb[channel][i]);
        let (reference, test) = (color(reference), color(test));
        if reference == test { 0.0 } else { ciede2000(lab(reference), lab(test)) as f32 }
    })
}

fn lab(rgb: [f32; 3]) -> Lab {
    Lab::from_xyz(LinearSrgb(rgb.map(f64::from)).to_xyz())
}
