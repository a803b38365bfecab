//! The models that describe a device: CMY, CMYK, HLS, HSV.
//!
//! All are other coordinates of sRGB **code values**, as is usual; no ink or screen is measured.

use palette::convert::FromColorUnclamped;

use super::info::{Channel, ColorModel, ModelInfo};
use super::{Srgb, Xyz};

/// palette's sRGB, in f64.
type Palette = palette::Srgb<f64>;

/// Code values that differ by no more than this, the rounding of the matrices, are those of a grey.
const ROUNDING: f64 = 1e-12;

/// The nearest colour of the sRGB gamut. Greys have three equal components: beside white and black, rounding would
/// be taken for a saturated hue.
fn settled(xyz: Xyz) -> Palette {
    let rgb = Srgb::from_xyz(xyz).clipped().0;
    let most = rgb.into_iter().fold(0.0, f64::max);
    let [r, g, b] = if rgb.iter().all(|c| most - c <= ROUNDING) { [most; 3] } else { rgb };
    Palette::new(r, g, b)
}

/// Cyan, magenta, yellow: 1 − R, 1 − G, 1 − B of sRGB code values.
///
/// 0 … 1; outside of it for colours outside of the sRGB gamut, unclipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cmy(pub [f64; 3]);

impl ColorModel for Cmy {
    const INFO: ModelInfo = ModelInfo {
        name: "cmy",
        title: "complement of sRGB code values",
        channels: &[
            Channel::nominal("C", 0.0, 1.0),
            Channel::nominal("M", 0.0, 1.0),
            Channel::nominal("Y", 0.0, 1.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Srgb(self.0.map(|c| 1.0 - c)).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(Srgb::from_xyz(xyz).0.map(|c| 1.0 - c))
    }
}

/// Cyan, magenta, yellow and black, the simple model: black takes all that the three have in common.
///
/// R = (1 − C)(1 − K) and so on. 0 … 1; a colour outside of the sRGB gamut becomes the nearest of the
/// cube, component by component. Several quadruples give one colour; from XYZ comes the one with most
/// black (black itself: 0, 0, 0, 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cmyk(pub [f64; 4]);

impl ColorModel for Cmyk {
    const INFO: ModelInfo = ModelInfo {
        name: "cmyk",
        title: "CMY of sRGB code values with all common ink replaced by black",
        channels: &[
            Channel::strict("C", 0.0, 1.0),
            Channel::strict("M", 0.0, 1.0),
            Channel::strict("Y", 0.0, 1.0),
            Channel::strict("K", 0.0, 1.0),
        ],
        srgb_only: true,
    };

    fn to_xyz(self) -> Xyz {
        let [c, m, y, k] = self.0;
        Srgb([c, m, y].map(|ink| (1.0 - ink) * (1.0 - k))).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        let rgb = Srgb::from_xyz(xyz).clipped().0;
        let light = rgb.into_iter().fold(0.0, f64::max);
        if light == 0.0 {
            return Self([0.0, 0.0, 0.0, 1.0]);
        }
        let [c, m, y] = rgb.map(|component| 1.0 - component / light);
        Self([c, m, y, 1.0 - light])
    }
}

/// Hue, lightness, saturation: the double cone over sRGB code values (Joblove & Greenberg 1978).
///
/// Hue in degrees, red 0, green 120, blue 240, and 0 for greys; lightness (max + min)/2 and saturation
/// 0 … 1. A colour outside of the sRGB gamut becomes the nearest of the cube, component by component.
/// By the crate `palette` (there HSL).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hls(pub [f64; 3]);

impl ColorModel for Hls {
    const INFO: ModelInfo = ModelInfo {
        name: "hls",
        title: "hue, lightness and saturation of sRGB code values: the double cone",
        channels: &[Channel::hue("H"), Channel::strict("L", 0.0, 1.0), Channel::strict("S", 0.0, 1.0)],
        srgb_only: true,
    };

    fn to_xyz(self) -> Xyz {
        let [h, l, s] = self.0;
        let rgb = Palette::from_color_unclamped(palette::Hsl::new(h, s, l));
        Srgb([rgb.red, rgb.green, rgb.blue]).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        let hsl = palette::Hsl::from_color_unclamped(settled(xyz));
        // Near black and white the quotient of two small numbers rounds to a little more than 1.
        Self([hsl.hue.into_positive_degrees(), hsl.lightness, hsl.saturation.min(1.0)])
    }
}

/// Hue, saturation, value: the single cone over sRGB code values (Smith 1978).
///
/// Hue as in [`Hls`]; saturation (max − min)/max and value max, 0 … 1. A colour outside of the sRGB gamut
/// becomes the nearest of the cube, component by component. By the crate `palette`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hsv(pub [f64; 3]);

impl ColorModel for Hsv {
    const INFO: ModelInfo = ModelInfo {
        name: "hsv",
        title: "hue, saturation and value of sRGB code values: the single cone",
        channels: &[Channel::hue("H"), Channel::strict("S", 0.0, 1.0), Channel::strict("V", 0.0, 1.0)],
        srgb_only: true,
    };

    fn to_xyz(self) -> Xyz {
        let [h, s, v] = self.0;
        let rgb = Palette::from_color_unclamped(palette::Hsv::new(h, s, v));
        Srgb([rgb.red, rgb.green, rgb.blue]).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        let hsv = palette::Hsv::from_color_unclamped(settled(xyz));
        Self([hsv.hue.into_positive_degrees(), hsv.saturation.min(1.0), hsv.value])
    }
}
