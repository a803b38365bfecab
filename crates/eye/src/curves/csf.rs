//! Contrast sensitivity functions: one over the least contrast of a grating that is seen.
//!
//! None of these is a filter of pictures: above threshold, contrast looks much the same at all frequencies.

use core::f64::consts::{FRAC_PI_4, PI};

use libm::{exp, exp2, log10, pow, sqrt, tanh};

use super::within;

/// A channel of contrast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CsfChannel {
    /// Light and dark.
    Achromatic,
    /// Red and green, of the same luminance.
    RedGreen,
    /// Yellow and violet, of the same luminance.
    YellowViolet,
}

impl CsfChannel {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Achromatic, Self::RedGreen, Self::YellowViolet];
}

/// The constants of a channel for a grating that stands still, in the temporal half of the field.
struct Castle {
    /// The sensitivity at its peak: s0 (1 + s1/L)^−s2, and times 1 − (1 + s3/L)^−s4, which is 1 where s3 is
    /// infinite.
    peak: [f64; 5],
    /// The frequency of the peak, f0 (1 + f1/L)^−f2, in cycles per degree.
    peak_frequency: [f64; 3],
    /// The width of the parabola, as a power of 2.
    width: f64,
    /// How far below the peak low frequencies fall: all channels but the achromatic stay at it.
    fall: f64,
    /// The area that is summed over, in deg², and the frequency from where it shrinks.
    area: (f64, f64),
    /// How sensitivity falls with eccentricity: its decades per degree, and those per degree and cycle per degree.
    eccentricity: (f64, f64),
}

const ACHROMATIC: Castle = Castle {
    peak: [56.4947, 7.547_26, 0.144_532, 5.583_41e-7, 9.668_62e9],
    peak_frequency: [1.781_19, 91.5718, 0.256_682],
    width: 0.000_213_047,
    fall: 0.100_207,
    area: (157.103, 0.702_338),
    eccentricity: (0.023_985_3, 0.018_903_8),
};

const RED_GREEN: Castle = Castle {
    peak: [681.434, 38.0038, 0.480_386, f64::INFINITY, 1.0],
    peak_frequency: [0.017_836_4, 0.0, 0.0],
    width: 2.421_04,
    fall: 0.0,
    area: (2816.44, 0.071_105_8),
    eccentricity: (0.059_140_2, 0.0),
};

const YELLOW_VIOLET: Castle = Castle {
    peak: [166.683, 62.8974, 0.411_93, f64::INFINITY, 1.0],
    peak_frequency: [0.004_257_53, 0.0, 0.0],
    width: 2.681_97,
    fall: 0.0,
    area: (2.827_89e7, 0.000_635_093),
    eccentricity: (0.003_568_65, 0.008_066_31),
};

