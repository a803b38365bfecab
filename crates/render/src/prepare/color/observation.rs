//! Who looks, and in which colour mode: the channels of a frame, and their way to a screen.

use glanz_color::{AdaptationError, Observer, ObserverKind, SAMPLES, Spectrum, observer, rgb_spectra};
use glanz_eye::Viewer;
use glanz_scene::ColorMode;
use thiserror::Error;

/// The luminance that a screen shows as its white when light is in cd/m²: that of the reference
/// display of IEC 61966-2-1 (sRGB).
pub const SCREEN_WHITE_CD_M2: f64 = 80.0;

/// Why nothing can be seen this way.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ObservationError {
    /// RGB has no wavelengths that an observer could see.
    #[error("mode 'rgb' knows no observer but the screen, found '{found}'; choose mode 'spectral'")]
    RgbHasNoObserver {
        /// The observer's name.
        found: String,
    },
    /// Meyer's samples belong to one observer.
    #[error("mode '{mode}' samples for the observer 'cie1931', found '{found}'; choose mode 'spectral'")]
    MeyerIsFor1931 {
        /// The mode's name.
        mode: String,
        /// The observer's name.
        found: String,
    },
    /// The scene has no light that could be a white.
    #[error("white '{white}' needs {expected}; choose D65 or none")]
    NoWhite {
        /// The name of the white.
        white: &'static str,
        /// What there should be.
        expected: &'static str,
    },
    /// Nobody can take that light for white.
    #[error("white '{white}' is none for this observer and mode: {source}; choose another white, or none")]
    NotWhite {
        /// The name of the white.
        white: &'static str,
        /// Why.
        source: AdaptationError,
    },
}

/// An observer and a colour mode.
///
/// Frames drawn for it hold the observer's channels, scaled so that a white Lambert surface that faces
/// a D65 light of 1 gives 1: in Y for observers in XYZ (their own x̄ and z̄ on the same scale), in every
/// channel for all others. Where the observer has a reference, it is the reference to which it gives 1. In mode RGB they hold linear sRGB.
///
/// ```
/// use glanz_render::Observation;
/// use glanz_scene::ColorMode;
///
/// let eye = Observation::new(ColorMode::Spectral, Some(glanz_color::observer("cie1964")?))?;
/// assert_eq!(eye.channel_count(), 3);
/// assert!(Observation::new(ColorMode::Rgb, Some(glanz_color::observer("cie1964")?)).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    pub(crate) mode: ColorMode,
    pub(crate) observer: Option<Observer>,
    /// The sensitivities on that scale; none in RGB.
    pub(crate) weights: Vec<Spectrum>,
    /// How far an eye is adapted to the white as it sees it itself, from 0 to 1.
    pub(crate) adapted: f64,
}

impl Default for Observation {
    fn default() -> Self {
        Self::rgb()
    }
}

impl Observation {
    /// Componentwise RGB.
    pub fn rgb() -> Self {
        Self { mode: ColorMode::Rgb, observer: None, weights: Vec::new(), adapted: 1.0 }
    }

    /// The mode, with this observer or else the one that the mode implies.
    pub fn new(mode: ColorMode, chosen: Option<Observer>) -> Result<Self, ObservationError> {
        if mode == ColorMode::Rgb {
            return match chosen {
                None => Ok(Self::rgb()),
                Some(observer) => Err(ObservationError::RgbHasNoObserver { found: observer.name }),
            };
        }
        let chosen = chosen.unwrap_or_else(cie1931);
        if matches!(mode, ColorMode::Meyer | ColorMode::MeyerAdapted) && chosen != cie1931() {
            let (mode, found) = (mode.to_string(), chosen.name);
            return Err(ObservationError::MeyerIsFor1931 { mode, found });
        }
        Ok(Self { mode, weights: scaled(&chosen), observer: Some(chosen), adapted: 1.0 })
    }

    /// The mode, seen by an eye that is adapted as it says.
    pub fn of_viewer(mode: ColorMode, viewer: &Viewer) -> Result<Self, ObservationError> {
        Ok(Self::new(mode, Some(viewer.observer()))?.adapted(viewer.viewing.adapted))
    }

    /// The 97 samples of the grid as channels: what is written into spectral pictures, in radiance per
    /// nm. Re-radiation is counted in.
    pub fn spectrum() -> Self {
        let channel = |i: usize| {
            let mut weight = Spectrum::ZERO;
            // Entries are summed over bands of 5 nm.
            weight.0[i] = 1.0 / glanz_color::STEP_NM;
            weight
        };
        let weights = (0..SAMPLES).map(channel).collect();
        Self { mode: ColorMode::Spectral, observer: None, weights, adapted: 1.0 }
    }

    /// The same, adapted to its own white by this degree: 0, what it sees beside what its reference sees (the yellow of an old
    /// lens, all of it); 1, white is white to it. It matters to observers with a reference alone.
    #[must_use]
    pub fn adapted(self, degree: f64) -> Self {
        Self { adapted: degree.clamp(0.0, 1.0), ..self }
    }

    /// The colour mode.
    pub fn mode(&self) -> ColorMode {
        self.mode
    }

    /// The observer; none in RGB.
    pub fn observer(&self) -> Option<&Observer> {
        self.observer.as_ref()
    }

    /// How many channels there are.
    pub fn channel_count(&self) -> usize {
        if self.weights.is_empty() { 3 } else { self.weights.len() }
    }

    /// The channels' names.
    pub fn channel_names(&self) -> Vec<String> {
        match &self.observer {
            Some(observer) => observer.channels.iter().map(|channel| channel.name.clone()).collect(),
            None if self.weights.is_empty() => ["R", "G", "B"].map(str::to_owned).to_vec(),
            None => (0..SAMPLES).map(|i| format!("{}nm", glanz_color::lambda_nm(i))).collect(),
        }
    }

    /// The sensitivity of a channel, scaled as the frame is; nothing beyond the last.
    pub(crate) fn weight(&self, channel: usize) -> &Spectrum {
        self.weights.get(channel).unwrap_or(&Spectrum::ZERO)
    }
}

pub(crate) fn cie1931() -> Observer {
    observer("cie1931").expect("the standard observer is in the list")
}

/// The observer's sensitivities on the scale of frames: that of its reference, if it has one.
pub(crate) fn scaled(observer: &Observer) -> Vec<Spectrum> {
    let daylight = rgb_spectra::daylight();
    let answer = |channel: usize| {
        let reference = observer.reference.as_ref().and_then(|reference| reference.channels.get(channel));
        reference.unwrap_or(&observer.channels[channel]).sensitivity.dot(&daylight)
    };
    let common = (observer.kind == ObserverKind::Xyz).then(|| answer(1));
    let channels = observer.channels.iter().enumerate();
    channels.map(|(i, channel)| channel.sensitivity * (1.0 / common.unwrap_or_else(|| answer(i)))).collect()
}
