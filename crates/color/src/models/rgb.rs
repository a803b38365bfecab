//! Colours in RGB spaces, a type for each space.

use super::info::{Channel, ColorModel, ModelInfo};
use super::{RgbSpace, Xyz};

const LIGHT: &[Channel] =
    &[Channel::nominal("R", 0.0, 1.0), Channel::nominal("G", 0.0, 1.0), Channel::nominal("B", 0.0, 1.0)];

/// Types that hold R, G, B of a space.
macro_rules! rgb_types {
    ($($(#[$doc:meta])* $Name:ident, $space:ident, $name:literal, $title:literal;)*) => {$(
        $(#[$doc])*
        ///
        /// 0 … 1 is the space's gamut. Colours outside of it have components outside of it; nothing is
        /// clipped.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $Name(pub [f64; 3]);

        impl $Name {
            /// The space as data.
            pub const SPACE: RgbSpace = RgbSpace::$space;
        }

        impl ColorModel for $Name {
            const INFO: ModelInfo =
                ModelInfo { name: $name, title: $title, channels: LIGHT, srgb_only: false };

            fn to_xyz(self) -> Xyz {
                const { &Self::SPACE }.decode(self.0).into()
            }

            fn from_xyz(Xyz(xyz): Xyz) -> Self {
                Self(const { &Self::SPACE }.encode(xyz))
            }
        }
    )*};
}

rgb_types! {
    /// Linear light of the primaries of sRGB: [`RgbSpace::LINEAR_SRGB`].
    LinearSrgb, LINEAR_SRGB, "srgb-linear", "linear light of the primaries of sRGB";
    /// Code values of sRGB: [`RgbSpace::SRGB`].
    Srgb, SRGB, "srgb", "code values of sRGB (IEC 61966-2-1)";
    /// Code values of Display P3: [`RgbSpace::DISPLAY_P3`].
    DisplayP3, DISPLAY_P3, "display-p3", "code values of Display P3";
    /// Code values of ITU-R BT.2020: [`RgbSpace::REC2020`].
    Rec2020, REC2020, "rec2020", "code values of ITU-R BT.2020";
    /// Code values of Adobe RGB (1998): [`RgbSpace::ADOBE_RGB`].
    AdobeRgb, ADOBE_RGB, "adobe-rgb", "code values of Adobe RGB (1998)";
    /// Linear light of the primaries AP1, adapted from the white of ACES to D65: [`RgbSpace::ACESCG`].
    AcesCg, ACESCG, "acescg", "linear light of the primaries AP1, white adapted to D65 by Bradford";
}

impl Srgb {
    /// The nearest colour of the cube, component by component.
    #[must_use]
    pub fn clipped(self) -> Self {
        Self(self.0.map(|c| c.clamp(0.0, 1.0)))
    }

    /// Linear light.
    pub fn decoded(self) -> LinearSrgb {
        LinearSrgb(self.0.map(|c| Self::SPACE.transfer.decode(c)))
    }
}

impl LinearSrgb {
    /// Code values.
    pub fn encoded(self) -> Srgb {
        Srgb(self.0.map(|c| Srgb::SPACE.transfer.encode(c)))
    }
}
