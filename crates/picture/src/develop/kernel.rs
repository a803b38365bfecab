//! Development of single pixels, or of 16 at a time.

use fearless_simd::Simd;
use glanz_math::{Lanes, Real};

use super::{Develop, Encoding, ToneMap, dither, encode, pack, tone_map};
use glanz_math::Twice;

/// [`Develop`] as the pixel loop wants it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DevelopKernel {
    gain: f32,
    /// From channels to linear sRGB, exposure included; none where exposure is all there is.
    to_screen: Option<[[f32; 3]; 3]>,
    tone_map: ToneMap,
    encoding: Encoding,
    dither: bool,
}

impl DevelopKernel {
    /// Works out the factor of exposure.
    pub fn new(develop: &Develop) -> Self {
        let gain = libm::exp2(f64::from(develop.ev)) as f32;
        Self {
            gain,
            to_screen: develop.to_screen.map(|matrix| matrix.rows.map(|row| row.map(|entry| entry * gain))),
            tone_map: develop.tone_map,
            encoding: develop.encoding,
            dither: develop.dither,
        }
    }

    /// The 8-bit codes of red, green and blue where alpha is 1, before dithering and rounding.
    #[inline(always)]
    pub fn opaque<R: Real>(&self, mut rgb: [R; 3]) -> [R; 3] {
        rgb = self.exposed(rgb);
        self.encoded(tone_map::tone_map(self.tone_map, rgb))
    }

    /// The 8-bit codes of straight red, green, blue and of alpha, before dithering and rounding.
    /// The colour given is premultiplied; where alpha is 0, or not a number, the colour is black.
    #[inline(always)]
    pub fn rgba<R: Real>(&self, rgb: [R; 3], alpha: R) -> [R; 4] {
        let alpha = alpha.clamp(0.0, 1.0);
        let [r, g, b] = self.opaque(straight(rgb, alpha));
        [r, g, b, alpha * alpha.lit(255.0)]
    }

    /// Develops 16 pixels of row `y` from column `x` on, all of alpha 1, into RGBA bytes.
    #[inline(always)]
    pub fn store_opaque<S: Simd>(&self, rgb: [Lanes<S>; 3], x: usize, y: usize, out: &mut [u8; 64]) {
        self.pack_opaque(rgb, dither::offsets(x, y), out);
    }

    /// Develops 16 pixels of row `y` from column `x` on into RGBA bytes.
    #[inline(always)]
    pub fn store_rgba<S: Simd>(
        &self,
        rgb: [Lanes<S>; 3],
        alpha: Lanes<S>,
        x: usize,
        y: usize,
        out: &mut [u8; 64],
    ) {
        self.pack_rgba(rgb, alpha, dither::offsets(x, y), out);
    }

    /// Develops 4×4 pixels, all of alpha 1, into RGBA bytes, row by row; `at` is the column and row of
    /// the first, multiples of 4.
    #[inline(always)]
    pub fn store_block<S: Simd>(&self, rgb: [Lanes<S>; 3], at: [usize; 2], out: &mut [u8; 64]) {
        self.pack_opaque(rgb, dither::block_offsets(at), out);
    }

    /// [`Self::store_block`] of two blocks in step.
    #[inline(always)]
    pub fn store_two<S: Simd>(
        &self,
        rgb: [Twice<Lanes<S>>; 3],
        at: [[usize; 2]; 2],
        out: &mut [[u8; 64]; 2],
    ) {
        let mut rgb = self.exposed(rgb);
        if self.tone_map != ToneMap::None {
            let [r, g, b] = rgb;
            let (mut first, mut second) = ([r.0, g.0, b.0], [r.1, g.1, b.1]);
            tone_map_lanes(self.tone_map, &mut first);
            tone_map_lanes(self.tone_map, &mut second);
            rgb = [Twice(first[0], second[0]), Twice(first[1], second[1]), Twice(first[2], second[2])];
        }
        let [r, g, b] = self.encoded(rgb);
        pack::pack_opaque(self.dithered([r.0, g.0, b.0], dither::block_offsets(at[0])), &mut out[0]);
        pack::pack_opaque(self.dithered([r.1, g.1, b.1], dither::block_offsets(at[1])), &mut out[1]);
    }

