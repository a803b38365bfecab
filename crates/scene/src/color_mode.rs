//! The ways to treat colour, and the white that the eye is adapted to.

use core::fmt;
use core::str::FromStr;

use serde::{Deserialize, Serialize};

/// How the tint tables are filled: the only thing in which a picture in RGB and one in spectra
/// differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum ColorMode {
    /// Componentwise in linear sRGB, as in OpenGL.
    #[default]
    Rgb,
    /// All 97 wavelengths from 300 to 780 nm, re-radiation included.
    Spectral,
    /// Meyer's four samples with the published weights, 1988.
    Meyer,
    /// Meyer's four samples with weights solved for the scene's lights.
    MeyerAdapted,
    /// So many wavelengths, evenly spaced.
    Sampled(u8),
    /// One picture per pair of wavelengths: slow, and the truth that others are measured against.
    Reference,
}

/// The names in files and on the command line, and what they mean.
pub const COLOR_MODES: [(&str, &str); 6] = [
    ("rgb", "componentwise in linear sRGB"),
    ("spectral", "all 97 wavelengths from 300 to 780 nm, fluorescence included"),
    ("meyer", "Meyer's four samples with the published weights"),
    ("meyer-adapted", "Meyer's four samples with weights for the scene's lights"),
    ("sampled:N", "N evenly spaced wavelengths, 1 to 97"),
    ("reference", "one picture per pair of wavelengths: slow, to measure the others against"),
];

impl fmt::Display for ColorMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rgb => f.write_str("rgb"),
            Self::Spectral => f.write_str("spectral"),
            Self::Meyer => f.write_str("meyer"),
            Self::MeyerAdapted => f.write_str("meyer-adapted"),
            Self::Sampled(count) => write!(f, "sampled:{count}"),
            Self::Reference => f.write_str("reference"),
        }
    }
}

impl FromStr for ColorMode {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = |text: &str| text.parse::<u8>().ok().filter(|count| (1..=97).contains(count));
        match (text, text.strip_prefix("sampled:")) {
            ("rgb", _) => Ok(Self::Rgb),
            ("spectral", _) => Ok(Self::Spectral),
            ("meyer", _) => Ok(Self::Meyer),
            ("meyer-adapted", _) => Ok(Self::MeyerAdapted),
            ("reference", _) => Ok(Self::Reference),
            (_, Some(number)) => count(number).map(Self::Sampled).ok_or_else(|| {
                format!("expected between 1 and 97 wavelengths, as in sampled:8, found 'sampled:{number}'")
            }),
            _ => {
                let known = COLOR_MODES.map(|(name, _)| name).join(", ");
                Err(format!("expected a colour mode ({known}), found '{text}'"))
            }
        }
    }
}

/// The white that becomes the white of the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum White {
    /// Daylight D65, as the chosen observer sees it.
    #[default]
    D65,
    /// All lights of the scene together.
    Scene,
    /// The first light of the scene, those with a direction before ambient ones.
    Light,
    /// None: tristimulus values are shown as they are.
    None,
}

impl White {
    /// All of them with their names and what they mean.
    pub const ALL: [(Self, &'static str, &'static str); 4] = [
        (Self::D65, "D65", "daylight, as the observer sees it"),
        (Self::Scene, "scene", "all lights of the scene together"),
        (Self::Light, "light", "the first light of the scene"),
        (Self::None, "none", "no adaptation: tristimulus values as they are"),
    ];

    /// The name in files and on the command line.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(white, ..)| *white == self).map_or("D65", |(_, name, _)| name)
    }
}

impl FromStr for White {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.iter().find(|(_, name, _)| name.eq_ignore_ascii_case(text));
        found.map(|(white, ..)| *white).ok_or_else(|| {
            let known = Self::ALL.map(|(_, name, _)| name).join(", ");
            format!("expected one of {known}, found '{text}'")
        })
    }
}

impl TryFrom<String> for ColorMode {
    type Error = String;
    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<ColorMode> for String {
    fn from(mode: ColorMode) -> Self {
        mode.to_string()
    }
}

impl TryFrom<String> for White {
    type Error = String;
    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<White> for String {
    fn from(white: White) -> Self {
        white.name().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mode_survives_its_name() {
        let modes = [
            ColorMode::Rgb,
            ColorMode::Spectral,
            ColorMode::Meyer,
            ColorMode::MeyerAdapted,
            ColorMode::Sampled(8),
            ColorMode::Reference,
        ];
        for mode in modes {
            assert_eq!(mode.to_string().parse(), Ok(mode));
        }
        for wrong in ["sampled", "sampled:0", "sampled:98", "sampled:x", "RGB", ""] {
            assert!(wrong.parse::<ColorMode>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn whites_are_found_by_name() {
        for (white, name, _) in White::ALL {
            assert_eq!((name.parse(), white.name()), (Ok(white), name));
        }
        assert!("red".parse::<White>().is_err());
    }
}
