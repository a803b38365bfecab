//! How far two drawn pictures are apart in colour, pixel by pixel.

use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};
use glanz_picture::compare::{Spread, heat_colors};
use glanz_render::Frame;

use super::canvas::Canvas;

/// ΔE00 between the linear sRGB of two pictures, and how it is spread over the pixels that show a surface.
#[derive(Clone, Debug)]
pub struct Delta {
    /// For each pixel; 0 where neither picture shows a surface.
    pub map: Vec<f32>,
    /// Over the pixels that show a surface.
    pub spread: Spread,
    /// How many those are.
    pub pixels: usize,
}

impl Delta {
    /// The difference of two pictures of one size, on the screen's white D65, at an exposure in stops. Light
    /// beyond the screen's gamut counts as it is.
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

    /// The map in the colours of heat, `top` the hottest.
    pub fn heat(&self, width: usize, top: f64) -> Canvas {
        Canvas { width, height: self.map.len() / width.max(1), rgba: heat_colors(&self.map, top) }
    }

    /// The numbers for programs.
    pub fn json(&self) -> serde_json::Value {
        let Spread { mean, median, p95, max } = self.spread;
        serde_json::json!({ "mean": mean, "median": median, "p95": p95, "max": max })
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
        let delta = Delta::between(&frame([0.2, 0.5], [0, 1]), &frame([0.9, 0.5], [0, 1]), 0.0);
        assert_eq!((delta.pixels, delta.spread.max, delta.map[0]), (1, 0.0, 0.0));
        // Greys of L* 76.07 and 53.39: ΔE00 of pure lightness is below their difference.
        let apart = Delta::between(&frame([0.0, 0.5], [0, 1]), &frame([0.0, 0.214_041], [0, 1]), 0.0);
        assert!((15.0..22.7).contains(&apart.spread.mean), "{:?}", apart.spread);
    }
}