    /// Develops 4×4 pixels into RGBA bytes, row by row; `at` is the column and row of the first,
    /// multiples of 4.
    #[inline(always)]
    pub fn store_block_rgba<S: Simd>(
        &self,
        rgb: [Lanes<S>; 3],
        alpha: Lanes<S>,
        at: [usize; 2],
        out: &mut [u8; 64],
    ) {
        self.pack_rgba(rgb, alpha, dither::block_offsets(at), out);
    }

    #[inline(always)]
    fn pack_opaque<S: Simd>(&self, rgb: [Lanes<S>; 3], offsets: &[f32; 16], out: &mut [u8; 64]) {
        let rgb = self.graded_lanes(rgb);
        pack::pack_opaque(self.dithered(self.encoded(rgb), offsets), out);
    }

    #[inline(always)]
    fn pack_rgba<S: Simd>(
        &self,
        mut rgb: [Lanes<S>; 3],
        alpha: Lanes<S>,
        offsets: &[f32; 16],
        out: &mut [u8; 64],
    ) {
        let alpha = alpha.clamp(0.0, 1.0);
        if Lanes::any(alpha.lt(alpha.one())) {
            rgb = straight(rgb, alpha);
        }
        let rgb = self.graded_lanes(rgb);
        let [r, g, b] = self.dithered(self.encoded(rgb), offsets);
        pack::pack_rgba([r, g, b, alpha * alpha.lit(255.0)], out);
    }

    /// The 16-bit codes of 16 pixels: straight red, green, blue and alpha, before rounding.
    #[inline(always)]
    pub fn lanes_16<S: Simd>(&self, rgb: [Lanes<S>; 3], alpha: Lanes<S>) -> [Lanes<S>; 4] {
        let alpha = alpha.clamp(0.0, 1.0);
        let mut rgb = self.graded_lanes(straight(rgb, alpha));
        for c in &mut rgb {
            *c = match self.encoding {
                Encoding::Srgb => encode::srgb_code_16(*c),
                Encoding::Raw => encode::raw_code(*c, 65535.0),
            };
        }
        let [r, g, b] = rgb;
        [r, g, b, alpha * alpha.lit(65535.0)]
    }

    /// Linear sRGB of the channels, at the exposure.
    #[inline(always)]
    fn exposed<R: Real>(&self, mut rgb: [R; 3]) -> [R; 3] {
        // Loops over the channels here and below, not three copies: the compiler unrolls them where
        // it pays, and without SIMD instructions a copy is hundreds of operations.
        match &self.to_screen {
            Some(rows) => {
                let [x, y, z] = rgb;
                for (c, [a, b, d]) in rgb.iter_mut().zip(rows) {
                    *c = x * x.lit(f64::from(*a)) + y * x.lit(f64::from(*b)) + z * x.lit(f64::from(*d));
                }
            }
            // A factor of 1 would change nothing.
            None if self.gain == 1.0 => {}
            None => {
                for c in &mut rgb {
                    *c = *c * c.lit(f64::from(self.gain));
                }
            }
        }
        rgb
    }

    #[inline(always)]
    fn encoded<R: Real>(&self, mut rgb: [R; 3]) -> [R; 3] {
        for c in &mut rgb {
            *c = match self.encoding {
                Encoding::Srgb => encode::srgb_code_8(*c),
                Encoding::Raw => encode::raw_code(*c, 255.0),
            };
        }
        rgb
    }

    /// Exposure and tone map; the latter out of line, so that the loops this is part of stay small.
    #[inline(always)]
    fn graded_lanes<S: Simd>(&self, mut rgb: [Lanes<S>; 3]) -> [Lanes<S>; 3] {
        rgb = self.exposed(rgb);
        if self.tone_map != ToneMap::None {
            tone_map_lanes(self.tone_map, &mut rgb);
        }
        rgb
    }

