//! Tone maps: linear light of any brightness to linear light in 0 … 1.
//!
//! Each takes three channels that are already limited to 0 … [`BRIGHTEST`], and may return values a
//! little outside 0 … 1, which encoding clips.

use glanz_math::Real;

use super::ToneMap;

/// The brightest light that a tone map is given. Every curve is flat to 8 bits long before, and the
/// squares in them stay finite.
const BRIGHTEST: f64 = 1e9;

/// The tone map `map` of a linear colour.
#[inline(always)]
pub(super) fn tone_map<R: Real>(map: ToneMap, mut rgb: [R; 3]) -> [R; 3] {
    if map == ToneMap::None {
        return rgb;
    }
    for c in &mut rgb {
        *c = c.clamp(0.0, BRIGHTEST);
    }
    match map {
        ToneMap::None => rgb,
        ToneMap::Reinhard => reinhard(rgb),
        ToneMap::Aces => aces(rgb),
        ToneMap::Agx => agx(rgb),
        ToneMap::KhronosNeutral => khronos_neutral(rgb),
    }
}

/// E. Reinhard, M. Stark, P. Shirley, J. Ferwerda, Photographic Tone Reproduction for Digital Images,
/// SIGGRAPH 2002, equation 3, on luminance: a saturated colour may keep a channel above 1.
#[inline(always)]
fn reinhard<R: Real>([r, g, b]: [R; 3]) -> [R; 3] {
    let luminance = r * r.lit(0.2126) + g * r.lit(0.7152) + b * r.lit(0.0722);
    let scale = r.one() / (r.one() + luminance);
    [r * scale, g * scale, b * scale]
}

/// Linear sRGB to the space of the ACES reference rendering transform, with its desaturation.
const ACES_IN: [[f64; 3]; 3] =
    [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]];

/// From the output transform's space back to linear sRGB.
const ACES_OUT: [[f64; 3]; 3] =
    [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]];

/// Stephen Hill's fit of the ACES 1.0 RRT and ODT for a 100 nit sRGB display, as published with
/// M. Pettineo's BakingLab, 2016. No exposure factor is put in front: 0.18 becomes 0.106.
#[inline(always)]
fn aces<R: Real>(rgb: [R; 3]) -> [R; 3] {
    let mut rgb = transformed(&ACES_IN, rgb);
    for c in &mut rgb {
        let v = *c;
        let top = v * (v + v.lit(0.024_578_6)) - v.lit(0.000_090_537);
        let bottom = v * (v * v.lit(0.983_729) + v.lit(0.432_951_0)) + v.lit(0.238_081);
        *c = top / bottom;
    }
    transformed(&ACES_OUT, rgb)
}

/// The inset of AgX: moves colours towards grey before the curve.
const AGX_IN: [[f64; 3]; 3] = [
    [0.842_479_062_253_094, 0.078_433_599_999_999_2, 0.079_223_745_147_764_3],
    [0.042_328_242_261_012_3, 0.878_468_636_469_772, 0.079_166_127_460_543_4],
    [0.042_375_654_905_705_1, 0.078_433_6, 0.879_142_973_793_104],
];

/// Its inverse.
const AGX_OUT: [[f64; 3]; 3] = [
    [1.196_879_005_120_17, -0.098_020_881_140_136_8, -0.099_029_744_079_720_5],
    [-0.052_896_851_757_456_2, 1.151_903_129_904_17, -0.098_961_176_844_843_3],
    [-0.052_971_635_514_443_8, -0.098_043_450_117_124_1, 1.151_073_672_641_16],
];

/// Middle grey, which AgX puts in the middle of its curve, and its range in stops about it.
const AGX_GRAY_LOG2: f64 = -2.473_931_188_332_412;
const AGX_STOPS: [f64; 2] = [-10.0, 6.5];

/// T. Sobotka's AgX, base look: stops about middle grey on a scale from 0 to 1, a sigmoid, and the
/// result is a code for a display of gamma 2.2, which is made linear here.
///
/// Matrices and range as in github.com/sobotka/AgX, in the short form of B. Wrensch, Minimal AgX
/// Implementation, 2023. The curve is Sobotka's own, not the sixth-degree fit to it that the short
/// form uses (which misses it by up to 0.006).
#[inline(always)]
fn agx<R: Real>(rgb: [R; 3]) -> [R; 3] {
    let mut rgb = transformed(&AGX_IN, rgb);
    for v in &mut rgb {
        let stops = v.max(v.lit(1e-10)).log2() - v.lit(AGX_GRAY_LOG2);
        let stops = stops.clamp(AGX_STOPS[0], AGX_STOPS[1]);
        *v = agx_sigmoid((stops - v.lit(AGX_STOPS[0])) * v.lit(1.0 / (AGX_STOPS[1] - AGX_STOPS[0])));
    }
    let mut codes = transformed(&AGX_OUT, rgb);
    for code in &mut codes {
        *code = code.clamp(0.0, 1.0).pow(code.lit(2.2));
    }
    codes
}

