//! Models that follow the eye: cones, opponent channels, Meyer's AC1C2.

use super::Xyz;
use super::info::{Channel, ColorModel, ModelInfo};
use super::space::D65_XYZ;
use crate::algebra::Matrix3;
use crate::models::cones::HUNT_POINTER_ESTEVEZ_D65;

const CONES_TO_XYZ: Matrix3 = HUNT_POINTER_ESTEVEZ_D65.inverse();

/// The signals of the long, middle and short cones, by the matrix of Hunt, Pointer and Estevez scaled to
/// D65 ([`HUNT_POINTER_ESTEVEZ_D65`]): white is 1, 1, 1 to 1e-5, as
/// the digits of the matrix allow.
///
/// This is a map of CIE 1931 XYZ. Signals of the cones of Stockman and Sharpe (CIE 170-1, 2006) are no
/// function of XYZ; they come from a spectrum and those observers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lms(pub [f64; 3]);

impl ColorModel for Lms {
    const INFO: ModelInfo = ModelInfo {
        name: "lms",
        title: "cone signals (Hunt-Pointer-Estevez), white D65 1, 1, 1",
        channels: &[
            Channel::nominal("L", 0.0, 1.0),
            Channel::nominal("M", 0.0, 1.0),
            Channel::nominal("S", 0.0, 1.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Xyz(CONES_TO_XYZ.apply(self.0))
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(HUNT_POINTER_ESTEVEZ_D65.apply(xyz.0))
    }
}

/// XYZ to cones whose signals for D65 are 1 to the last digit, which those of [`Lms`] are to 1e-5 only.
const XYZ_TO_BALANCED_CONES: Matrix3 = {
    let [l, m, s] = HUNT_POINTER_ESTEVEZ_D65.apply(D65_XYZ);
    Matrix3::diagonal([1.0 / l, 1.0 / m, 1.0 / s]).times(&HUNT_POINTER_ESTEVEZ_D65)
};
/// Cones to luminance, red − green, yellow − blue.
const CONES_TO_OPPONENT: Matrix3 =
    Matrix3([XYZ_TO_BALANCED_CONES.inverse().0[1], [1.0, -1.0, 0.0], [0.5, 0.5, -1.0]]);
const XYZ_TO_OPPONENT: Matrix3 = CONES_TO_OPPONENT.times(&XYZ_TO_BALANCED_CONES);
const OPPONENT_TO_XYZ: Matrix3 = XYZ_TO_OPPONENT.inverse();

/// The three opponent channels of the lateral geniculate nucleus: luminance, the difference of red and green, the
/// difference of yellow and blue.
///
/// With the signals of [`Lms`], each divided by its value for D65: luminance = Y (0.361 L + 0.639 M), red − green =
/// L − M, and yellow − blue = (L + M)/2 − S. The course gives no weights; these are the plain ones. Greys under D65
/// have 0 in both differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opponent(pub [f64; 3]);

impl ColorModel for Opponent {
    const INFO: ModelInfo = ModelInfo {
        name: "opponent",
        title: "luminance, red - green, yellow - blue from the cone signals",
        channels: &[
            Channel::nominal("A", 0.0, 1.0),
            Channel::nominal("R-G", -1.0, 1.0),
            Channel::nominal("Y-B", -1.0, 1.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Xyz(OPPONENT_TO_XYZ.apply(self.0))
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(XYZ_TO_OPPONENT.apply(xyz.0))
    }
}

/// XYZ to A, C1, C2 (Meyer 1988, CVGIP 41:57–79, eq. 6).
pub const XYZ_TO_AC1C2: Matrix3 =
    Matrix3([[-0.0177, 1.0090, 0.0073], [-1.5370, 1.0821, 0.3209], [0.1946, -0.2045, 0.5264]]);

/// A, C1, C2 to XYZ: the exact inverse of [`XYZ_TO_AC1C2`].
pub const AC1C2_TO_XYZ: Matrix3 = XYZ_TO_AC1C2.inverse();

/// Meyer's opponent space: axes along which the colours of surfaces vary most, found for computing light
/// with few samples.
///
/// A is close to Y; C1 lies between red (−) and green (+), C2 between yellow (−) and blue (+).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ac1c2(pub [f64; 3]);

impl ColorModel for Ac1c2 {
    const INFO: ModelInfo = ModelInfo {
        name: "ac1c2",
        title: "Meyer's opponent space (1988)",
        channels: &[
            Channel::nominal("A", 0.0, 1.0),
            Channel::nominal("C1", -1.0, 1.0),
            Channel::nominal("C2", -1.0, 1.0),
        ],
        srgb_only: false,
    };

    fn to_xyz(self) -> Xyz {
        Xyz(AC1C2_TO_XYZ.apply(self.0))
    }

    fn from_xyz(xyz: Xyz) -> Self {
        Self(XYZ_TO_AC1C2.apply(xyz.0))
    }
}