    #[inline(always)]
    fn dithered<S: Simd>(&self, mut rgb: [Lanes<S>; 3], offsets: &[f32; 16]) -> [Lanes<S>; 3] {
        if self.dither {
            let offset = Lanes::load(rgb[0].0.simd, offsets);
            for c in &mut rgb {
                *c = *c + offset;
            }
        }
        rgb
    }
}

/// The tone map of 16 pixels, out of line: no loop grows by four tone maps.
#[inline(never)]
fn tone_map_lanes<S: Simd>(map: ToneMap, rgb: &mut [Lanes<S>; 3]) {
    let simd = rgb[0].0.simd;
    simd.vectorize(
        #[inline(always)]
        || *rgb = tone_map::tone_map(map, *rgb),
    );
}

/// Colour divided by alpha; black where alpha is 0.
#[inline(always)]
fn straight<R: Real>(mut rgb: [R; 3], alpha: R) -> [R; 3] {
    let seen = alpha.zero().lt(alpha);
    for c in &mut rgb {
        *c = (*c / alpha).select(seen, alpha.zero());
    }
    rgb
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernel(ev: f32, tone_map: ToneMap) -> DevelopKernel {
        DevelopKernel::new(&Develop { ev, tone_map, ..Develop::default() })
    }

    #[test]
    fn one_stop_of_exposure_doubles_light() {
        let (plain, brighter) = (kernel(0.0, ToneMap::None), kernel(1.0, ToneMap::None));
        assert_eq!(plain.opaque([0.25f32, 0.1, 0.4]), brighter.opaque([0.125, 0.05, 0.2]));
    }

    #[test]
    fn known_codes_come_out() {
        // 0.5 encodes to 0.735357, 0.18 to 0.461356 (IEC 61966-2-1); ×255.
        let [a, b, c] = kernel(0.0, ToneMap::None).opaque([0.5f64, 0.18, 0.002]);
        assert!((a - 187.516).abs() < 0.011 && (b - 117.646).abs() < 0.011, "{a} {b}");
        assert!((c - 0.002 * 12.92 * 255.0).abs() < 1e-12);
    }

    #[test]
    fn raw_codes_are_the_linear_value_clipped() {
        let raw = DevelopKernel::new(&Develop { encoding: Encoding::Raw, ..Develop::default() });
        assert_eq!(raw.opaque([0.2f32, 0.8, 2.0]), [0.2 * 255.0, 0.8 * 255.0, 255.0]);
        assert_eq!(raw.opaque([f32::NAN, -1.0, f32::INFINITY]), [0.0, 0.0, 255.0]);
        let brighter =
            DevelopKernel::new(&Develop { encoding: Encoding::Raw, ev: 1.0, ..Develop::default() });
        assert_eq!(brighter.opaque([0.1f32; 3]), raw.opaque([0.2f32; 3]));
    }

    #[test]
    fn half_covered_white_is_white_with_half_alpha() {
        let [r, g, b, a] = kernel(0.0, ToneMap::None).rgba([0.5f32; 3], 0.5);
        assert_eq!([r, g, b].map(f32::round), [255.0; 3]);
        assert_eq!(a, 127.5);
    }

    #[test]
    fn every_input_gives_codes_in_range() {
        let numbers = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            1e-40,
            1e38,
            f32::MAX,
            f32::MIN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            f32::NAN,
        ];
        for (map, name) in ToneMap::ALL {
            for ev in [-200.0, 0.0, 200.0] {
                let kernel = kernel(ev, map);
                for r in numbers {
                    for g in numbers {
                        for a in numbers {
                            let codes = kernel.rgba([r, g, 0.3], a);
                            let fine = codes.iter().all(|c| (0.0..=255.0).contains(c));
                            assert!(fine, "{name} at {ev} of {r} {g} alpha {a}: {codes:?}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn no_number_is_black_and_infinite_light_is_white() {
        for (map, _) in ToneMap::ALL {
            let kernel = kernel(0.0, map);
            assert!(kernel.opaque([f32::NAN; 3]).iter().all(|c| *c < 0.5));
            assert!(kernel.opaque([f32::INFINITY; 3]).iter().all(|c| *c > 253.0));
        }
    }
}