/// Slope 2 through (20/33, 1/2), bent towards 0 with power 3 and towards 1 with power 3.25, so that it
/// passes through (0, 0) and (1, 1).
///
/// With slope s and power p on the side whose end is e away in x and 1/2 in y:
/// y = s·t / (1 + k·t^p)^(1/p), k = ((2·s·e)^p − 1) / e^p, where t is the distance from the middle.
#[inline(always)]
fn agx_sigmoid<R: Real>(x: R) -> R {
    const MIDDLE: f64 = 20.0 / 33.0;
    /// Power p and factor k of the toe, e = 20/33, and of the shoulder, e = 13/33.
    const SIDES: [[f64; 2]; 2] = [[3.0, 59.507_875], [3.25, 69.862_789_135_455_39]];
    let t = x - x.lit(MIDDLE);
    let toe = t.lt(x.zero());
    let side = |i: usize| x.lit(SIDES[0][i]).select(toe, x.lit(SIDES[1][i]));
    let bend = x.one() + side(1) * t.abs().pow(side(0));
    let inverse = x.lit(-1.0 / SIDES[0][0]).select(toe, x.lit(-1.0 / SIDES[1][0]));
    x.lit(0.5) + (t + t) * (bend.log2() * inverse).exp2()
}

/// Khronos PBR Neutral Tone Mapper, specification of 2024: base colours up to 0.8 are kept but for
/// the 4 % that a glossy coat adds; brighter ones are compressed and lose saturation.
#[inline(always)]
fn khronos_neutral<R: Real>([r, g, b]: [R; 3]) -> [R; 3] {
    const START: f64 = 0.8 - 0.04;
    const DESATURATION: f64 = 0.15;
    let one = r.one();
    let low = r.min(g).min(b);
    let offset = (low - low * low * r.lit(6.25)).select(low.lt(r.lit(0.08)), r.lit(0.04));
    let (r, g, b) = (r - offset, g - offset, b - offset);
    let peak = r.max(g).max(b);

    let rest = r.lit(1.0 - START);
    let new_peak = one - rest * rest / (peak + rest - r.lit(START));
    let scale = new_peak / peak;
    let gray = one - one / ((peak - new_peak) * r.lit(DESATURATION) + one);
    let keep = peak.lt(r.lit(START));
    let mut rgb = [r, g, b];
    for c in &mut rgb {
        let scaled = *c * scale;
        *c = c.select(keep, scaled + (new_peak - scaled) * gray);
    }
    rgb
}

