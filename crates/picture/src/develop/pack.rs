//! From four codes per pixel in lanes to the bytes of 16 RGBA pixels.

use fearless_simd::{Bytes, Simd, SimdBase, i32x16, u8x64};
use glanz_math::Lanes;

/// 1.5·2^23: added to a code of 0 … 255 it leaves the code, rounded to nearest even, in the low
/// byte of the sum's bits.
const ROUND: f32 = 12_582_912.0;

/// What `ROUND` itself contributes to a pixel word: to red once, to green 8 bits higher. In blue
/// and alpha its bits are shifted out.
const ROUND_IN_WORD: i32 = {
    let bits = ROUND.to_bits();
    bits.wrapping_add(bits << 8) as i32
};

/// Rounds 16 pixels' codes of 0 … 255 and packs them as red, green, blue, alpha.
///
/// The codes must lie in −0.5 … 255.5, as those of [`DevelopKernel`](super::DevelopKernel) do.
#[inline(always)]
pub(super) fn pack_rgba<S: Simd>([r, g, b, a]: [Lanes<S>; 4], out: &mut [u8; 64]) {
    let opaque = words([r, g, b]);
    let simd = opaque.simd;
    let words = opaque + (rounded(a) << 24) - simd.splat_i32x16(ROUND_IN_WORD);
    store(words, out);
}

/// [`pack_rgba`] with alpha 255.
#[inline(always)]
pub(super) fn pack_opaque<S: Simd>(codes: [Lanes<S>; 3], out: &mut [u8; 64]) {
    const ALPHA: i32 = (0xff00_0000_u32 as i32).wrapping_sub(ROUND_IN_WORD);
    let words = words(codes);
    let simd = words.simd;
    store(words + simd.splat_i32x16(ALPHA), out);
}

/// Three codes in a word, and `ROUND_IN_WORD` with them.
#[inline(always)]
fn words<S: Simd>([r, g, b]: [Lanes<S>; 3]) -> i32x16<S> {
    rounded(r) + (rounded(g) << 8) + (rounded(b) << 16)
}

#[inline(always)]
fn rounded<S: Simd>(code: Lanes<S>) -> i32x16<S> {
    let simd = code.0.simd;
    (code + Lanes::splat(simd, ROUND)).0.bitcast()
}

/// Words in memory, red first. (All levels of the SIMD library are little-endian machines.)
#[inline(always)]
fn store<S: Simd>(words: i32x16<S>, out: &mut [u8; 64]) {
    words.bitcast::<u8x64<S>>().store_slice(out);
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    fn packed(level: Level, codes: &[[f32; 16]; 4], opaque: bool) -> [u8; 64] {
        let mut out = [0; 64];
        dispatch!(level, simd => {
            let lanes = [0, 1, 2, 3].map(|c| Lanes::load(simd, &codes[c]));
            if opaque {
                pack_opaque([lanes[0], lanes[1], lanes[2]], &mut out);
            } else {
                pack_rgba(lanes, &mut out);
            }
        });
        out
    }

    #[test]
    fn every_code_lands_in_its_byte() {
        for shift in 0..64 {
            let code = |i: usize, c: usize| ((i * 4 + c) * 4 + shift * 7) % 256;
            let codes = [0, 1, 2, 3]
                .map(|c| core::array::from_fn(|i| code(i, c) as f32 + 0.49 - (i % 2) as f32 * 0.98));
            for (opaque, level) in [false, true].map(|o| (o, Level::new())) {
                let out = packed(level, &codes, opaque);
                for i in 0..16 {
                    for c in 0..4 {
                        let expected = if opaque && c == 3 { 255 } else { code(i, c) as u8 };
                        assert_eq!(out[i * 4 + c], expected, "pixel {i}, channel {c}");
                    }
                }
            }
        }
    }
}
