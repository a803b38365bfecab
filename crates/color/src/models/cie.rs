//! The models of the CIE: XYZ, xyY, CIELAB, LCh, CIELUV.

use palette::convert::FromColorUnclamped;

use super::info::{Channel, ColorModel, ModelInfo};
use super::space::{D65_XY, D65_XYZ};

/// CIE 1931 tristimulus values relative to white: Y = 1 for the white D65 of all models.
///
/// Not bounded; light may be brighter than white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Xyz(pub [f64; 3]);

impl Xyz {
    /// The white of all models.
    pub const WHITE: Self = Self(D65_XYZ);
}

impl From<[f64; 3]> for Xyz {
    fn from(xyz: [f64; 3]) -> Self {
        Self(xyz)
    }
}

impl ColorModel for Xyz {
    const INFO: ModelInfo = ModelInfo {
        name: "xyz",
        title: "CIE 1931 XYZ, white D65 with Y = 1",
        channels: &[
            Channel::nominal("X", 0.0, D65_XYZ[0]),
            Channel::nominal("Y", 0.0, D65_XYZ[1]),
            Channel::nominal("Z", 0.0, D65_XYZ[2]),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        self
    }

    fn from_xyz(xyz: Xyz) -> Self {
        xyz
    }
}

/// Chromaticity x, y and luminance Y, 1 for white.
///
/// Where X + Y + Z is 0 there is no chromaticity, and that of white stands for it. y = 0 with light in Y
/// is no colour: XYZ is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct XyY(pub [f64; 3]);

impl ColorModel for XyY {
    const INFO: ModelInfo = ModelInfo {
        name: "xyy",
        title: "CIE 1931 chromaticity x, y and luminance Y, 1 for white",
        channels: &[
            Channel::nominal("x", 0.0, 1.0),
            Channel::nominal("y", 0.0, 1.0),
            Channel::nominal("Y", 0.0, 1.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        let [x, y, luminance] = self.0;
        if luminance == 0.0 && y == 0.0 {
            return Xyz([0.0; 3]);
        }
        let sum = luminance / y;
        Xyz([x * sum, luminance, (1.0 - x - y) * sum])
    }

    fn from_xyz(Xyz([x, y, z]): Xyz) -> Self {
        let sum = x + y + z;
        if sum == 0.0 {
            return Self([D65_XY[0], D65_XY[1], y]);
        }
        Self([x / sum, y / sum, y])
    }
}

/// The white of the models, for palette.
struct White;

impl palette::white_point::WhitePoint<f64> for White {
    fn get_xyz() -> palette::Xyz<palette::white_point::Any, f64> {
        let [x, y, z] = D65_XYZ;
        palette::Xyz::new(x, y, z)
    }
}

type PaletteXyz = palette::Xyz<White, f64>;

/// L\*, a\*, b\* of CIE 15:2018, white D65.
///
/// L\* is 0 … 100 for surfaces, more for light brighter than white; the formula's straight piece goes on
/// below zero, so any XYZ has its L\*a\*b\*. By the crate `palette`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lab(pub [f64; 3]);

impl ColorModel for Lab {
    const INFO: ModelInfo = ModelInfo {
        name: "lab",
        title: "CIE 1976 L*a*b*, white D65",
        channels: &[
            Channel::nominal("L*", 0.0, 100.0),
            Channel::nominal("a*", -128.0, 128.0),
            Channel::nominal("b*", -128.0, 128.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        let [l, a, b] = self.0;
        let xyz = PaletteXyz::from_color_unclamped(palette::Lab::<White, f64>::new(l, a, b));
        Xyz([xyz.x, xyz.y, xyz.z])
    }

    fn from_xyz(Xyz([x, y, z]): Xyz) -> Self {
        let lab = palette::Lab::<White, f64>::from_color_unclamped(PaletteXyz::new(x, y, z));
        Self([lab.l, lab.a, lab.b])
    }
}

/// [`Lab`] in cylinder coordinates: L\*, chroma C\*ab, hue hab in degrees 0 … 360 (0 for greys).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lch(pub [f64; 3]);

impl ColorModel for Lch {
    const INFO: ModelInfo = ModelInfo {
        name: "lch",
        title: "CIE 1976 L*a*b* as lightness, chroma and hue, white D65",
        channels: &[
            Channel::nominal("L*", 0.0, 100.0),
            Channel::strict("C*", 0.0, f64::INFINITY),
            Channel::hue("h"),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Lab(from_cylinder(self.0)).to_xyz()
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(to_cylinder(Lab::from_xyz(xyz).0))
    }
}

/// L\*, u\*, v\* of CIE 15:2018, white D65.
///
/// Where X + 15 Y + 3 Z is 0, and where L\* is 0, there is no u\*, v\* and 0 stands for both: black has one
/// name. By the crate `palette`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Luv(pub [f64; 3]);

impl ColorModel for Luv {
    const INFO: ModelInfo = ModelInfo {
        name: "luv",
        title: "CIE 1976 L*u*v*, white D65",
        channels: &[
            Channel::nominal("L*", 0.0, 100.0),
            Channel::nominal("u*", -134.0, 224.0),
            Channel::nominal("v*", -140.0, 122.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        let [l, u, v] = self.0;
        let xyz = PaletteXyz::from_color_unclamped(palette::Luv::<White, f64>::new(l, u, v));
        Xyz([xyz.x, xyz.y, xyz.z])
    }

    fn from_xyz(Xyz([x, y, z]): Xyz) -> Self {
        let luv = palette::Luv::<White, f64>::from_color_unclamped(PaletteXyz::new(x, y, z));
        Self([luv.l, luv.u, luv.v])
    }
}

/// Lightness, chroma and hue in degrees from lightness and two opponent axes.
pub(super) fn to_cylinder([lightness, a, b]: [f64; 3]) -> [f64; 3] {
    let hue = libm::atan2(b, a).to_degrees();
    [lightness, libm::hypot(a, b), if hue < 0.0 { hue + 360.0 } else { hue }]
}

/// Lightness and two opponent axes from lightness, chroma and hue in degrees.
pub(super) fn from_cylinder([lightness, chroma, hue]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = libm::sincos(hue.to_radians());
    [lightness, chroma * cos, chroma * sin]
}
