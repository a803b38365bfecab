//! How far two pictures of the same scene are apart.

use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};
use glanz_color::srgb_decode_u8;

use crate::Frame;

/// Differences over the pixels that show a surface in either picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// How many pixels count.
    pub pixels: usize,
    /// Root of the mean square, over red, green and blue in linear light.
    pub rmse_linear: f64,
    /// The greatest, in linear light.
    pub max_linear: f64,
    /// Root of the mean square, in 8-bit codes.
    pub rmse_codes: f64,
    /// The greatest, in 8-bit codes.
    pub max_codes: u8,
    /// Mean colour difference ΔE00 (CIEDE2000) of the codes as a screen shows them.
    pub mean_delta_e: f64,
}

/// A drawn picture in both forms.
#[derive(Clone, Debug)]
pub struct Developed {
    /// Linear light.
    pub frame: Frame,
    /// Straight RGBA codes.
    pub codes: Vec<u8>,
}

impl Difference {
    /// The difference between two pictures of one size.
    pub fn between(a: &Developed, b: &Developed) -> Self {
        let decode: Vec<f64> = (0..=255).map(|code| f64::from(srgb_decode_u8(code))).collect();
        let mut sum = Self::default();
        for pixel in 0..a.codes.len() / 4 {
            if !shows_surface(&a.frame, pixel) && !shows_surface(&b.frame, pixel) {
                continue;
            }
            sum.pixels += 1;
            for channel in 0..3 {
                let linear = f64::from(a.frame.rgb[channel][pixel]) - f64::from(b.frame.rgb[channel][pixel]);
                let code = a.codes[4 * pixel + channel].abs_diff(b.codes[4 * pixel + channel]);
                sum.rmse_linear += linear * linear;
                sum.max_linear = sum.max_linear.max(linear.abs());
                sum.rmse_codes += f64::from(code).powi(2);
                sum.max_codes = sum.max_codes.max(code);
            }
            let lab = |picture: &Developed| {
                let light = |channel| decode[usize::from(picture.codes[4 * pixel + channel])];
                LinearSrgb([0, 1, 2].map(light)).to::<Lab>()
            };
            sum.mean_delta_e += ciede2000(lab(a), lab(b));
        }
        let values = (3 * sum.pixels).max(1) as f64;
        Self {
            rmse_linear: (sum.rmse_linear / values).sqrt(),
            rmse_codes: (sum.rmse_codes / values).sqrt(),
            mean_delta_e: sum.mean_delta_e / sum.pixels.max(1) as f64,
            ..sum
        }
    }
}

/// Whether an object is there. Frames without object numbers count everywhere.
fn shows_surface(frame: &Frame, pixel: usize) -> bool {
    frame.object.get(pixel).is_none_or(|object| *object != 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(codes: [u8; 2], linear: [f32; 2], object: [u32; 2]) -> Developed {
        let plane = linear.to_vec();
        let frame = Frame {
            width: 2,
            height: 1,
            rgb: [plane.clone(), plane.clone(), plane],
            alpha: vec![1.0; 2],
            object: object.to_vec(),
            ..Frame::default()
        };
        Developed { frame, codes: codes.iter().flat_map(|&code| [code, code, code, 255]).collect() }
    }

    #[test]
    fn only_surfaces_count() {
        let a = gray([10, 100], [0.1, 0.4], [0, 1]);
        let b = gray([250, 103], [0.9, 0.5], [0, 1]);
        let difference = Difference::between(&a, &b);
        assert_eq!((difference.pixels, difference.max_codes), (1, 3));
        assert!((difference.rmse_linear - 0.1).abs() < 1e-7 && (difference.rmse_codes - 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_step_of_grey_is_a_step_of_lightness() {
        // sRGB codes 119 and 120 have L* 50.0345 and 50.4312 (CIE 15 of the light by IEC 61966-2-1).
        let difference =
            Difference::between(&gray([0, 119], [0.0; 2], [0, 1]), &gray([0, 120], [0.0; 2], [0, 1]));
        assert!((difference.mean_delta_e - 0.3967).abs() < 1e-3, "{difference:?}");
    }
}
