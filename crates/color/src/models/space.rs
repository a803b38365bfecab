//! RGB spaces as data: primaries, white, transfer.

use super::transfer::Transfer;
use crate::algebra::Matrix3;
use crate::models::cones::{BRADFORD, adaptation_matrix};

/// The chromaticity x, y of D65 as IEC 61966-2-1 and ITU-R BT.709, BT.2020 give it.
pub const D65_XY: [f64; 2] = [0.3127, 0.3290];

/// XYZ of the white of all models, Y = 1: 0.95045593, 1, 1.08905775.
pub const D65_XYZ: [f64; 3] = xyz_of(D65_XY);

/// XYZ with Y = 1 of a chromaticity.
const fn xyz_of([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

/// XYZ of a primary, as large as may be: a space scales it. Those of CIE XYZ itself have y = 0.
const fn column([x, y]: [f64; 2]) -> [f64; 3] {
    if y == 0.0 { [x, 0.0, 1.0 - x] } else { xyz_of([x, y]) }
}

/// An RGB space: everything that tells it from the others.
///
/// ```
/// use glanz_color::models::RgbSpace;
///
/// // The red of Display P3 is beyond that of sRGB: linear components above 1 and below 0.
/// let matrix = RgbSpace::DISPLAY_P3.to_linear_srgb_matrix().expect("the primaries differ");
/// let [r, g, b] = matrix.apply([1.0, 0.0, 0.0]);
/// assert!((r - 1.2249).abs() < 1e-4 && (g + 0.0420).abs() < 1e-4 && (b + 0.0196).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RgbSpace {
    /// Chromaticities x, y of red, green and blue.
    pub primaries: [[f64; 2]; 3],
    /// Chromaticity x, y of R = G = B.
    pub white: [f64; 2],
    /// Linear light to code values.
    pub transfer: Transfer,
    to_xyz: Matrix3,
    from_xyz: Matrix3,
}

impl RgbSpace {
    /// sRGB (IEC 61966-2-1:1999); primaries of BT.709.
    pub const SRGB: Self = Self::new([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]], D65_XY, Transfer::Srgb);
    /// The primaries of sRGB without its transfer.
    pub const LINEAR_SRGB: Self = Self::new(Self::SRGB.primaries, D65_XY, Transfer::Linear);
    /// Display P3 (Apple 2015): the primaries of SMPTE RP 431-2 with D65 and the transfer of sRGB.
    pub const DISPLAY_P3: Self =
        Self::new([[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], D65_XY, Transfer::Srgb);
    /// ITU-R BT.2020-2 (2015), code values by its camera curve.
    pub const REC2020: Self =
        Self::new([[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]], D65_XY, Transfer::Bt2020);
    /// Adobe RGB (1998), version 2005-05: exponent 563/256.
    pub const ADOBE_RGB: Self =
        Self::new([[0.64, 0.33], [0.21, 0.71], [0.15, 0.06]], D65_XY, Transfer::Power(563.0 / 256.0));
    /// ACEScg (S-2014-004): the primaries AP1, linear, white "D60", adapted to D65 by Bradford.
    pub const ACESCG: Self =
        Self::new([[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]], [0.321_68, 0.337_67], Transfer::Linear);

    /// The space of these primaries and this white; a white other than D65 is adapted by Bradford.
    pub const fn new(primaries: [[f64; 2]; 3], white: [f64; 2], transfer: Transfer) -> Self {
        let [r, g, b] = primaries;
        let unscaled = Matrix3::from_columns([column(r), column(g), column(b)]);
        let luminances = unscaled.inverse().apply(xyz_of(white));
        let own = unscaled.times(&Matrix3::diagonal(luminances));
        let same_white = white[0] == D65_XY[0] && white[1] == D65_XY[1];
        let to_xyz = match same_white {
            true => own,
            false => adaptation_matrix(&BRADFORD, xyz_of(white), D65_XYZ).times(&own),
        };
        Self { primaries, white, transfer, to_xyz, from_xyz: to_xyz.inverse() }
    }

    /// Linear components to XYZ relative to D65.
    pub const fn to_xyz_matrix(&self) -> &Matrix3 {
        &self.to_xyz
    }

    /// XYZ relative to D65 to linear components.
    pub const fn from_xyz_matrix(&self) -> &Matrix3 {
        &self.from_xyz
    }

    /// Linear components to those of linear sRGB. None where primaries and white are those of sRGB, but for
    /// the rounding of files to four digits. Not finite where the primaries span no colours.
    pub fn to_linear_srgb_matrix(&self) -> Option<Matrix3> {
        const SAME: f64 = 1e-3;
        let srgb = Self::LINEAR_SRGB;
        let own = self.primaries.iter().chain([&self.white]).flatten();
        let known = srgb.primaries.iter().chain([&srgb.white]).flatten();
        let is_srgb = own.zip(known).all(|(own, known)| (own - known).abs() < SAME);
        (!is_srgb).then(|| srgb.from_xyz.times(&self.to_xyz))
    }

    /// XYZ relative to D65 from code values.
    pub fn decode(&self, code: [f64; 3]) -> [f64; 3] {
        self.to_xyz.apply(code.map(|c| self.transfer.decode(c)))
    }

    /// Code values of XYZ relative to D65; nothing is clipped.
    pub fn encode(&self, xyz: [f64; 3]) -> [f64; 3] {
        self.from_xyz.apply(xyz).map(|c| self.transfer.encode(c))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_has_the_matrix_of_its_primaries() {
        // colour-science 0.4.7, normalised_primary_matrix of BT.709 and xy 0.3127, 0.3290.
        let expected = [
            [0.412_390_80, 0.357_584_34, 0.180_480_79],
            [0.212_639_01, 0.715_168_68, 0.072_192_32],
            [0.019_330_82, 0.119_194_78, 0.950_532_15],
        ];
        for (found, expected) in
            RgbSpace::SRGB.to_xyz_matrix().0.iter().flatten().zip(expected.iter().flatten())
        {
            assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
        }
    }

    #[test]
    fn cie_xyz_is_a_space_of_primaries_without_luminance() {
        let xyz = RgbSpace::new([[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]], D65_XY, Transfer::Linear);
        for color in [[0.2, 0.3, 0.4], D65_XYZ] {
            let scaled = [color[0] / D65_XYZ[0], color[1], color[2] / D65_XYZ[2]];
            let found = xyz.decode(scaled);
            assert!((0..3).all(|i| (found[i] - color[i]).abs() < 1e-14), "{found:?} {color:?}");
        }
    }

    #[test]
    fn white_is_d65_in_every_space() {
        for space in
            [RgbSpace::SRGB, RgbSpace::DISPLAY_P3, RgbSpace::REC2020, RgbSpace::ADOBE_RGB, RgbSpace::ACESCG]
        {
            let white = space.decode([1.0; 3]);
            for (found, expected) in white.iter().zip(D65_XYZ) {
                assert!((found - expected).abs() < 1e-14, "{space:?} {white:?}");
            }
        }
    }
}
