//! How far two pictures of the same scene are apart.

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
    /// Mean colour difference ΔE*ab (CIE 1976) of the codes as a screen shows them.
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
                lab([0, 1, 2].map(|channel| decode[usize::from(picture.codes[4 * pixel + channel])]))
            };
            sum.mean_delta_e += distance(lab(a), lab(b));
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

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// CIELAB of linear sRGB, for the white D65: IEC 61966-2-1, then CIE 15.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089;
    const EDGE: f64 = 6.0 / 29.0;
    let f = |t: f64| match t > EDGE * EDGE * EDGE {
        true => libm::cbrt(t),
        false => t / (3.0 * EDGE * EDGE) + 4.0 / 29.0,
    };
    let (fx, fy, fz) = (f(x), f(y), f(z));
    [116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)]
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
    fn lab_of_the_primaries_is_as_published() {
        // L*a*b* of sRGB red, from the colour calculator of B. Lindbloom.
        let red = lab([1.0, 0.0, 0.0]);
        assert!(distance(red, [53.24, 80.09, 67.20]) < 0.1, "{red:?}");
        assert!(distance(lab([1.0; 3]), [100.0, 0.0, 0.0]) < 0.02);
        assert_eq!(lab([0.0; 3]), [0.0; 3]);
    }
}
