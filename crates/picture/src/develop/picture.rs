//! Development of whole frames.

use fearless_simd::Simd;
use glanz_math::{Lanes, SimdLevel, at_level};

use super::{Develop, DevelopKernel};
use crate::{ChannelError, Frame};

/// Pixels that are developed at a time.
const LANES: usize = 16;

/// The frame as 8-bit sRGB with straight alpha, 4 bytes per pixel.
///
/// # Errors
/// If the frame's channels are not what the settings are for: XYZ is not shown as if it were RGB.
pub fn develop(frame: &Frame, develop: &Develop) -> Result<Vec<u8>, ChannelError> {
    develop_with(frame, develop, SimdLevel::best())
}

/// [`develop()`] with chosen SIMD instructions; the bytes do not depend on them.
pub fn develop_with(frame: &Frame, develop: &Develop, level: SimdLevel) -> Result<Vec<u8>, ChannelError> {
    frame.channels.expect(develop.expects())?;
    let kernel = DevelopKernel::new(develop);
    let mut out = vec![0; frame.width * frame.height * 4];
    for_each_row(&mut out, frame.width * 4, |y, row| {
        at_level!(level, simd => row_8(simd, &kernel, frame, y, row));
    });
    Ok(out)
}

/// The frame as 16-bit sRGB with straight alpha, 4 values per pixel.
///
/// # Errors
/// As [`develop()`].
pub fn develop16(frame: &Frame, develop: &Develop) -> Result<Vec<u16>, ChannelError> {
    develop16_with(frame, develop, SimdLevel::best())
}

/// [`develop16`] with chosen SIMD instructions; the values do not depend on them.
pub fn develop16_with(frame: &Frame, develop: &Develop, level: SimdLevel) -> Result<Vec<u16>, ChannelError> {
    frame.channels.expect(develop.expects())?;
    let kernel = DevelopKernel::new(develop);
    let mut out = vec![0; frame.width * frame.height * 4];
    for_each_row(&mut out, frame.width * 4, |y, row| {
        at_level!(level, simd => row_16(simd, &kernel, frame, y, row));
    });
    Ok(out)
}

/// Calls `work` for every row of `out`, in parallel where the feature `rayon` is on.
fn for_each_row<T: Send>(out: &mut [T], row_len: usize, work: impl Fn(usize, &mut [T]) + Sync + Send) {
    if row_len == 0 {
        return;
    }
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        out.par_chunks_mut(row_len).with_min_len(8).enumerate().for_each(|(y, row)| work(y, row));
    }
    #[cfg(not(feature = "rayon"))]
    out.chunks_mut(row_len).enumerate().for_each(|(y, row)| work(y, row));
}

#[inline(always)]
fn row_8<S: Simd>(simd: S, kernel: &DevelopKernel, frame: &Frame, y: usize, out: &mut [u8]) {
    for x in (0..frame.width).step_by(LANES) {
        let (rgb, alpha) = load(simd, frame, x, y);
        let mut bytes = [0; 4 * LANES];
        kernel.store_rgba(rgb, alpha, x, y, &mut bytes);
        let out = &mut out[4 * x..];
        match out.first_chunk_mut() {
            Some(whole) => *whole = bytes,
            None => out.copy_from_slice(&bytes[..out.len()]),
        }
    }
}

#[inline(always)]
fn row_16<S: Simd>(simd: S, kernel: &DevelopKernel, frame: &Frame, y: usize, out: &mut [u16]) {
    for x in (0..frame.width).step_by(LANES) {
        let (rgb, alpha) = load(simd, frame, x, y);
        let mut codes = [[0.0; LANES]; 4];
        for (codes, lanes) in codes.iter_mut().zip(kernel.lanes_16(rgb, alpha)) {
            lanes.store(codes);
        }
        for (i, pixel) in out[4 * x..].chunks_exact_mut(4).take(LANES).enumerate() {
            for (value, codes) in pixel.iter_mut().zip(&codes) {
                *value = (codes[i] + 0.5) as u16;
            }
        }
    }
}

/// Up to 16 pixels; those beyond the row's end are opaque black.
#[inline(always)]
fn load<S: Simd>(simd: S, frame: &Frame, x: usize, y: usize) -> ([Lanes<S>; 3], Lanes<S>) {
    let start = y * frame.width + x;
    let count = (frame.width - x).min(LANES);
    let mut rgb = [Lanes::splat(simd, 0.0); 3];
    for (lanes, plane) in rgb.iter_mut().zip(&frame.rgb) {
        *lanes = load_plane(simd, plane, start, count, 0.0);
    }
    (rgb, load_plane(simd, &frame.alpha, start, count, 1.0))
}

