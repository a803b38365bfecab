//! The way from an observer's channels to a screen, and the white that is adapted to.

use glanz_color::{Adaptation, Matrix3, Observer, ObserverKind, Spectrum, Xyz, rgb_spectra};
use glanz_picture::{Channels, Meaning, Scale, ToScreen};
use glanz_scene::{ColorMode, Light, LightColor, LightKind, Scene, White};

use super::observation::{Observation, ObservationError, SCREEN_WHITE_CD_M2, cie1931, scaled};
use super::quadrature::{Row, Sampling, Surface, Triple};

impl Observation {
    /// The way from the channels to a screen, for this white; none where they already are linear sRGB.
    pub fn to_screen(&self, scene: &Scene, white: White) -> Result<Option<ToScreen>, ObservationError> {
        self.to_screen_under(&scene.lights, scene.photometric, white)
    }

    /// The same for lights that are in photometric units or not.
    pub(crate) fn to_screen_under(
        &self,
        lights: &[Light],
        photometric: bool,
        white: White,
    ) -> Result<Option<ToScreen>, ObservationError> {
        let gain = if photometric { 1.0 / SCREEN_WHITE_CD_M2 } else { 1.0 };
        let Some(observer) = &self.observer else {
            return Ok(
                (gain != 1.0).then(|| ToScreen::of_matrix(self.meaning(), Matrix3::IDENTITY.scaled(gain)))
            );
        };
        let to_xyz = ToXyz::new(observer);
        let own = self.own_white(lights, white)?;
        let to_rgb = match white {
            White::None => rgb_spectra::XYZ_TO_RGB,
            _ => {
                let luminance = self.luminance(lights, white)?;
                let seen = to_xyz.apply(&own.reference);
                let adapted = Adaptation::Bradford
                    .matrix(Xyz(seen.map(|v| v / luminance)), Xyz(rgb_spectra::SCREEN_WHITE))
                    .map_err(|source| ObservationError::NotWhite { white: white.name(), source })?;
                rgb_spectra::XYZ_TO_RGB.times(&adapted)
            }
        };
        Ok(Some(ToScreen::of_columns(
            self.meaning(),
            to_xyz
                .columns
                .iter()
                .zip(own.gains())
                .map(|(xyz, own)| to_rgb.apply(*xyz).map(|v| v * own * gain)),
        )))
    }

    /// The white as the observer sees it and as its reference does.
    ///
    /// # Errors
    /// If the scene has no light that could be a white.
    pub fn own_white(&self, lights: &[Light], white: White) -> Result<OwnWhite, ObservationError> {
        let own = self.white(lights, white)?;
        let reference = match self.observer.as_ref().and_then(|observer| observer.reference.as_deref()) {
            None => own.clone(),
            Some(reference) => {
                let seen =
                    Self { weights: scaled(reference), observer: Some(reference.clone()), ..self.clone() };
                seen.white(lights, white)?
            }
        };
        Ok(OwnWhite { own, reference, adapted: self.adapted })
    }

    /// The luminance of a white surface under that white: the observer's own, from the whole spectrum, since
    /// few samples miss it; of observers without one, that of CIE 1931.
    fn luminance(&self, lights: &[Light], white: White) -> Result<f64, ObservationError> {
        if self.observer.as_ref().is_some_and(|observer| observer.kind == ObserverKind::Xyz) {
            let whole = Self { mode: ColorMode::Spectral, ..self.clone() };
            return Ok(whole.white(lights, white)?[1]);
        }
        let luminance = |color: &LightColor| match color {
            LightColor::Rgb(rgb) => f64::from(rgb.luminance()),
            LightColor::Spectrum(spectrum) => rgb_spectra::luminance(spectrum),
        };
        Ok(white_lights(lights, white)?.iter().map(luminance).sum())
    }

    /// All channels of a white surface under that white.
    pub(crate) fn white(&self, lights: &[Light], white: White) -> Result<Vec<f64>, ObservationError> {
        let whites = white_lights(lights, white)?;
        let mut channels = Vec::new();
        for first in (0..self.channel_count()).step_by(3) {
            channels.extend(white_under(&Sampling::new(self, first), &whites));
        }
        channels.truncate(self.channel_count());
        Ok(channels)
    }

    /// What the channels of frames are.
    pub fn meaning(&self) -> Meaning {
        match &self.observer {
            Some(observer) if observer.kind == ObserverKind::Xyz => Meaning::Xyz,
            Some(_) => Meaning::Receptors,
            None if self.weights.is_empty() => Meaning::LinearSrgb,
            None => Meaning::Spectrum,
        }
    }

