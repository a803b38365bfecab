//! OKLab and OKLCh.

use palette::convert::FromColorUnclamped;
use palette::white_point::D65;

use super::Xyz;
use super::cie::{from_cylinder, to_cylinder};
use super::info::{Channel, ColorModel, ModelInfo};

/// OKLab (Ottosson 2020): L 1 for white, a and b about −0.4 … 0.4.
///
/// By the crate `palette`, with the matrices recomputed for the exact white 0.3127, 0.3290 (CSS Color 4),
/// so that greys have a = b = 0 to 1e-7; the digits first published miss that by 4e-5. Unbounded; the cube
/// root goes on below zero.
///
/// ```
/// use glanz_color::models::{ColorModel, Oklab, Srgb};
///
/// // The red of sRGB, as CSS Color 4 has it.
/// let Oklab([l, a, b]) = Srgb([1.0, 0.0, 0.0]).to();
/// assert!((l - 0.6280).abs() < 1e-4 && (a - 0.2249).abs() < 1e-4 && (b - 0.1258).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oklab(pub [f64; 3]);

impl ColorModel for Oklab {
    const INFO: ModelInfo = ModelInfo {
        name: "oklab",
        title: "OKLab (Ottosson 2020)",
        channels: &[
            Channel::nominal("L", 0.0, 1.0),
            Channel::nominal("a", -0.4, 0.4),
            Channel::nominal("b", -0.4, 0.4),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        let [l, a, b] = self.0;
        let xyz = palette::Xyz::<D65, f64>::from_color_unclamped(palette::Oklab::new(l, a, b));
        Xyz([xyz.x, xyz.y, xyz.z])
    }

    fn from_xyz(Xyz([x, y, z]): Xyz) -> Self {
        let oklab = palette::Oklab::from_color_unclamped(palette::Xyz::<D65, f64>::new(x, y, z));
        Self([oklab.l, oklab.a, oklab.b])
    }
}

/// [`Oklab`] in cylinder coordinates: L, chroma, hue in degrees 0 … 360.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oklch(pub [f64; 3]);

impl ColorModel for Oklch {
    const INFO: ModelInfo = ModelInfo {
        name: "oklch",
        title: "OKLab as lightness, chroma and hue",
        channels: &[
            Channel::nominal("L", 0.0, 1.0),
            Channel::strict("C", 0.0, f64::INFINITY),
            Channel::hue("h"),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Oklab(from_cylinder(self.0)).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(to_cylinder(Oklab::from_xyz(xyz).0))
    }
}
