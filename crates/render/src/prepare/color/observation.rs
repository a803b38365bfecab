//! Who looks, and in which colour mode: the channels of a frame, and their way to a screen.

use glanz_color::{
    Adaptation, AdaptationError, Matrix3, Observer, ObserverKind, SAMPLES, Spectrum, Xyz, observer,
    rgb_spectra,
};
use glanz_scene::{ColorMode, LightColor, LightKind, Scene, White};
use thiserror::Error;

use crate::prepare::color::quadrature::{Channels, Row, Sampling, Surface};
use glanz_picture::ToScreen;

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
/// channel for all others. In mode RGB they hold linear sRGB.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    mode: ColorMode,
    observer: Option<Observer>,
    /// The sensitivities on that scale; none in RGB.
    weights: Vec<Spectrum>,
}

impl Default for Observation {
    fn default() -> Self {
        Self::rgb()
    }
}

impl Observation {
    /// Componentwise RGB.
    pub fn rgb() -> Self {
        Self { mode: ColorMode::Rgb, observer: None, weights: Vec::new() }
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
        Ok(Self { mode, weights: scaled(&chosen), observer: Some(chosen) })
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
        Self { mode: ColorMode::Spectral, observer: None, weights }
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

    /// The way from the channels to a screen, for this white; none where they already are linear sRGB.
    pub fn to_screen(&self, scene: &Scene, white: White) -> Result<Option<ToScreen>, ObservationError> {
        let gain = if scene.photometric { 1.0 / SCREEN_WHITE_CD_M2 } else { 1.0 };
        let Some(observer) = &self.observer else {
            return Ok((gain != 1.0).then(|| ToScreen::of_matrix(Matrix3::IDENTITY.scaled(gain))));
        };
        let to_xyz = ToXyz::new(observer, &self.weights);
        let to_rgb = match white {
            White::None => rgb_spectra::XYZ_TO_RGB,
            _ => {
                let luminance = self.luminance(scene, white)?;
                let seen = to_xyz.apply(&self.white(scene, white)?);
                let adapted = Adaptation::Bradford
                    .matrix(Xyz(seen.map(|v| v / luminance)), Xyz(rgb_spectra::SCREEN_WHITE))
                    .map_err(|source| ObservationError::NotWhite { white: white.name(), source })?;
                rgb_spectra::XYZ_TO_RGB.times(&adapted)
            }
        };
        Ok(Some(ToScreen::of_columns(to_xyz.columns.iter().map(|xyz| to_rgb.apply(*xyz).map(|v| v * gain)))))
    }

    /// The luminance of a white surface under that white: the observer's own, from the whole spectrum, since
    /// few samples miss it; of observers without one, that of CIE 1931.
    fn luminance(&self, scene: &Scene, white: White) -> Result<f64, ObservationError> {
        if self.observer.as_ref().is_some_and(|observer| observer.kind == ObserverKind::Xyz) {
            let whole = Self { mode: ColorMode::Spectral, ..self.clone() };
            return Ok(whole.white(scene, white)?[1]);
        }
        let luminance = |color: &LightColor| match color {
            LightColor::Rgb(rgb) => f64::from(rgb.luminance()),
            LightColor::Spectrum(spectrum) => rgb_spectra::luminance(spectrum),
        };
        Ok(white_lights(scene, white)?.iter().map(luminance).sum())
    }

    /// All channels of a white surface under that white.
    fn white(&self, scene: &Scene, white: White) -> Result<Vec<f64>, ObservationError> {
        let lights = white_lights(scene, white)?;
        let mut channels = Vec::new();
        for first in (0..self.channel_count()).step_by(3) {
            channels.extend(white_under(&Sampling::new(self, first), &lights));
        }
        channels.truncate(self.channel_count());
        Ok(channels)
    }
}

/// The lights that make a white.
fn white_lights(scene: &Scene, white: White) -> Result<Vec<LightColor>, ObservationError> {
    let lights: Vec<LightColor> = match white {
        White::Scene => scene.lights.iter().map(own_color).cloned().collect(),
        White::Light => first_light(scene).cloned().into_iter().collect(),
        White::D65 | White::None => {
            vec![LightColor::Spectrum(std::sync::Arc::new(rgb_spectra::daylight()))]
        }
    };
    match lights.iter().all(LightColor::is_black) {
        true => Err(ObservationError::NoWhite { white: white.name(), expected: "a light in the scene" }),
        false => Ok(lights),
    }
}

fn white_under(sampling: &Sampling, lights: &[LightColor]) -> Channels {
    let rows: Vec<Row> = lights.iter().map(|light| sampling.light(light)).collect();
    let response = sampling.response(&Surface::Reflectance(vec![1.0; rows[0].len()]), None);
    let mut sum = [0.0; 3];
    for row in &rows {
        sum.iter_mut().zip(response.under(row)).for_each(|(sum, value)| *sum += value);
    }
    sum
}

/// The colour of the first light that sends any, those with a direction before ambient ones.
fn first_light(scene: &Scene) -> Option<&LightColor> {
    let lit = |ambient: bool| {
        let lights = scene.lights.iter().filter(move |light| (light.kind == LightKind::Ambient) == ambient);
        lights.map(own_color).find(|color| !color.is_black())
    };
    lit(false).or_else(|| lit(true))
}

/// The colour by which a light counts towards the white.
fn own_color(light: &glanz_scene::Light) -> &LightColor {
    match light.kind {
        LightKind::Ambient => &light.colors.ambient,
        _ => &light.colors.diffuse,
    }
}

fn cie1931() -> Observer {
    observer("cie1931").expect("the standard observer is in the list")
}

/// The observer's sensitivities on the scale of frames.
fn scaled(observer: &Observer) -> Vec<Spectrum> {
    let daylight = rgb_spectra::daylight();
    let answer = |channel: usize| observer.channels[channel].sensitivity.dot(&daylight);
    let common = (observer.kind == ObserverKind::Xyz).then(|| answer(1));
    let channels = observer.channels.iter().enumerate();
    channels.map(|(i, channel)| channel.sensitivity * (1.0 / common.unwrap_or_else(|| answer(i)))).collect()
}

/// What XYZ each channel stands for, by least squares over the curves of CIE 1931.
///
/// Observers in XYZ are taken as they are, a single channel is a grey. A sensor whose curves are linear
/// combinations of those of CIE 1931 comes out exactly.
struct ToXyz {
    columns: Vec<[f64; 3]>,
}

impl ToXyz {
    fn new(observer: &Observer, weights: &[Spectrum]) -> Self {
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let white = rgb_spectra::SCREEN_WHITE;
        match (observer.kind, weights.len()) {
            (ObserverKind::Xyz, _) => Self { columns: units.to_vec() },
            (_, 1) => Self { columns: vec![white] },
            _ => Self { columns: least_squares(weights, &scaled(&cie1931())) },
        }
    }