/// castleCSF for gratings that stand still: sensitivity to contrast of colour and luminance.
///
/// **Formula** S = S_max(L) · P(f) · f · √(Ac/(1 + Ac/area)) · 10^(−(d + f·d_f)·e) with Ac = A0/(1 + (f/f0)²) and a parabola P of log f with
/// its peak at f_max(L), which low frequencies leave by at most a tenth; its 30 constants are in the source of this file.
/// **Parameters** `frequency` f of the grating in cycles per degree, 1/16 to 64; `luminance` L of the background in cd/m², 0.001 to 10⁴;
/// `area_deg2` of the grating, up to 10⁴ deg²; `eccentricity_deg` e towards the temple, 0 to 120°. The background is of D65.
/// **Result** one over the contrast at threshold: of luminance for the achromatic channel, for the others in the units of their mechanism
/// (a cone contrast, not comparable between the channels).
/// **How we differ** what stands still has no transient channel; at 0 Hz its response is below 1e-11 of the other's by day.
/// **Source** M. Ashraf, R. K. Mantiuk, A. Chapiro, S. Wuerger, "castleCSF", Journal of Vision 24(4), 2024; constants from the authors'
/// program (`gfxdisp/castleCSF`, MIT, commit f4b0b72).
///
/// ```
/// use glanz_eye::curves::{CsfChannel, castle_csf};
///
/// // A disc of 1.5° in radius.
/// let area = core::f64::consts::PI * 2.25;
/// let at_4 = castle_csf(CsfChannel::Achromatic, 4.0, 100.0, area, 0.0);
/// assert!((at_4 - 248.4385).abs() < 5e-5);
/// ```
pub fn castle_csf(
    channel: CsfChannel,
    frequency: f64,
    luminance: f64,
    area_deg2: f64,
    eccentricity_deg: f64,
) -> f64 {
    let castle = match channel {
        CsfChannel::Achromatic => &ACHROMATIC,
        CsfChannel::RedGreen => &RED_GREEN,
        CsfChannel::YellowViolet => &YELLOW_VIOLET,
    };
    let (f, l) = (within(frequency, 0.0625, 64.0), within(luminance, 1e-3, 1e4));
    let (area, e) = (within(area_deg2, 1e-6, 1e4), within(eccentricity_deg, 0.0, 120.0));
    let [s0, s1, s2, s3, s4] = castle.peak;
    let peak = s0 * pow(1.0 + s1 / l, -s2) * (1.0 - pow(1.0 + s3 / l, -s4));
    let ratio = f / castle.area.1;
    let summed = castle.area.0 / (1.0 + ratio * ratio);
    let size = sqrt(summed / (1.0 + summed / area));
    let decades = (castle.eccentricity.0 + f * castle.eccentricity.1) * e;
    peak * castle.parabola(f, l) * f * size * pow(10.0, -decades)
}

impl Castle {
    /// The parabola of the logarithm of frequency, 1 at the peak.
    fn parabola(&self, f: f64, luminance: f64) -> f64 {
        let [f0, f1, f2] = self.peak_frequency;
        let peak = f0 * pow(1.0 + f1 / luminance, -f2);
        let away = log10(f / peak);
        let parabola = pow(10.0, -away * away / exp2(self.width));
        if f < peak { parabola.max(1.0 - self.fall) } else { parabola }
    }
}

/// Barten's contrast sensitivity of luminance, for both eyes and a square grating that is seen for a tenth of a second.
///
/// **Formula** S = M(f)/k / √(2/T · (1/X0² + 1/X² + f²/N²) · (1/(ηpE) + Φ0/(1 − e^(−(f/u0)²)))), M = e^(−2π²σ²f²), σ² = σ0² + (C d)²; the pupil is
/// d = 5 − 3 tanh(0.4 log10(L X0²/40²)) mm and E = πd²/4 · L · (1 − (d/9.7)² + (d/12.4)⁴) td. Constants: k 3, T 0.1 s, X 12°, N 15
/// cycles, η 0.03, p 1.2274e6 photons/s/deg²/td, Φ0 3e-8 s·deg², u0 7/°, σ0 0.5′, C 0.08′/mm.
/// **Parameters** `frequency` f in cycles per degree, 0.01 to 100; `luminance` L in cd/m², 1e-4 to 1e5; `size_deg` X0 of the side of the
/// grating, 0.1 to 120°.
/// **Source** P. G. J. Barten, "Contrast Sensitivity of the Human Eye and Its Effects on Image Quality", 1999.
///
/// ```
/// assert!((glanz_eye::curves::barten_csf(4.0, 100.0, 60.0) - 656.9952).abs() < 5e-5);
/// ```
pub fn barten_csf(frequency: f64, luminance: f64, size_deg: f64) -> f64 {
    let (f, l) = (within(frequency, 0.01, 100.0), within(luminance, 1e-4, 1e5));
    let x0 = within(size_deg, 0.1, 120.0);
    let pupil = 5.0 - 3.0 * tanh(0.4 * log10(l * x0 * x0 / 1600.0));
    let (a, b) = (pupil / 9.7, pupil / 12.4);
    let trolands = FRAC_PI_4 * pupil * pupil * l * (1.0 - a * a + b * b * b * b);
    let blur = 0.08 / 60.0 * pupil;
    let sigma_2 = 0.5 / 60.0 * (0.5 / 60.0) + blur * blur;
    let optics = exp(-2.0 * PI * PI * sigma_2 * f * f);
    let summed = 1.0 / (x0 * x0) + 1.0 / 144.0 + f * f / 225.0;
    let photons = 1.0 / (0.03 * 1.2274e6 * trolands);
    let inhibition = f / 7.0;
    let noise = 3e-8 / (1.0 - exp(-inhibition * inhibition));
    optics / 3.0 / sqrt(2.0 / 0.1 * summed * (photons + noise))
}

