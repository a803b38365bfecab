//! The colour difference of two drawn frames, pixel by pixel.

use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};

use crate::Frame;
use crate::compare::Spread;

/// ΔE00 between two frames of linear sRGB, and its statistics over the pixels that show a surface.
#[derive(Clone, Debug)]
pub struct DeltaE {
    /// For each pixel in rows from the top; 0 where neither frame shows a surface.
    pub map: Vec<f32>,
    /// Over the pixels that show a surface.
    pub spread: Spread,
    /// How many those are.
    pub pixels: usize,
}

impl DeltaE {
    /// The difference of two frames of one size for the white D65, at an exposure of `ev` stops. Colours beyond the
    /// gamut of sRGB are not clipped.
    pub fn between(a: &Frame, b: &Frame, ev: f32) -> Self {
        let gain = libm::exp2(f64::from(ev));
        let lab = |frame: &Frame, i: usize| -> Lab {
            LinearSrgb([0, 1, 2].map(|c| gain * f64::from(frame.rgb[c][i]))).to::<Lab>()
        };
        let shows = |frame: &Frame, i: usize| frame.object.get(i).is_none_or(|object| *object != 0);
        let mut map = vec![0.0; a.alpha.len()];
        let mut seen = Vec::new();
        for (i, delta) in map.iter_mut().enumerate().filter(|(i, _)| shows(a, *i) || shows(b, *i)) {
            *delta = ciede2000(lab(a, i), lab(b, i)) as f32;
            seen.push(*delta);
        }
        Self { spread: Spread::of(&seen), pixels: seen.len(), map }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(rgb: [f32; 2], object: [u32; 2]) -> Frame {
        let plane = rgb.to_vec();
        Frame {
            width: 2,
            height: 1,
            rgb: [plane.clone(), plane.clone(), plane],
            alpha: vec![1.0; 2],
            object: object.to_vec(),
            ..Frame::default()
        }
    }

    #[test]
    fn only_surfaces_count() {
        let delta = DeltaE::between(&frame([0.2, 0.5], [0, 1]), &frame([0.9, 0.5], [0, 1]), 0.0);
        assert_eq!((delta.pixels, delta.spread.max, delta.map[0]), (1, 0.0, 0.0));
        // Greys of L* 76.07 and 53.39: ΔE00 of pure lightness is below their difference.
        let apart = DeltaE::between(&frame([0.0, 0.5], [0, 1]), &frame([0.0, 0.214_041], [0, 1]), 0.0);
        assert!((15.0..22.7).contains(&apart.spread.mean), "{:?}", apart.spread);
    }
}
