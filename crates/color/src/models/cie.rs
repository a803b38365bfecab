//! The models of the CIE: XYZ, xyY, CIELAB, LCh, CIELUV.

use palette::convert::FromColorUnclamped;

use super::info::{Channel, ColorModel, ModelInfo};
use super::space::{D65_XY, D65_XYZ};

/// CIE 1931 tristimulus values relative to white: Y = 1 for the white D65 of all models.
///
/// Not bounded; light may be brighter than white.
///
/// ```
/// use glanz_color::models::{ColorModel, Srgb, XyY, Xyz};
///
/// // The green of sRGB has the luminance 0.7152 and the chromaticity 0.30, 0.60.
/// let Xyz([_, luminance, _]) = Srgb([0.0, 1.0, 0.0]).to_xyz();
/// assert!((luminance - 0.7152).abs() < 5e-5);
/// let XyY([x, y, _]) = Srgb([0.0, 1.0, 0.0]).to();
/// assert!((x - 0.30).abs() < 1e-12 && (y - 0.60).abs() < 1e-12);
/// ```
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
/// below zero, so any XYZ has its L\*a\*b\*. By the crate `palette`. [`Lab::for_white`] is for other whites than D65.
///
/// ```
/// use glanz_color::models::{ColorModel, Lab, Srgb, Xyz};
///
/// // The red of sRGB.
/// let Lab([l, a, b]) = Srgb([1.0, 0.0, 0.0]).to();
/// assert!((l - 53.24).abs() < 0.01 && (a - 80.09).abs() < 0.01 && (b - 67.20).abs() < 0.01);
///
/// // A print is viewed under D50, which is its white: XYZ over 100 of both.
/// let (paper, d50) = (Xyz([80.0, 83.0, 68.0]), Xyz([96.42, 100.0, 82.49]));
/// let Lab([l, a, b]) = Lab::for_white(paper, d50);
/// assert!((l - 93.0).abs() < 0.1 && a.abs() < 0.5 && b.abs() < 0.5, "nearly white");
/// assert!((Lab([l, a, b]).xyz_for_white(d50).0[1] - 83.0).abs() < 1e-12);
/// ```
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

impl Lab {
    /// L\*, a\*, b\* relative to any white, such as that of the light that a surface is seen under. Only the ratios of `xyz`
    /// to `white` count, so both may be on any one scale; without one of the white's X, Y, Z the result is not finite.
    pub fn for_white(Xyz(xyz): Xyz, Xyz(white): Xyz) -> Self {
        Self::from_xyz(Xyz(core::array::from_fn(|i| xyz[i] / white[i] * D65_XYZ[i])))
    }

    /// XYZ of the colour for any white, on the white's scale: the inverse of [`Lab::for_white`].
    pub fn xyz_for_white(self, Xyz(white): Xyz) -> Xyz {
        let Xyz(xyz) = self.to_xyz();
        Xyz(core::array::from_fn(|i| xyz[i] / D65_XYZ[i] * white[i]))
    }
}

/// [`Lab`] in cylinder coordinates: L\*, chroma C\*ab, hue hab in degrees 0 … 360 (0 for greys).
///
/// ```
/// use glanz_color::models::{ColorModel, Lab, Lch};
///
/// let Lch([l, chroma, hue_deg]) = Lch::from(Lab([50.0, 30.0, 40.0]));
/// assert!(l == 50.0 && (chroma - 50.0).abs() < 1e-12 && (hue_deg - 53.130).abs() < 1e-3);
/// ```
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

impl From<Lab> for Lch {
    /// Whatever white the L\*, a\*, b\* are relative to.
    fn from(lab: Lab) -> Self {
        Self(to_cylinder(lab.0))
    }
}

impl From<Lch> for Lab {
    /// Whatever white the L\*, chroma and hue are relative to.
    fn from(lch: Lch) -> Self {
        Self(from_cylinder(lch.0))
    }
}

/// L\*, u\*, v\* of CIE 15:2018, white D65.
///
/// Where X + 15 Y + 3 Z is 0, and where L\* is 0, there is no u\*, v\* and 0 stands for both: black has one
/// name. By the crate `palette`. [`Luv::for_white`] is for other whites than D65.
///
/// ```
/// use glanz_color::models::{ColorModel, Luv, Srgb, Xyz};
///
/// let Luv([l, u, v]) = Srgb([1.0, 0.0, 0.0]).to();
/// assert!((l - 53.24).abs() < 0.01 && (u - 175.01).abs() < 0.01 && (v - 37.77).abs() < 0.01);
/// // The light that a colour is seen under is its white.
/// let a = Xyz([109.85, 100.0, 35.58]);
/// assert_eq!(Luv::for_white(a, a).0, [100.0, 0.0, 0.0]);
/// ```
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

impl Luv {
    /// L\*, u\*, v\* relative to any white: L\* = 116 f(Y/Yn) − 16, u\* = 13 L\* (u′ − u′n), v\* = 13 L\* (v′ − v′n). `xyz` and
    /// `white` are on one scale, whichever; a white of Y = 0 gives numbers that are not finite.
    pub fn for_white(xyz: Xyz, white: Xyz) -> Self {
        let Lab([l, _, _]) = Lab::for_white(Xyz([xyz.0[1]; 3]), Xyz([white.0[1]; 3]));
        let (Some([u, v]), Some([u_white, v_white])) = (uv1976(xyz), uv1976(white)) else {
            return Self([l, 0.0, 0.0]);
        };
        if l == 0.0 {
            return Self([0.0; 3]);
        }
        Self([l, 13.0 * l * (u - u_white), 13.0 * l * (v - v_white)])
    }

    /// XYZ of the colour for any white, on the white's scale: the inverse of [`Luv::for_white`].
    pub fn xyz_for_white(self, white: Xyz) -> Xyz {
        let [l, u, v] = self.0;
        let Xyz([_, y, _]) = Lab([l, 0.0, 0.0]).xyz_for_white(Xyz([white.0[1]; 3]));
        let Some([u_white, v_white]) = uv1976(white).filter(|_| l != 0.0) else { return Xyz([0.0; 3]) };
        let (u, v) = (u / (13.0 * l) + u_white, v / (13.0 * l) + v_white);
        Xyz([y * 9.0 * u / (4.0 * v), y, y * (12.0 - 3.0 * u - 20.0 * v) / (4.0 * v)])
    }
}

/// u′ and v′ of the CIE 1976 diagram; none for black.
fn uv1976(Xyz([x, y, z]): Xyz) -> Option<[f64; 2]> {
    let by = x + 15.0 * y + 3.0 * z;
    (by != 0.0).then(|| [4.0 * x / by, 9.0 * y / by])
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