/// The relative contrast sensitivity of Mannos and Sakrison: 2.6 (0.0192 + 0.114f) e^(−(0.114f)^1.1), at most 0.981 at 7.89 cycles per degree.
///
/// **Parameters** `frequency` f in cycles per degree, 0 to 1000. No luminance, no size.
/// **Source** J. L. Mannos and D. J. Sakrison, IEEE Transactions on Information Theory 20(4), 1974.
///
/// ```
/// use glanz_eye::curves::mannos_sakrison;
///
/// assert!(mannos_sakrison(8.0) > 0.98 && mannos_sakrison(60.0) < 0.01);
/// ```
pub fn mannos_sakrison(frequency: f64) -> f64 {
    let f = 0.114 * within(frequency, 0.0, 1000.0);
    2.6 * (0.0192 + f) * exp(-pow(f, 1.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curves::assert_digits;

    /// A Gaussian patch of 1.5°.
    const AREA: f64 = PI * 1.5 * 1.5;

    #[test]
    fn castle_csf_has_its_values() {
        // eye.md 59–66: a second restatement of the authors' program, at 100 cd/m².
        use CsfChannel::{Achromatic, RedGreen, YellowViolet};
        for (channel, frequency, eccentricity, known) in [
            (Achromatic, 1.0, 0.0, "129.6024"),
            (Achromatic, 4.0, 0.0, "248.4385"),
            (Achromatic, 16.0, 0.0, "42.6874"),
            (Achromatic, 4.0, 10.0, "25.0734"),
            (RedGreen, 1.0, 0.0, "340.4251"),
            (RedGreen, 4.0, 0.0, "192.901"),
            (YellowViolet, 1.0, 0.0, "37.9009"),
            (YellowViolet, 4.0, 0.0, "18.4106"),
        ] {
            assert_digits(castle_csf(channel, frequency, 100.0, AREA, eccentricity), known);
        }
    }

    #[test]
    fn bartens_csf_has_its_values() {
        // eye.md 67–69: the package colour-science 0.4.7 with the pupil and the retinal illuminance of 100 cd/m².
        for (frequency, known) in [(1.0, "556.3785"), (4.0, "656.9952"), (16.0, "163.3366")] {
            assert_digits(barten_csf(frequency, 100.0, 60.0), known);
        }
    }

    #[test]
    fn the_peak_of_mannos_and_sakrison_is_where_it_is_known() {
        // eye.md 70.
        assert_digits(mannos_sakrison(7.8909), "0.980878");
        for near in [7.8, 7.98] {
            assert!(mannos_sakrison(near) < mannos_sakrison(7.8909), "{near}");
        }
    }

    #[test]
    fn more_light_and_a_larger_grating_are_seen_better_and_the_periphery_worse() {
        for channel in CsfChannel::ALL {
            let seen =
                |luminance, area, eccentricity| castle_csf(channel, 2.0, luminance, area, eccentricity);
            let usual = seen(10.0, 1.0, 0.0);
            assert!(seen(100.0, 1.0, 0.0) > usual && seen(10.0, 4.0, 0.0) > usual, "{channel:?}");
            assert!(seen(10.0, 1.0, 10.0) < usual, "{channel:?}");
        }
        assert!(barten_csf(2.0, 100.0, 10.0) > barten_csf(2.0, 1.0, 10.0));
    }
}