    fn apply(&self, channels: &[f64]) -> [f64; 3] {
        let mut xyz = [0.0; 3];
        for (column, value) in self.columns.iter().zip(channels) {
            xyz.iter_mut().zip(column).for_each(|(sum, c)| *sum += c * value);
        }
        xyz
    }
}

/// The columns M that make Σ_k M\[k\] · weights\[k\] the nearest to the three `targets`.
fn least_squares(weights: &[Spectrum], targets: &[Spectrum]) -> Vec<[f64; 3]> {
    let count = weights.len();
    // Normal equations, a trace of the diagonal added so that equal channels share their column.
    let mut rows: Vec<Vec<f64>> = (0..count)
        .map(|i| {
            let mut row: Vec<f64> = weights.iter().map(|other| weights[i].dot(other)).collect();
            row[i] *= 1.0 + 1e-9;
            row.extend(targets.iter().take(3).map(|target| weights[i].dot(target)));
            row
        })
        .collect();
    for pivot in 0..count {
        let best = (pivot..count).max_by(|a, b| rows[*a][pivot].abs().total_cmp(&rows[*b][pivot].abs()));
        rows.swap(pivot, best.unwrap_or(pivot));
        let divisor = rows[pivot][pivot];
        if divisor == 0.0 {
            continue;
        }
        let own: Vec<f64> = rows[pivot].iter().map(|v| v / divisor).collect();
        for (_, row) in rows.iter_mut().enumerate().filter(|(number, _)| *number != pivot) {
            let factor = row[pivot];
            row.iter_mut().zip(&own).for_each(|(v, o)| *v -= factor * o);
        }
        rows[pivot] = own;
    }
    rows.iter().map(|row| core::array::from_fn(|c| row[count + c])).collect()
}