#[inline(always)]
fn load_plane<S: Simd>(simd: S, plane: &[f32], start: usize, count: usize, rest: f32) -> Lanes<S> {
    if count == LANES
        && let Some(whole) = plane[start..].first_chunk()
    {
        return Lanes::load(simd, whole);
    }
    let mut values = [rest; LANES];
    values[..count].copy_from_slice(&plane[start..start + count]);
    Lanes::load(simd, &values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToneMap;

    /// A frame whose channels sweep over all magnitudes, with any alpha and some awkward numbers.
    fn sweep(width: usize, height: usize) -> Frame {
        let n = width * height;
        let plane = |seed: usize| -> Vec<f32> {
            (0..n)
                .map(|i| match (i * 7919 + seed * 104_729) % 65_521 {
                    0 => f32::NAN,
                    1 => f32::INFINITY,
                    2 => -1.0,
                    k => k as f32 / 40_000.0,
                })
                .collect()
        };
        let alpha = (0..n).map(|i| if i % 64 < 32 { 1.0 } else { (i % 11) as f32 / 10.0 }).collect();
        Frame { width, height, rgb: [plane(1), plane(2), plane(3)], alpha, ..Frame::default() }
    }

    fn settings() -> impl Iterator<Item = Develop> {
        ToneMap::ALL.into_iter().flat_map(|(tone_map, _)| {
            [false, true].map(|dither| Develop { ev: 0.3, tone_map, dither, ..Develop::default() })
        })
    }

    #[test]
    fn every_simd_level_gives_the_same_codes() {
        let frame = sweep(77, 9);
        for develop in settings() {
            let expected = develop_with(&frame, &develop, SimdLevel::narrowest());
            let expected16 = develop16_with(&frame, &develop, SimdLevel::narrowest());
            for (name, level) in SimdLevel::available() {
                assert_eq!(develop_with(&frame, &develop, level), expected, "{name}, {develop:?}");
                assert_eq!(develop16_with(&frame, &develop, level), expected16, "{name}, {develop:?}");
            }
        }
    }

    #[test]
    fn sixteen_lanes_give_the_codes_of_one() {
        let frame = sweep(77, 9);
        for settings in settings().filter(|settings| !settings.dither) {
            let kernel = DevelopKernel::new(&settings);
            let picture = develop(&frame, &settings).unwrap();
            for (i, bytes) in picture.chunks_exact(4).enumerate() {
                let rgb = [0, 1, 2].map(|c| frame.rgb[c][i]);
                let codes = kernel.rgba(rgb, frame.alpha[i]).map(|c| c.round_ties_even() as u8);
                assert_eq!(codes, bytes, "{settings:?}, pixel {i}: {rgb:?}");
            }
        }
    }

    #[test]
    fn sixteen_bits_are_within_6_tenths_of_a_code() {
        let exact = |x: f64| {
            65535.0 * if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 }
        };
        let n = 20_000;
        let ramp: Vec<f32> = (0..n).map(|i| i as f32 / (n - 1) as f32).collect();
        let frame = Frame {
            width: n,
            height: 1,
            rgb: [ramp.clone(), ramp.clone(), ramp.clone()],
            alpha: vec![1.0; n],
            ..Frame::default()
        };
        for (pixel, x) in develop16(&frame, &Develop::default()).unwrap().chunks_exact(4).zip(ramp) {
            let error = (f64::from(pixel[0]) - exact(f64::from(x))).abs();
            assert!(error < 0.6, "{x} gave {}", pixel[0]);
            assert_eq!(pixel[3], 65535);
        }
    }

    #[test]
    fn dithering_keeps_the_mean_that_rounding_loses() {
        // Linear light whose code is 100.25: a quarter of the pixels must become 101.
        let light = glanz_color::srgb_decode(100.25 / 255.0);
        let n = 64 * 64;
        let frame = Frame {
            width: 64,
            height: 64,
            rgb: [vec![light; n], vec![light; n], vec![light; n]],
            alpha: vec![1.0; n],
            ..Frame::default()
        };
        let picture = develop(&frame, &Develop { dither: true, ..Develop::default() }).unwrap();
        let above = picture.chunks_exact(4).filter(|p| p[0] == 101).count();
        let below = picture.chunks_exact(4).filter(|p| p[0] == 100).count();
        assert_eq!((above, below), (n / 4, 3 * n / 4));
        assert_eq!(picture, develop(&frame, &Develop { dither: true, ..Develop::default() }).unwrap());
        assert!(develop(&frame, &Develop::default()).unwrap().chunks_exact(4).all(|p| p[0] == 100));
    }

    #[test]
    fn an_empty_frame_is_an_empty_picture() {
        assert!(develop(&Frame::default(), &Develop::default()).unwrap().is_empty());
        let thin = Frame { width: 0, height: 5, ..Frame::default() };
        assert!(develop16(&thin, &Develop::default()).unwrap().is_empty());
    }

    #[test]
    fn channels_of_another_kind_are_an_error_and_not_a_wrong_picture() {
        use crate::{Channels, Meaning, ScreenMatrix};
        let of = |meaning| Frame { channels: Channels { meaning, ..Channels::default() }, ..sweep(3, 2) };
        let matrix = |from| Develop {
            to_screen: Some(ScreenMatrix { from, rows: [[1.0; 3]; 3] }),
            ..Develop::default()
        };
        let error = develop(&of(Meaning::Xyz), &Develop::default()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "expected a frame of linear sRGB, found XYZ; bring it to the screen first"
        );
        assert!(develop(&of(Meaning::LinearSrgb), &matrix(Meaning::Xyz)).is_err());
        assert!(develop16(&of(Meaning::Receptors), &matrix(Meaning::Xyz)).is_err());
        assert!(develop(&of(Meaning::Xyz), &matrix(Meaning::Xyz)).is_ok());
        assert!(develop(&of(Meaning::Display), &Develop::default()).is_ok());
    }
}