/// Matrix times column.
#[inline(always)]
fn transformed<R: Real>(matrix: &[[f64; 3]; 3], [r, g, b]: [R; 3]) -> [R; 3] {
    let mut out = [r; 3];
    for (value, row) in out.iter_mut().zip(matrix) {
        *value = r * r.lit(row[0]) + g * r.lit(row[1]) + b * r.lit(row[2]);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any colour on a coarse grid over the useful range, extremes included.
    fn colours() -> Vec<[f64; 3]> {
        let levels = [0.0, 1e-6, 0.01, 0.04, 0.18, 0.5, 0.79, 1.0, 4.0, 100.0, 1e12, f64::INFINITY];
        let pair = |r| levels.iter().map(move |&g| (r, g));
        let grid = levels.iter().flat_map(|&r| pair(r));
        grid.flat_map(|(r, g)| levels.iter().map(move |&b| [r, g, b])).collect()
    }

    #[test]
    fn reinhard_keeps_chromaticity_and_halves_unit_luminance() {
        let [r, g, b] = reinhard([1.0f64, 1.0, 1.0]);
        assert!((r - 0.5).abs() < 1e-12 && (g - 0.5).abs() < 1e-12 && (b - 0.5).abs() < 1e-12);
        let [r, g, b] = reinhard([4.0f64, 2.0, 1.0]);
        assert!((r / g - 2.0).abs() < 1e-12 && (g / b - 2.0).abs() < 1e-12);
    }

    #[test]
    fn aces_gives_the_values_of_its_formula_for_grays() {
        // For grey the two matrices keep grey (to the five digits they are given in), so the curve
        // is left: by hand, (0.18·0.2045786 − 0.000090537) / (0.18·(0.17707122 + 0.432951) + 0.238081).
        let [r, g, b] = aces([0.18f64; 3]);
        assert!((r - 0.105_584).abs() < 2e-5 && (g - r).abs() < 2e-5 && (b - r).abs() < 2e-5, "{r} {g} {b}");
        let white = aces([1e9f64; 3])[0];
        assert!((white - 1.0 / 0.983_729).abs() < 2e-5, "{white}");
    }

    #[test]
    fn agx_passes_through_its_three_points() {
        assert!(agx_sigmoid(0.0f64).abs() < 1e-9);
        assert!((agx_sigmoid(20.0 / 33.0) - 0.5f64).abs() < 1e-12);
        assert!((agx_sigmoid(1.0f64) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn agx_is_near_the_published_fit_of_its_curve() {
        // B. Wrensch's sixth-degree fit of the same curve.
        let fit = |x: f64| {
            (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232
        };
        let worst = (0..=1000)
            .map(|i| f64::from(i) * 1e-3)
            .map(|x| (fit(x) - agx_sigmoid(x)).abs())
            .fold(0.0, f64::max);
        assert!((0.004..0.006).contains(&worst), "{worst}");
    }

    #[test]
    fn agx_puts_middle_gray_in_the_middle_of_its_curve() {
        let [r, g, b] = agx([0.18f64; 3]);
        let expected = libm::pow(0.5, 2.2);
        // The published matrices keep grey to 1.8e-4 only.
        assert!([r, g, b].iter().all(|c| (c - expected).abs() < 2e-4), "{r} {g} {b}");
    }

    #[test]
    fn neutral_keeps_base_colours_up_to_the_coat() {
        let [r, g, b] = khronos_neutral([0.5f64, 0.3, 0.2]);
        assert!((r - 0.46).abs() < 1e-12 && (g - 0.26).abs() < 1e-12 && (b - 0.16).abs() < 1e-12);
        // Below 0.08 the offset is x − 6.25 x²: what is left is 6.25 x².
        assert!((khronos_neutral([0.04f64; 3])[0] - 0.01).abs() < 1e-12);
    }

    #[test]
    fn neutral_has_no_step_where_compression_starts() {
        let below = khronos_neutral([0.799_999f64, 0.3, 0.2]);
        let above = khronos_neutral([0.800_001f64, 0.3, 0.2]);
        assert!((0..3).all(|c| (below[c] - above[c]).abs() < 3e-6), "{below:?} {above:?}");
    }

    #[test]
    fn every_map_brings_any_colour_into_range() {
        for (map, name) in ToneMap::ALL.into_iter().skip(1) {
            for colour in colours() {
                for value in tone_map(map, colour.map(|c| c as f32)) {
                    // Reinhard scales by luminance: pure blue may reach 1 / 0.0722.
                    assert!((-0.08..=13.9).contains(&value), "{name} of {colour:?} gives {value}");
                }
            }
        }
    }

    #[test]
    fn every_map_makes_grays_brighter_with_more_light() {
        for (map, name) in ToneMap::ALL {
            let mut last = -1.0;
            for i in 0..2000 {
                let value = tone_map(map, [libm::exp2(i as f64 * 0.012 - 14.0); 3])[1];
                assert!(value >= last, "{name} falls from {last} to {value} at step {i}");
                last = value;
            }
        }
    }

    #[test]
    fn f32_agrees_with_f64() {
        // Half of a 16-bit step: the pictures of both are the same to the eye of any display.
        const TOLERANCE: f64 = 0.5 / 65535.0;
        for (map, name) in ToneMap::ALL {
            for colour in colours().into_iter().filter(|c| c.iter().all(|v| *v < 1e6)) {
                let exact = tone_map(map, colour.map(|c| f64::from(c as f32)));
                let short = tone_map(map, colour.map(|c| c as f32));
                for (a, b) in exact.into_iter().zip(short) {
                    let error = (a - f64::from(b)).abs() / a.abs().max(1.0);
                    assert!(error < TOLERANCE, "{name} of {colour:?}: {a} against {b}");
                }
            }
        }
    }
}