    /// The channels of frames under these lights, from the channel `first` on at most `count`.
    pub(crate) fn channels(
        &self,
        lights: &[Light],
        photometric: bool,
        white: White,
        (first, count): (usize, usize),
    ) -> Channels {
        let white = self.white(lights, white).unwrap_or_default();
        Channels {
            meaning: self.meaning(),
            observer: self.observer.as_ref().map(|observer| observer.name.clone()),
            names: self.channel_names().into_iter().skip(first).take(count).collect(),
            white: white.into_iter().skip(first).take(count).collect(),
            scale: if photometric { Scale::Luminance } else { Scale::Classic },
        }
    }
}

/// A white as an observer sees it, and as its reference sees it, in the channels of frames.
///
/// ```
/// use glanz_render::OwnWhite;
///
/// // An old eye gets less in S; adapted by half, half of that in ratios is made up for.
/// let white = OwnWhite { own: vec![0.8, 0.76, 0.49], reference: vec![0.8, 0.76, 1.0], adapted: 0.5 };
/// assert_eq!(white.gains().map(|gain| (gain * 100.0).round()).collect::<Vec<_>>(), [100.0, 100.0, 143.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct OwnWhite {
    /// As the observer sees it.
    pub own: Vec<f64>,
    /// As its reference sees it.
    pub reference: Vec<f64>,
    /// How far the observer is adapted to it, from 0 to 1.
    pub adapted: f64,
}

impl OwnWhite {
    /// By what each channel is multiplied: von Kries, from the observer's white to its reference's, by the degree of adaptation. 1
    /// where a channel does not see the white.
    pub fn gains(&self) -> impl Iterator<Item = f64> {
        self.own.iter().zip(&self.reference).map(|(own, reference)| {
            let whole = reference / own;
            let seen = whole.is_finite() && whole > 0.0 && self.adapted > 0.0;
            if seen { libm::pow(whole, self.adapted) } else { 1.0 }
        })
    }
}

/// The lights that make a white.
fn white_lights(lights: &[Light], white: White) -> Result<Vec<LightColor>, ObservationError> {
    let colors: Vec<LightColor> = match white {
        White::Scene => lights.iter().map(own_color).cloned().collect(),
        White::Light => first_light(lights).cloned().into_iter().collect(),
        White::D65 | White::None => {
            vec![LightColor::Spectrum(std::sync::Arc::new(rgb_spectra::daylight()))]
        }
    };
    match colors.iter().all(LightColor::is_black) {
        true => Err(ObservationError::NoWhite { white: white.name(), expected: "a light in the scene" }),
        false => Ok(colors),
    }
}

fn white_under(sampling: &Sampling, lights: &[LightColor]) -> Triple {
    let rows: Vec<Row> = lights.iter().map(|light| sampling.light(light)).collect();
    let response = sampling.response(&Surface::Reflectance(vec![1.0; rows[0].len()]), None);
    let mut sum = [0.0; 3];
    for row in &rows {
        sum.iter_mut().zip(response.under(row)).for_each(|(sum, value)| *sum += value);
    }
    sum
}

/// The colour of the first light that sends any, those with a direction before ambient ones.
fn first_light(lights: &[Light]) -> Option<&LightColor> {
    let lit = |ambient: bool| {
        let lights = lights.iter().filter(move |light| (light.kind == LightKind::Ambient) == ambient);
        lights.map(own_color).find(|color| !color.is_black())
    };
    lit(false).or_else(|| lit(true))
}

/// The colour by which a light counts towards the white.
fn own_color(light: &Light) -> &LightColor {
    match light.kind {
        LightKind::Ambient => &light.colors.ambient,
        _ => &light.colors.diffuse,
    }
}

/// What XYZ each channel stands for, by least squares over the curves of CIE 1931; of an observer with a reference, what
/// it stands for to the reference.
///
/// Observers in XYZ are taken as they are, a single channel is a grey. A sensor whose curves are linear
/// combinations of those of CIE 1931 comes out exactly. Receptors beyond L, M, S, which are rods, have no colour.
pub(super) struct ToXyz {
    columns: Vec<[f64; 3]>,
}

impl ToXyz {
    pub(super) fn new(observer: &Observer) -> Self {
        let weights = scaled(observer.reference.as_deref().unwrap_or(observer));
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let white = rgb_spectra::SCREEN_WHITE;
        match (observer.kind, weights.len()) {
            (ObserverKind::Xyz, _) => Self { columns: units.to_vec() },
            (_, 1) => Self { columns: vec![white] },
            (ObserverKind::Lms, count) => {
                let cones = &weights[..count.min(3)];
                let mut columns = least_squares(cones, &scaled(&cie1931()));
                columns.resize(count, [0.0; 3]);
                Self { columns }
            }
            _ => Self { columns: least_squares(&weights, &scaled(&cie1931())) },
        }
    }

    /// What one unit of a channel stands for.
    pub(super) fn column(&self, channel: usize) -> [f64; 3] {
        self.columns.get(channel).copied().unwrap_or_default()
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
