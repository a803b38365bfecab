//! What the numbers of a frame mean.

use thiserror::Error;

/// What the channels of a frame are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Meaning {
    /// Linear light of the sRGB primaries: red, green, blue.
    #[default]
    LinearSrgb,
    /// Tristimulus values X, Y, Z of an observer.
    Xyz,
    /// Responses of receptors: the cones L, M, S, rods, or the channels of a camera.
    Receptors,
    /// Spectral radiance per nm, a channel for each wavelength.
    Spectrum,
    /// Not light: the colours of a debug view, on a screen as they are.
    Display,
}

impl Meaning {
    /// Its name in messages and metadata.
    pub fn name(self) -> &'static str {
        match self {
            Self::LinearSrgb => "linear sRGB",
            Self::Xyz => "XYZ",
            Self::Receptors => "receptor responses",
            Self::Spectrum => "spectral radiance",
            Self::Display => "display colours",
        }
    }
}

/// What the number 1 stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Scale {
    /// A white Lambert surface that faces a light of value 1.
    #[default]
    Classic,
    /// 1 cd/m² (of spectral radiance: that of a light of 1 cd/m² in all).
    Luminance,
}

/// The channels of a frame: what they are called, what they mean, and on which scale.
///
/// ```
/// use glanz_picture::{Channels, Meaning};
///
/// let rgb = Channels::default();
/// assert_eq!(rgb.names, ["R", "G", "B"]);
/// assert!(rgb.expect(Meaning::Xyz).is_err(), "XYZ is not shown as if it were RGB");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Channels {
    /// What they are.
    pub meaning: Meaning,
    /// Who sees them; none where no observer was asked.
    pub observer: Option<String>,
    /// A name for each channel, such as `X` or `450nm`.
    pub names: Vec<String>,
    /// The channels of a white Lambert surface under the light that counts as white; empty where there is none.
    pub white: Vec<f64>,
    /// What 1 stands for.
    pub scale: Scale,
}

impl Default for Channels {
    /// Linear sRGB in classic units.
    fn default() -> Self {
        Self {
            meaning: Meaning::LinearSrgb,
            observer: None,
            names: ["R", "G", "B"].map(str::to_owned).to_vec(),
            white: vec![1.0; 3],
            scale: Scale::Classic,
        }
    }
}

impl Channels {
    /// Those of a debug view.
    pub fn display() -> Self {
        Self { meaning: Meaning::Display, ..Self::default() }
    }
}

/// The channels are not what a step expects.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("expected a frame of {}, found {}; bring it to the screen first", .expected.name(), .found.name())]
pub struct ChannelError {
    /// What the settings of development are for.
    pub expected: Meaning,
    /// What the frame holds.
    pub found: Meaning,
}

impl Channels {
    /// That these channels are of the kind that a map to the screen, or development without one, expects. Debug
    /// views are for the screen already.
    pub fn expect(&self, expected: Meaning) -> Result<(), ChannelError> {
        let fits =
            self.meaning == expected || self.meaning == Meaning::Display && expected == Meaning::LinearSrgb;
        if fits { Ok(()) } else { Err(ChannelError { expected, found: self.meaning }) }
    }
}
